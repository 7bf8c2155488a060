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
  OrderedJson json = {{"frames", mean->frames}};
  for (const FigureInfo& figure : kFigures) json[figure.key] = number((*mean).*figure.mean);
  json["psnr_of_mean"] = number(mean->psnr_of_mean);
  return json;
}

OrderedJson agesJson(const std::vector<AgeFigures>& ages) {
  OrderedJson json = OrderedJson::array();
  for (const AgeFigures& age : ages) {
    json.push_back({{"age", age.age}, {"pixels", age.pixels}, {"psnr", number(age.psnr)}});
  }
  return json;
}

OrderedJson convergenceJson(const std::optional<Convergence>& convergence) {
  if (!convergence.has_value()) return OrderedJson();
  return {{"asymptote_psnr", number(convergence->asymptote_db)}, {"frames", convergence->frames}};
}

OrderedJson residueJson(const std::optional<JitterResidue>& residue) {
  if (!residue.has_value()) return OrderedJson();
  return {{"frames", residue->frames},
          {"pixels", residue->pixels},
          {"sigma_mean", number(residue->sigma_mean)},
          {"sigma_p99", number(residue->sigma_p99)},
          {"peak_mean", number(residue->peak_mean)},
          {"peak_p99", number(residue->peak_p99)},
          {"eye_band_rms", number(residue->eye_band_rms)},
          {"strongest_hz", number(residue->strongest_hz)}};
}

OrderedJson namedJson(const std::vector<std::pair<std::string, double>>& values) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [name, value] : values) json[name] = number(value);
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
  json["ages"] = agesJson(run.figures.ages);
  json["convergence"] = convergenceJson(run.figures.convergence);
  json["residue"] = residueJson(run.figures.residue);
  json["frames"] = OrderedJson::array();
  for (const FrameFigures& frame : run.figures.frames) {
    OrderedJson figures = {
        {"frame", frame.frame}, {"counted", frame.counted}, {"still", frame.still}};
    for (const FigureInfo& figure : kFigures) figures[figure.key] = number(frame.*figure.frame);
    json["frames"].push_back(std::move(figures));
  }
  json["metrics_cpu_s"] = namedJson(run.figures.cpu_s);
  json["cost"] = {{"gpu_ms",
                   {{"median", number(run.cost.median_ms)},
                    {"passes", namedJson(run.cost.passes_ms)},
                    {"render", namedJson(run.cost.render_ms)},
                    {"post", namedJson(run.cost.post_ms)}}},
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
  if (!results.post.empty()) json["post"] = results.post;
  json["flip_pixels_per_degree"] = {{"flip", kFlipPixelsPerDegree},
                                    {"flip30", kFlipNearPixelsPerDegree}};
  json["jod_display"] = {{"name", kVdpStandard4k.name},
                         {"pixels_per_degree", kVdpStandard4k.pixels_per_degree}};
  json["warm_up_frames"] = kWarmUpFrames;
  json["runs"] = OrderedJson::array();
  for (const RunResult& run : results.runs) json["runs"].push_back(runJson(run));
  return json;
}

std::string resultsCsv(const Results& results) {
  std::string csv = "source,technique,frame,counted,still";
  for (const FigureInfo& figure : kFigures) csv += fmt::format(",{}", figure.key);
  csv += "\n";
  for (const RunResult& run : results.runs) {
    for (const FrameFigures& f : run.figures.frames) {
      csv += fmt::format("\"{}\",\"{}\",{},{},{}", run.source, run.technique, f.frame,
                         f.counted ? 1 : 0, f.still ? 1 : 0);
      for (const FigureInfo& figure : kFigures) {
        const double value = f.*figure.frame;
        csv += std::isfinite(value) ? fmt::format(",{:.6g}", value) : ",";
      }
      csv += "\n";
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
