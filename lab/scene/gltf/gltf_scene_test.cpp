// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "lab/capture/temporary_directory.h"
#include "lab/scene/gltf/made_up_gltf.h"
#include "lab/scene/gltf/scene_file_error.h"

namespace reprise::lab {
namespace {

using Json = MadeUpGltf::Json;
constexpr float kPi = 3.14159265f;

class GltfScenes : public testing::Test {
 protected:
  std::string runOf(const MadeUpGltf& made, const std::string& camera = "path") const {
    return "gltf:" + made.save(directory.path()).string() + "/" + camera;
  }
  std::unique_ptr<Scene> open(const MadeUpGltf& made) const {
    return parseSceneRun(runOf(made)).scene->create();
  }
  // The one line, without the file's name; empty where it opens.
  std::string refusal(const MadeUpGltf& made) const {
    try {
      open(made);
    } catch (const SceneFileError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      const std::string file = (directory.path() / "a.gltf").string() + ": ";
      EXPECT_EQ(line.substr(0, file.size()), file);
      return line.substr(file.size());
    }
    return "";
  }

  TemporaryDirectory directory;
};

MadeUpGltf oneQuad() {
  MadeUpGltf made;
  made.node({{"mesh", made.quad()}});
  return made;
}

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance = 1.0e-5f) {
  EXPECT_LT(glm::distance(a, b), tolerance) << "(" << a.x << " " << a.y << " " << a.z << ") and ("
                                            << b.x << " " << b.y << " " << b.z << ")";
}

TEST_F(GltfScenes, StillNodesArePlacedByTheirParents) {
  MadeUpGltf made;
  const int mesh = made.quad();
  made.node({{"translation", {10, 0, 0}}, {"children", {1}}});
  // A quarter turn about y, then stretched: +z becomes +x.
  const float h = std::sqrt(0.5f);
  made.node({{"rotation", {0, h, 0, h}}, {"scale", {1, 3, 5}}, {"mesh", mesh}});
  const auto scene = open(made);
  const Geometry& g = scene->geometry();
  ASSERT_EQ(g.instances.size(), 1u);
  EXPECT_EQ(g.indices.size(), 6u);
  EXPECT_EQ(scene->transform(0, 0.3), glm::mat4(1.0f));
  expectNear(glm::vec3(g.vertices[0].position_u), {10, -3, 1});
  expectNear(glm::vec3(g.vertices[0].normal_v), {1, 0, 0});
  EXPECT_EQ(g.vertices[0].position_u.w, 0.0f);
  EXPECT_EQ(g.vertices[0].normal_v.w, 1.0f);
}

TEST_F(GltfScenes, NormalsStayUprightUnderUnevenScale) {
  MadeUpGltf made;
  const int mesh = made.quad();
  const float h = std::sin(kPi / 8.0f);
  const float w = std::cos(kPi / 8.0f);
  // Turned by 45 degrees about y, then squeezed along x by its parent.
  made.node({{"scale", {0.25, 1, 1}}, {"children", {1}}});
  made.node({{"rotation", {0, h, 0, w}}, {"mesh", mesh}});
  const auto scene = open(made);
  const Geometry& g = scene->geometry();
  const glm::vec3 edge(g.vertices[1].position_u - g.vertices[0].position_u);
  EXPECT_NEAR(glm::dot(edge, glm::vec3(g.vertices[0].normal_v)), 0.0f, 1.0e-5f);
}

TEST_F(GltfScenes, AnimationsFollowTheirSamplers) {
  MadeUpGltf made;
  const int mesh = made.quad();
  made.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  for (int i = 0; i < 4; ++i) made.node({{"mesh", mesh}});
  const int times = made.scalars({0, 1, 2});
  const float h = std::sqrt(0.5f);
  const auto animate = [&](int node, const char* path, int output, const char* interpolation) {
    Json sampler{{"input", times}, {"output", output}, {"interpolation", interpolation}};
    made.json["animations"].push_back(
        {{"samplers", {sampler}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
  };
  animate(0, "translation", made.vec3({0, 0, 0, 4, 0, 0, 4, 2, 0}), "LINEAR");
  animate(1, "translation", made.vec3({1, 0, 0, 2, 0, 0, 3, 0, 0}), "STEP");
  animate(2, "rotation",
          made.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, h, h, 0, 0, 1, 0}, 5126, "VEC4", 4),
          "LINEAR");
  // x = t^3: values 0, 1, 8 with slopes 0, 3, 12.
  animate(3, "translation", made.vec3({0, 0, 0, 0, 0,  0, 0, 0, 0, 3, 0,  0, 1, 0,
                                       0, 3, 0, 0, 12, 0, 0, 8, 0, 0, 12, 0, 0}),
          "CUBICSPLINE");
  const auto scene = open(made);
  ASSERT_EQ(scene->geometry().instances.size(), 4u);
  const auto moved = [&](uint32_t instance, double t, glm::vec3 p = glm::vec3(0.0f)) {
    return glm::vec3(scene->transform(instance, t) * glm::vec4(p, 1.0f));
  };
  expectNear(moved(0, 0.5), {2, 0, 0});
  expectNear(moved(0, 1.5), {4, 1, 0});
  expectNear(moved(0, 2.5), {2, 0, 0});  // over again
  expectNear(moved(1, 0.99), {1, 0, 0});
  expectNear(moved(1, 1.01), {2, 0, 0});
  expectNear(moved(2, 0.5, {1, 0, 0}), {std::cos(kPi / 4), std::sin(kPi / 4), 0});
  expectNear(moved(2, 1.5, {1, 0, 0}), {std::cos(0.75f * kPi), std::sin(0.75f * kPi), 0});
  expectNear(moved(3, 0.5), {0.125f, 0, 0});
  expectNear(moved(3, 1.5), {3.375f, 0, 0});
}

TEST_F(GltfScenes, AccessorsOfEveryKind) {
  MadeUpGltf made;
  const int quad = made.quad();
  Json& attributes = made.json["meshes"][0]["primitives"][0]["attributes"];
  // KHR_mesh_quantization: shorts that stand for [-1, 1], every vertex 8 bytes.
  const int positions = made.accessor(std::vector<int16_t>{-32767, -32767, 0, 7, 32767, -32767, 0,
                                                           7, 32767, 32767, 0, 7, 0, 0, 0, 7},
                                      5122, "VEC3", 4);
  made.json["accessors"][positions]["normalized"] = true;
  made.json["bufferViews"].back()["byteStride"] = 8;
  // The last vertex comes from the sparse part.
  const auto index = std::vector<uint8_t>{3};
  const int at = made.accessor(index, 5121, "SCALAR", 1);
  const int values = made.accessor(std::vector<int16_t>{-32767, 32767, 0, 0}, 5122, "SCALAR", 1);
  made.json["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices",
       {{"bufferView", at == 0 ? 0 : made.json["accessors"][at]["bufferView"].get<int>()},
        {"componentType", 5121}}},
      {"values", {{"bufferView", made.json["accessors"][values]["bufferView"].get<int>()}}}};
  attributes["POSITION"] = positions;
  made.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  made.node({{"mesh", quad}});
  const auto scene = open(made);
  const Geometry& g = scene->geometry();
  expectNear(glm::vec3(g.vertices[0].position_u), {-1, -1, 0});
  expectNear(glm::vec3(g.vertices[3].position_u), {-1, 1, 0});
}

TEST_F(GltfScenes, StripsFansAndFlatNormals) {
  for (const int mode : {5, 6}) {
    MadeUpGltf made;
    Json primitive;
    const int positions = mode == 5 ? made.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
                                    : made.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    primitive["attributes"] = {{"POSITION", positions}};
    primitive["mode"] = mode;
    made.json["meshes"].push_back({{"primitives", {primitive}}});
    made.node({{"mesh", 0}});
    const auto scene = open(made);
    const Geometry& g = scene->geometry();
    ASSERT_EQ(g.indices.size(), 6u);
    EXPECT_EQ(g.vertices.size(), 6u);  // corners of their own
    // Both triangles wind as the first does.
    for (const GpuVertex& v : g.vertices) expectNear(glm::vec3(v.normal_v), {0, 0, 1});
  }
}

TEST_F(GltfScenes, MaterialsBecomeTheLabs) {
  MadeUpGltf made;
  const int picture = made.texture(plainPicture(4, 2, {1.0f, 0.5f, 0.25f}));
  const int small = made.texture(plainPicture(2, 2, {0.5f, 0.0f, 0.0f}));
  made.json["materials"] = Json::array(
      {{{"name", "all"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.5, 0.25, 1, 0.8}},
          {"metallicFactor", 0.3},
          {"roughnessFactor", 0.7},
          {"baseColorTexture", {{"index", picture}}},
          {"metallicRoughnessTexture", {{"index", picture}}}}},
        {"normalTexture", {{"index", picture}, {"scale", 0.5}}},
        {"occlusionTexture", {{"index", small}, {"strength", 0.5}}},
        {"emissiveFactor", {1, 0.5, 0}},
        {"alphaMode", "MASK"},
        {"alphaCutoff", 0.4},
        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}},
       {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.3}}}}},
       {{"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.4, 0.6, 1}}}},
        {"extensions", {{"KHR_materials_unlit", Json::object()}}}}});
  made.json["scenes"][0]["nodes"] = {0, 1, 2};
  for (int i = 0; i < 3; ++i) made.node({{"mesh", made.quad(i)}});
  const auto scene = open(made);
  const Geometry& g = scene->geometry();
  // Less than half covered and without a picture: nothing is left of the second quad.
  ASSERT_EQ(g.instances.size(), 2u);
  const GpuMaterial& all = g.materials[g.instances[0].material];
  EXPECT_EQ(all.kind, kMaterialTextured);
  EXPECT_EQ(all.parameters, glm::vec4(0.5f, 0.25f, 1.0f, 0.7f));
  EXPECT_EQ(all.emission, glm::vec4(4.0f, 2.0f, 0.0f, 0.3f));
  EXPECT_FLOAT_EQ(all.alpha_cutoff, 0.5f);  // 0.4 / 0.8
  EXPECT_EQ(all.normal_scale, 0.5f);
  const SceneImage& color = g.images[all.color_texture - 1];
  EXPECT_EQ(color.role, ImageRole::kColor);
  EXPECT_EQ(color.width, 4u);
  EXPECT_EQ(color.alpha_cutoff, all.alpha_cutoff);
  EXPECT_EQ(color.rgba[1], 128);
  EXPECT_EQ(g.images[all.normal_texture - 1].role, ImageRole::kNormal);
  const SceneImage& surface = g.images[all.surface_texture - 1];
  ASSERT_EQ(surface.width, 4u);
  EXPECT_EQ(surface.rgba[0], 192);  // occlusion 0.5 at half strength
  EXPECT_EQ(surface.rgba[1], 128);
  EXPECT_EQ(surface.rgba[2], 64);
  const GpuMaterial& unlit = g.materials[g.instances[1].material];
  EXPECT_EQ(glm::vec3(unlit.parameters), glm::vec3(0.0f));
  EXPECT_EQ(unlit.emission, glm::vec4(0.2f, 0.4f, 0.6f, 1.0f));
}

TEST_F(GltfScenes, TextureTransformsMoveCoordinates) {
  MadeUpGltf made;
  const int picture = made.texture(plainPicture(2, 2, {1, 1, 1}));
  made.json["extensionsRequired"] = {"KHR_texture_transform"};
  made.json["materials"] = Json::array(
      {{{"pbrMetallicRoughness",
         {{"baseColorTexture",
           {{"index", picture},
            {"extensions",
             {{"KHR_texture_transform",
               {{"offset", {0.5, 0.25}}, {"rotation", kPi / 2}, {"scale", {2, 4}}}}}}}}}}}});
  made.node({{"mesh", made.quad(0)}});
  const auto scene = open(made);
  // The extension's matrices for uv (1, 0): scaled (2, 0), turned (0, -2), moved (0.5, -1.75).
  const GpuVertex& v = scene->geometry().vertices[2];
  EXPECT_NEAR(v.position_u.w, 0.5f, 1e-5f);
  EXPECT_NEAR(v.normal_v.w, -1.75f, 1e-5f);
}

TEST_F(GltfScenes, LightsAreTheFilesOrDaylight) {
  const auto day = open(oneQuad());
  ASSERT_EQ(day->lights(0.0).lights.size(), 1u);
  EXPECT_EQ(day->lights(0.0).lights[0].kind, kLightSun);
  EXPECT_EQ(day->lights(0.0).lights[0].direction_world.w, 1.0f);

  MadeUpGltf made;
  made.json["scenes"][0]["nodes"] = {0, 1, 2};
  made.node({{"mesh", made.quad()}});
  made.json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "point"}, {"intensity", 5000}, {"color", {1, 0.5, 0.25}}},
                   {{"type", "spot"},
                    {"intensity", 800},
                    {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}}});
  made.json["extensionsUsed"] = {"KHR_lights_punctual"};
  const auto lamp = [](int light) { return Json{{"KHR_lights_punctual", {{"light", light}}}}; };
  made.node({{"translation", {0, 0, 3}}, {"extensions", lamp(0)}});
  made.node({{"translation", {0, 2, 0}},
             {"rotation", {-std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)}},
             {"extensions", lamp(1)}});
  const auto scene = open(made);
  const SceneLights lights = scene->lights(0.0);
  ASSERT_EQ(lights.lights.size(), 2u);
  EXPECT_EQ(lights.lights[0].kind, kLightPoint);
  expectNear(glm::vec3(lights.lights[0].position_world), {0, 0, 3});
  EXPECT_NEAR(lights.lights[0].color.g / lights.lights[0].color.r, 0.5f, 1e-5f);
  // One exposure for all lights: ratios stay.
  EXPECT_NEAR(lights.lights[1].color.r / lights.lights[0].color.r, 0.16f, 1e-4f);
  EXPECT_EQ(lights.lights[1].kind, kLightCone);
  expectNear(glm::vec3(lights.lights[1].direction_world), {0, -1, 0});
  EXPECT_NEAR(lights.lights[1].cone_cosines.y, std::cos(0.4f), 1e-6f);
  // The quad's corners see the lamp at (0, 0, 3): what they show is as bright as asked.
  const float distance = std::sqrt(11.0f);
  const float luminance =
      glm::dot(glm::vec3(lights.lights[0].color), glm::vec3(0.2126f, 0.7152f, 0.0722f));
  EXPECT_NEAR(luminance * 3.0f / (distance * distance * distance), 1.5f, 1e-3f);
}

TEST_F(GltfScenes, CamerasAreTheFilesAndOurs) {
  MadeUpGltf made = oneQuad();
  made.json["scenes"][0]["nodes"] = {0, 1, 2};
  made.json["cameras"] =
      Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.01}}}}});
  made.node({{"camera", 0}, {"name", "Main: 1/2"}, {"translation", {0, 0, 7}}});
  made.node({{"camera", 0}, {"name", "Main: 1/2"}, {"translation", {0, 0, 9}}});
  const SceneRun run = parseSceneRun(runOf(made, "camera:Main: 1/2"));
  const auto scene = run.scene->create();
  CameraPose pose = scene->camera(run.camera->name, run.values, 0.0, 64);
  expectNear(pose.eye_world, {0, 0, 7});
  expectNear(pose.target_world, {0, 0, 6});
  EXPECT_EQ(pose.vertical_fov, 0.5f);
  const SceneRun second = parseSceneRun(runOf(made, "camera:Main: 1/2'"));
  expectNear(scene->camera(second.camera->name, {}, 0.0, 64).eye_world, {0, 0, 9});

  const SceneRun view = parseSceneRun(runOf(made, "view:ez=5,ey=0,ty=0,tz=0,speed=2,turn=90"));
  pose = scene->camera("view", view.values, 1.0, 64);
  expectNear(pose.eye_world, {2, 0, 5});
  expectNear(pose.target_world, {3, 0, 5});

  EXPECT_TRUE(parseSceneRun(runOf(made, "still")).camera->frozen_at_s.has_value());
  for (const char* wrong : {"", "camera:Other", "pth", "view:qx=1", "view:ex=inf"}) {
    EXPECT_THROW(parseSceneRun(runOf(made, wrong)), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(parseSceneRun("gltf:house.obj/path"), std::invalid_argument);
  EXPECT_THROW(parseSceneRun("gltf:nowhere/house.glb/path"), SceneFileError);
  EXPECT_TRUE(namesScene("gltf:nowhere/house.glb/path"));
}

TEST_F(GltfScenes, AFolderMayBeNamedLikeAFile) {
  const auto folder = directory.path() / "old.gltf";
  std::filesystem::create_directory(folder);
  const std::string file = oneQuad().save(folder).string();
  const GltfName name = splitGltfName("gltf:" + file + "/path:x=1");
  EXPECT_EQ(name.path, file);
  EXPECT_EQ(name.camera, "path:x=1");
}

TEST_F(GltfScenes, BinaryFilesAreTheSame) {
  MadeUpGltf made = oneQuad();
  const auto path = directory.path() / "a.GLB";
  std::ofstream(path, std::ios::binary) << made.glb();
  const auto binary = parseSceneRun("gltf:" + path.string() + "/path").scene->create();
  const auto text = open(made);
  ASSERT_EQ(binary->geometry().vertices.size(), text->geometry().vertices.size());
  EXPECT_EQ(std::memcmp(binary->geometry().vertices.data(), text->geometry().vertices.data(),
                        text->geometry().vertices.size() * sizeof(GpuVertex)),
            0);
}

TEST_F(GltfScenes, WhatIsLeftOutIsSaid) {
  MadeUpGltf made = oneQuad();
  made.json["extensionsUsed"] = {"KHR_materials_sheen"};
  made.json["images"] = Json::array({{{"uri", "gone.png"}}});
  made.json["textures"] = Json::array({{{"source", 0}}});
  made.json["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  made.json["meshes"][0]["primitives"][0]["material"] = 0;
  made.json["meshes"][0]["weights"] = {0.5};
  const std::vector<std::string> warnings = open(made)->warnings();
  EXPECT_EQ(warnings, (std::vector<std::string>{"extension KHR_materials_sheen is left out",
                                                "image 0 (gone.png) is missing: white instead",
                                                "morph targets are left out"}));
}

TEST_F(GltfScenes, DamageIsRefusedInOneLine) {
  EXPECT_EQ(refusal(oneQuad()), "");
  const auto broken = [&](const char* pointer, const Json& value) {
    MadeUpGltf made = oneQuad();
    made.json[Json::json_pointer(pointer)] = value;
    return refusal(made);
  };
  EXPECT_EQ(broken("/extensionsRequired", {"KHR_draco_mesh_compression"}),
            "needs the extension KHR_draco_mesh_compression, unknown here");
  EXPECT_EQ(broken("/asset/version", "1.0"), "glTF version '1.0'; version 2 is needed");
  EXPECT_EQ(broken("/nodes/0/mesh", 9), "mesh 9 does not exist");
  EXPECT_EQ(broken("/nodes/0/children", {0}), "nodes hang on each other in a ring");
  EXPECT_EQ(broken("/nodes/0/rotation", {0, 1}), "a node's rotation has the wrong length");
  EXPECT_EQ(broken("/bufferViews/0/byteLength", 47), "accessor 0 goes beyond its buffer view");
  EXPECT_EQ(broken("/bufferViews/0/byteOffset", 4000), "buffer view 0 goes beyond its buffer");
  EXPECT_EQ(broken("/accessors/0/count", 5), "accessor 0 goes beyond its buffer view");
  EXPECT_EQ(broken("/accessors/0/type", "VEC2"), "accessor 0 has the wrong type");
  EXPECT_EQ(broken("/accessors/1/count", 3),
            "NORMAL of a mesh has not as many elements as POSITION");
  EXPECT_EQ(broken("/accessors/0/count", 3),
            "NORMAL of a mesh has not as many elements as "
            "POSITION");
  EXPECT_EQ(broken("/meshes/0/primitives/0/mode", 1), "holds no triangles that can be shown");
  EXPECT_EQ(broken("/scene", 4), "scene 4 does not exist");
  EXPECT_EQ(broken("/nodes/0/scale", {1.0e30, 1.0, 1.0}),
            "a vertex lies farther away than can be rendered");
  MadeUpGltf infinite = oneQuad();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(infinite.bytes.data(), &nan, sizeof(nan));
  EXPECT_EQ(refusal(infinite), "accessor 0 holds a value that is not finite");
  MadeUpGltf index = oneQuad();
  const size_t at = index.json["bufferViews"][3]["byteOffset"];
  index.bytes[at] = 77;
  EXPECT_EQ(refusal(index), "a mesh's index goes beyond its vertices");
}

TEST_F(GltfScenes, PathsGoThroughRoomsAndAroundThings) {
  // A thing without any room in it.
  const auto thing = open(oneQuad());
  const CameraPose outside = thing->camera("path", {}, 0.0, 64);
  EXPECT_GT(glm::length(outside.eye_world), 1.5f);
  expectNear(outside.target_world, glm::vec3(0.0f));

  // Four walls and a floor, 16 x 8 x 4 m.
  MadeUpGltf made;
  const int mesh = made.quad();
  const float h = std::sqrt(0.5f);
  made.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  made.node({{"mesh", mesh}, {"translation", {0, 2, -4}}, {"scale", {8, 2, 1}}});
  made.node({{"mesh", mesh}, {"translation", {0, 2, 4}}, {"scale", {8, 2, 1}}});
  made.node({{"mesh", mesh},
             {"translation", {-8, 2, 0}},
             {"rotation", {0, h, 0, h}},
             {"scale", {4, 2, 1}}});
  made.node({{"mesh", mesh},
             {"translation", {8, 2, 0}},
             {"rotation", {0, h, 0, h}},
             {"scale", {4, 2, 1}}});
  made.node({{"mesh", mesh}, {"rotation", {-h, 0, 0, h}}, {"scale", {8, 4, 1}}});
  const auto room = open(made);
  for (double t = 0.0; t < 30.0; t += 0.25) {
    const glm::vec3 eye = room->camera("path", {}, t, 64).eye_world;
    EXPECT_LT(std::abs(eye.x), 7.9f);
    EXPECT_LT(std::abs(eye.z), 3.9f);
    EXPECT_NEAR(eye.y, 1.6f, 0.4f);
  }
}

TEST(GltfFiles, OpenWhereTheyAreGiven) {
  const char* root = std::getenv("REPRISE_DATA");
  const struct {
    const char* file;
    size_t triangles;
  } files[] = {{"sponza/sponza.gltf", 262267},
               {"bistro/bistro.gltf", 873759},
               {"vegetation/vegetation.gltf", 773388}};
  for (const auto& [file, triangles] : files) {
    const std::string path = root == nullptr ? "" : (std::filesystem::path(root) / file).string();
    if (root == nullptr || !std::filesystem::exists(path)) {
      std::printf("skipped: %s is not below REPRISE_DATA\n", file);
      continue;
    }
    const auto scene = parseSceneRun("gltf:" + path + "/path").scene->create();
    EXPECT_EQ(scene->geometry().indices.size() / 3, triangles) << file;
  }
}

}  // namespace
}  // namespace reprise::lab
