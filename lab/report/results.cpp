// SPDX-License-Identifier: MIT
#include "lab/report/results.h"

#include <fmt/format.h>

#include <cmath>

#include "lab/capture/capture_error.h"
#include "lab/capture/strict_json.h"
#include "lab/metrics/flip.h"
#include "reprise/reprise.h"

namespace reprise::lab {
namespace {

// JSON knows no NaN: null is "not defined here".
OrderedJson number(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson();
}

OrderedJson meanJson(const std::optional<MeanFigures>& mean) {
  if (!mean.has_value()) return OrderedJson();
  return {{"frames", mean->frames},
          {"psnr", number(mean->psnr)},
          {"psnr_of_mean", number(mean->psnr_of_mean)},
          {"ssim", number(mean->ssim)},
          {"flip", number(mean->flip)},
          {"flip30", number(mean->flip30)},
          {"tpsnr", number(mean->tpsnr)},
          {"sharpness", number(mean->sharpness)}};
}

OrderedJson passesJson(const std::vector<std::pair<std::string, double>>& passes) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [name, ms] : passes) json[name] = number(ms);
  return json;
}

OrderedJson runJson(const RunResult& run) {
  OrderedJson json;
  json["source"] = run.source;
  json["technique"] = run.technique;
  json["settings"] = OrderedJson::object();
  for (const auto& [name, value] : run.settings) json["settings"][name] = value;
  json["reference"] = {{"samples", run.reference_samples}, {"filter", run.reference_filter}};
  json["mean"] = meanJson(run.figures.mean);
  json["still"] = meanJson(run.figures.still);
  json["moving"] = meanJson(run.figures.moving);
  json["frames"] = OrderedJson::array();
  for (const FrameFigures& frame : run.figures.frames) {
    json["frames"].push_back({{"frame", frame.frame},
                              {"counted", frame.counted},
                              {"still", frame.still},
                              {"psnr", number(frame.psnr)},
                              {"ssim", number(frame.ssim)},
                              {"flip", number(frame.flip)},
                              {"flip30", number(frame.flip30)},
                              {"tpsnr", number(frame.tpsnr)},
                              {"sharpness", number(frame.sharpness)}});
  }
  json["cost"] = {{"gpu_ms",
                   {{"median", number(run.cost.median_ms)},
                    {"passes", passesJson(run.cost.passes_ms)},
                    {"render", passesJson(run.cost.render_ms)}}},
                  {"shading_evaluations_per_pixel", run.cost.shading_evaluations_per_pixel},
                  {"history_bytes", run.cost.history_bytes}};
  return json;
}

}  // namespace

OrderedJson resultsJson(const Results& results) {
  OrderedJson json;
  json["version"] = 1;
  json["command"] = results.command;
  json["reprise"] = repriseGetVersion();
  json["device"] = {{"name", results.device}, {"driver", results.driver}};
  json["extent"] = {results.extent[0], results.extent[1]};
  json["display"] = "x/(1+x), power 1/2.2";
  json["flip_pixels_per_degree"] = {{"flip", kFlipPixelsPerDegree},
                                    {"flip30", kFlipNearPixelsPerDegree}};
  json["warm_up_frames"] = kWarmUpFrames;
  json["runs"] = OrderedJson::array();
  for (const RunResult& run : results.runs) json["runs"].push_back(runJson(run));
  return json;
}

std::string resultsCsv(const Results& results) {
  std::string csv = "source,technique,frame,counted,still,psnr,ssim,flip,flip30,tpsnr,sharpness\n";
  for (const RunResult& run : results.runs) {
    for (const FrameFigures& f : run.figures.frames) {
      const auto cell = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string();
      };
      csv += fmt::format("\"{}\",\"{}\",{},{},{},{},{},{},{},{},{}\n", run.source, run.technique,
                         f.frame, f.counted ? 1 : 0, f.still ? 1 : 0, cell(f.psnr), cell(f.ssim),
                         cell(f.flip), cell(f.flip30), cell(f.tpsnr), cell(f.sharpness));
    }
  }
  return csv;
}

BaselineCheck checkBaseline(const Results& results, const std::string& baseline_text,
                            const std::string& file, double max_drop_db) {
  const nlohmann::json baseline = parseJson(baseline_text, file);
  BaselineCheck check;
  if (!baseline.is_object() || !baseline.contains("runs") || !baseline["runs"].is_array()) {
    throw CaptureError(file, "runs", "is missing: no results.json of a comparison");
  }
  for (const nlohmann::json& old : baseline["runs"]) {
    const auto text = [&](const char* key) {
      if (!old.is_object() || !old.contains(key) || !old[key].is_string()) {
        throw CaptureError(file, std::string("runs[].") + key, "is missing");
      }
      return old[key].get<std::string>();
    };
    const std::string source = text("source");
    const std::string technique = text("technique");
    const auto psnr = old.value(nlohmann::json::json_pointer("/mean/psnr"), nlohmann::json());
    if (!psnr.is_number()) throw CaptureError(file, "runs[].mean.psnr", "is missing");
    const RunResult* run = nullptr;
    for (const RunResult& candidate : results.runs) {
      if (candidate.source == source && candidate.technique == technique) run = &candidate;
    }
    if (run == nullptr || !run->figures.mean.has_value()) {
      check.failures.push_back(
          fmt::format("{} {}: in the baseline, not compared now", source, technique));
      continue;
    }
    ++check.compared;
    const double drop = psnr.get<double>() - run->figures.mean->psnr;
    if (drop > max_drop_db) {
      check.failures.push_back(
          fmt::format("{} {}: PSNR {:.2f} dB is {:.2f} dB below the baseline's {:.2f} dB", source,
                      technique, run->figures.mean->psnr, drop, psnr.get<double>()));
    }
  }
  return check;
}

}  // namespace reprise::lab
