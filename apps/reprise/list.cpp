// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lab/run/technique_choice.h"
#include "lab/scene/gltf/gltf_scene.h"
#include "lab/scene/scene.h"
#include "verbs.h"

namespace reprise::app {
namespace {

using Json = nlohmann::ordered_json;

std::string defaultText(const RepriseSettingInfo& setting) {
  switch (setting.type) {
    case REPRISE_SETTING_CHOICE:
      return setting.choices[static_cast<size_t>(setting.default_value)];
    case REPRISE_SETTING_BOOLEAN:
      return setting.default_value != 0.0 ? "true" : "false";
    default:
      return fmt::format("{:g}", setting.default_value);
  }
}

std::string rangeText(const RepriseSettingInfo& setting) {
  if (setting.type == REPRISE_SETTING_BOOLEAN) return "true, false";
  if (setting.type != REPRISE_SETTING_CHOICE) {
    return fmt::format("[{:g}, {:g}]{}{}", setting.minimum, setting.maximum,
                       setting.unit[0] != '\0' ? " " : "", setting.unit);
  }
  std::string all;
  for (uint32_t i = 0; setting.choices[i] != nullptr; ++i) {
    all += (i == 0 ? "" : ", ") + std::string(setting.choices[i]);
  }
  return all;
}

Json techniqueJson(const RepriseTechniqueInfo& info) {
  Json json{{"name", info.name}, {"summary", info.summary}, {"source", info.source}};
  json["settings"] = Json::array();
  for (uint32_t i = 0; i < info.setting_count; ++i) {
    const RepriseSettingInfo& s = info.settings[i];
    json["settings"].push_back({{"name", s.name},
                                {"default", defaultText(s)},
                                {"range", rangeText(s)},
                                {"unit", s.unit},
                                {"effect", s.effect},
                                {"source", s.source}});
  }
  json["presets"] = Json::array();
  for (uint32_t i = 0; i < info.preset_count; ++i) {
    Json values = Json::object();
    for (uint32_t k = 0; k < info.presets[i].value_count; ++k) {
      const RepriseSettingValue& value = info.presets[i].values[k];
      if (value.text != nullptr)
        values[value.name] = value.text;
      else
        values[value.name] = value.value;
    }
    json["presets"].push_back(
        {{"name", info.presets[i].name}, {"purpose", info.presets[i].purpose}, {"values", values}});
  }
  return json;
}

Json sceneJson(const lab::SceneInfo& scene) {
  Json cameras = Json::array();
  for (const lab::CameraInfo& camera : scene.cameras) {
    Json parameters = Json::array();
    for (const lab::CameraParameter& p : camera.parameters) {
      parameters.push_back(
          {{"name", p.name}, {"default", p.default_value}, {"meaning", p.meaning}});
    }
    cameras.push_back(
        {{"name", camera.name}, {"motion", camera.motion}, {"parameters", parameters}});
  }
  return {{"name", scene.name}, {"content", scene.content}, {"cameras", cameras}};
}

// A scene's file read whole: how much it holds, its cameras, what is left out.
Json fileJson(const std::string& text) {
  const auto info = lab::gltfSceneInfo(lab::splitGltfName(text).path);
  const std::unique_ptr<lab::Scene> scene = info->create();
  const lab::Geometry& geometry = scene->geometry();
  Json json = sceneJson(*info);
  json["content"] = fmt::format(
      "{} triangles, {} materials, {} images, {} moving parts, {} lights",
      geometry.indices.size() / 3, geometry.materials.size(), geometry.images.size(),
      std::count_if(geometry.instances.begin(), geometry.instances.end(),
                    [&](const lab::Instance& instance) {
                      const auto i = static_cast<uint32_t>(&instance - geometry.instances.data());
                      return scene->transform(i, 0.0) != scene->transform(i, 0.4);
                    }),
      scene->lights(0.0).lights.size());
  json["warnings"] = scene->warnings();
  return json;
}

Json listJson() {
  Json json;
  json["techniques"] = Json::array();
  for (const RepriseTechniqueInfo* info : lab::allTechniques()) {
    json["techniques"].push_back(techniqueJson(*info));
  }
  json["scenes"] = Json::array();
  std::vector<lab::SceneInfo> scenes = lab::sceneList();
  scenes.push_back(lab::gltfPattern());
  for (const lab::SceneInfo& scene : scenes) json["scenes"].push_back(sceneJson(scene));
  json["devices"] = Json::array();
  size_t index = 0;
  for (const lab::DeviceSummary& device : lab::Device::list()) {
    json["devices"].push_back({{"index", index++},
                               {"name", device.name},
                               {"driver", device.driver},
                               {"type", device.type},
                               {"api", device.api_version},
                               {"usable", device.usable},
                               {"missing", device.missing},
                               {"fragment_shading_rate", device.shading_rate}});
  }
  return json;
}

std::string sceneText(const Json& scene) {
  const std::string name = scene["name"];
  std::string text = fmt::format("  {:<13} {}\n", name, scene["content"].get<std::string>());
  for (const Json& camera : scene["cameras"]) {
    text += fmt::format("    {:<21} {}\n", name + "/" + camera["name"].get<std::string>(),
                        camera["motion"].get<std::string>());
    for (const Json& p : camera["parameters"]) {
      text += fmt::format("      {:<20}= {:<12g}{}\n", p["name"].get<std::string>(),
                          p["default"].get<double>(), p["meaning"].get<std::string>());
    }
  }
  if (!scene.contains("warnings")) return text;
  for (const Json& warning : scene["warnings"]) {
    text += fmt::format("  note: {}\n", warning.get<std::string>());
  }
  return text;
}

std::string listText(const Json& json, const std::string& only) {
  std::string text;
  if (only.empty()) text += "Techniques\n";
  bool found = false;
  for (const Json& technique : json["techniques"]) {
    const auto get = [&](const char* key) { return technique[key].get<std::string>(); };
    if (!only.empty() && only != get("name")) continue;
    found = true;
    text += fmt::format("  {:<14}{} ({})\n", get("name"), get("summary"), get("source"));
    for (const Json& s : technique["settings"]) {
      const auto setting = [&](const char* key) { return s[key].get<std::string>(); };
      text += fmt::format("    {:<20}= {:<12}{}\n", setting("name"), setting("default"),
                          setting("range"));
      if (!only.empty()) {
        text += fmt::format("        {}\n        from: {}\n", setting("effect"), setting("source"));
      }
    }
    for (const Json& preset : technique["presets"]) {
      text += fmt::format("    preset={:<13}  {}\n", preset["name"].get<std::string>(),
                          preset["purpose"].get<std::string>());
    }
  }
  if (!only.empty()) {
    if (!found) lab::parseTechnique(only);  // throws with the near names
    return text;
  }
  text += "\nScenes\n";
  for (const Json& scene : json["scenes"]) text += sceneText(scene);
  text += "\nDevices\n";
  for (const Json& device : json["devices"]) {
    text += fmt::format(
        "  {}: {} ({}, {}, Vulkan {}){}{}\n", device["index"].get<size_t>(),
        device["name"].get<std::string>(), device["type"].get<std::string>(),
        device["driver"].get<std::string>(), device["api"].get<std::string>(),
        device["usable"].get<bool>() ? ""
                                     : " - not usable: " + device["missing"].get<std::string>(),
        device["fragment_shading_rate"].get<bool>() ? ", fragment shading rate" : "");
  }
  if (json["devices"].empty())
    text += "  none: install a Vulkan driver (mesa-vulkan-drivers has a CPU one)\n";
  return text;
}

}  // namespace

void addList(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "list", "techniques with their settings, scenes with their cameras, devices");
  auto only = std::make_shared<std::string>();
  verb->add_option("NAME", *only,
                   "only this technique, with the effect and origin of each setting; or gltf:PATH: "
                   "what the file holds");
  verb->footer("Example: reprise list taa; reprise list gltf:house.glb");
  verb->callback([&globals, &action, only] {
    action = [&globals, only]() -> int {
      if (lab::namesGltf(*only)) {
        const Json json = fileJson(*only);
        globals.print(sceneText(json));
        globals.printJson(json);
        return kDone;
      }
      const Json json = listJson();
      globals.print(listText(json, *only));
      globals.printJson(json);
      return kDone;
    };
  });
}

}  // namespace reprise::app
