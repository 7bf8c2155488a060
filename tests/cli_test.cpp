// SPDX-License-Identifier: MIT
//
// The command line as its users meet it: each verb once on a small job, exit codes, errors in one
// line, resumption, the report in a browser.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lab/capture/exr_file.h"
#include "lab/capture/output_file.h"
#include "lab/scene/gltf/made_up_gltf.h"
#include "tests/command_line.h"

namespace reprise::lab {
namespace {

class Cli : public CommandLine {
 protected:
  void renderSmall(const char* extra = "") const {
    const Ran ran = reprise(
        std::string("render chart/pan --size 64x36 --frames 10 --samples 4 --reference -o cap ") +
        extra);
    ASSERT_EQ(ran.code, 0) << ran.error;
  }
};

TEST_F(Cli, ListShowsEverythingAndItsJsonIsOneDocument) {
  const Ran text = reprise("list");
  EXPECT_EQ(text.code, 0) << text.error;
  for (const char* word :
       {"taa", "reprojection", "none", "ss", "brick/pan", "chart/still", "Devices"}) {
    EXPECT_NE(text.out.find(word), std::string::npos) << word;
  }
  const Ran json = reprise("list --json");
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_GE(document["techniques"].size(), 4u);
  EXPECT_GE(document["devices"].size(), 1u);
  EXPECT_NE(reprise("list taa").out.find("from: "), std::string::npos);
}

TEST_F(Cli, CoarseFragmentsNeedADeviceThatHasThem) {
  const auto devices = nlohmann::json::parse(reprise("list --json").out)["devices"];
  const Ran ran = reprise(
      "compare brick/still -t cps --shade-by raster --device 0 --size 32x32 --frames 1 --samples 2 "
      "-o out");
  if (devices[0]["fragment_shading_rate"].get<bool>()) {
    EXPECT_EQ(ran.code, 0) << ran.error;
    return;
  }
  EXPECT_EQ(ran.code, 4);
  EXPECT_NE(ran.error.find("has no VK_KHR_fragment_shading_rate with 2 x 2"), std::string::npos)
      << ran.error;
  // Before references are rendered.
  EXPECT_EQ(ran.error.find("reference"), std::string::npos) << ran.error;
}

TEST_F(Cli, EveryVerbHasHelpWithAnExample) {
  for (const char* verb : {"list", "render", "filter", "compare", "bench", "paper", "tune"}) {
    const Ran ran = reprise(std::string(verb) + " --help");
    EXPECT_EQ(ran.code, 0) << verb;
    EXPECT_NE(ran.out.find("Example: reprise "), std::string::npos) << verb;
  }
  EXPECT_NE(reprise("--version").out.find("reprise 0."), std::string::npos);
}

TEST_F(Cli, WrongUsageIsTwo) {
  const struct {
    const char* arguments;
    const char* message;
  } cases[] = {
      {"", "subcommand"},
      {"filtre", ""},
      {"compare brick/pan -t tae -o x", "there is no technique 'tae'; near: 'taa'"},
      {"compare brick/pan -t taa:alhpa=1 -o x", "near: 'alpha'"},
      {"compare brick/pan -t taa:alpha=7 -o x", "must be a number in [0.001, 1]"},
      {"compare brick/pan -t taa,taa -o x", "named twice"},
      {"compare brick/span -t taa -o x", "near: "},
      {"compare brik/pan -t taa -o x --size 64x36", "brick"},
      {"compare brick/pan -t taa -o x --size 64", "'64' is no extent"},
      {"compare brick/pan -t taa -o x --samples 3 --size 64x36", "--samples must be even"},
      {"render brick/pan -o x --frames 0", "--frames"},
      {"render brick/pan --plan cps -o x --size 64x36", "a capture cannot say"},
      {"render brick/pan --post -o x --size 64x36", "--post shows what --png writes"},
      {"compare brick/pan -t cps --spp 4 --size 16x9 --frames 1 --samples 2 --cache none -o x",
       "no coarse shading"},
      {"tune brick/pan -t taa --over alhpa -o x", "near: 'alpha'"},
      {"tune brick/pan -t taa --over alpha=2:3 -o x", "no range within [0.001, 1]"},
      {"tune brick/pan -t taa --score pnsr -o x", "is none of psnr"},
      {"tune brick/pan -t ss -o x", "nothing to tune"},
      {"tune brick/pan -t taa:alpha=0.5 --over alpha=0.1:0.2 --size 16x9 --frames 1 --samples 2",
       "begins at alpha=0.5, outside"},
      {"--device nonsense compare brick/pan -t taa -o x", ""},
  };
  for (const auto& c : cases) {
    const Ran ran = reprise(c.arguments);
    const int expected = std::string(c.arguments).find("nonsense") != std::string::npos ? 4 : 2;
    EXPECT_EQ(ran.code, expected) << c.arguments << "\n" << ran.error;
    EXPECT_NE(ran.error.find(c.message), std::string::npos) << c.arguments << "\n" << ran.error;
    EXPECT_FALSE(exists("x/results.json"));
  }
}

TEST_F(Cli, GltfFilesAreScenesOfEveryVerb) {
  MadeUpGltf made;
  made.node({{"mesh", made.quad()}});
  made.save(directory.path());
  const Ran list = reprise("list gltf:a.gltf");
  EXPECT_EQ(list.code, 0) << list.error;
  EXPECT_NE(list.out.find("2 triangles"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("gltf:a.gltf/path"), std::string::npos) << list.out;
  EXPECT_NE(reprise("list").out.find("gltf:PATH/camera:NAME"), std::string::npos);
  const Ran compared = reprise(
      "compare gltf:a.gltf/path gltf:a.gltf/view:ez=3 -t taa --size 32x18 --frames 3 --samples 2 "
      "-o cmp");
  EXPECT_EQ(compared.code, 0) << compared.error;
  EXPECT_TRUE(exists("cmp/frames/gltf-a.gltf-path/taa/0002.png"));
  EXPECT_EQ(reprise("render gltf:a.gltf/still --size 16x16 --frames 1 -o cap").code, 0);

  EXPECT_EQ(reprise("render gltf:a.gltf/pth --frames 1 -o x").code, 2);
  const auto expectInput = [&](const std::string& arguments, const std::string& message) {
    const Ran ran = reprise(arguments);
    EXPECT_EQ(ran.code, 3) << arguments << "\n" << ran.error;
    EXPECT_NE(ran.error.find(message), std::string::npos) << arguments << "\n" << ran.error;
    EXPECT_EQ(ran.error.find('\n'), ran.error.size() - 1) << ran.error;
  };
  expectInput("render gltf:gone.glb/path -o x", "gone.glb: no such file");
  made.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  made.save(directory.path());
  expectInput("compare gltf:a.gltf/path -t taa -o x", "a.gltf: needs the extension EXT_meshopt");
  expectInput("list gltf:a.gltf", "a.gltf: needs the extension");
  std::ofstream(path("a.gltf")) << "{\"asset\":";
  expectInput("render gltf:a.gltf/path -o x", "a.gltf: not a glTF 2.0 file that can be read");
}

TEST_F(Cli, BadCapturesAreThreeInOneLine) {
  renderSmall();
  const std::string json = readWholeFile(path("cap/capture.json"));
  const auto expectInput = [&](const std::string& arguments, const char* message) {
    const Ran ran = reprise(arguments);
    EXPECT_EQ(ran.code, 3) << arguments << "\n" << ran.error;
    EXPECT_NE(ran.error.find(message), std::string::npos) << arguments << "\n" << ran.error;
    size_t errors = 0;
    for (size_t at = ran.error.find("error:"); at != std::string::npos;
         at = ran.error.find("error:", at + 1))
      ++errors;
    EXPECT_EQ(errors, 1u) << ran.error;
  };
  expectInput("filter nowhere -o out", "nowhere: there is no such directory");
  std::ofstream(path("cap/capture.json"))
      << std::string(json).replace(json.find("frame_rate"), 10, "frame_rat");
  expectInput("filter cap -o out", "cap/capture.json: frame_rat: unknown key; near: 'frame_rate'");
  std::ofstream(path("cap/capture.json")) << json;
  const auto fifth = directory.path() / "cap/frame_0005.exr";
  const std::string whole = readWholeFile(fifth);
  std::filesystem::resize_file(fifth, 500);
  expectInput("filter cap -o out", "frame_0005.exr");
  EXPECT_TRUE(exists("out/frame_0004.exr"));  // what was written stays
  EXPECT_FALSE(exists("out/frame_0005.exr"));
  std::filesystem::remove(fifth);
  expectInput("filter cap -o out", "frame 5: the file is missing");
  writeOutputFile(fifth, whole);
  std::filesystem::remove(directory.path() / "cap/reference_0003.exr");
  expectInput("compare cap -t none -o cmp", "frame 3: has no reference");
  std::ofstream(path("file")) << "x";
  expectInput("filter cap -o file/below", "cannot be created");
  EXPECT_EQ(reprise("filter cap -o cap").code, 2);  // would overwrite its own input
  EXPECT_EQ(reprise("compare cap -t ss:n=2 -o cmp").code, 2);
  EXPECT_EQ(reprise("filter cap -o out2").code, 0);
}

TEST_F(Cli, FilterKeepsTheFilesAndResumes) {
  renderSmall();
  ASSERT_EQ(reprise("filter cap -t taa -o out --png --quiet").code, 0);
  const ExrImage in = readExr(directory.path() / "cap/frame_0010.exr");
  const ExrImage out = readExr(directory.path() / "out/frame_0010.exr");
  ASSERT_EQ(out.channels.size(), in.channels.size());
  EXPECT_EQ(out.find("depth.Z")->texels, in.find("depth.Z")->texels);
  EXPECT_EQ(out.find("color.R")->type, in.find("color.R")->type);
  EXPECT_NE(out.find("color.R")->texels, in.find("color.R")->texels);
  EXPECT_TRUE(exists("out/frame_0010.png"));

  const std::string ninth = readWholeFile(path("out/frame_0009.exr"));
  std::filesystem::resize_file(directory.path() / "out/frame_0009.exr", 99);
  const Ran resumed = reprise("filter cap -t taa -o out --resume --json");
  EXPECT_EQ(resumed.code, 0) << resumed.error;
  EXPECT_EQ(nlohmann::json::parse(resumed.out)["kept"], 9);
  EXPECT_EQ(readWholeFile(path("out/frame_0009.exr")), ninth);
  EXPECT_EQ(reprise("filter cap -t taa:alpha=0.5 -o out --resume").code, 2);
}

TEST_F(Cli, ScaleMakesLargerFramesOfColourAlone) {
  renderSmall();
  ASSERT_EQ(reprise("filter cap -o out --scale 1.5 --frames 2 --png --quiet").code, 0);
  const ExrImage in = readExr(directory.path() / "cap/frame_0002.exr");
  const ExrImage out = readExr(directory.path() / "out/frame_0002.exr");
  EXPECT_EQ(out.width, in.width * 3 / 2);
  EXPECT_EQ(out.height, in.height * 3 / 2);
  ASSERT_EQ(out.channels.size(), 3u);
  EXPECT_NE(out.find("color.G"), nullptr);
  EXPECT_EQ(reprise("filter cap -t taa -o out2 --scale 2").code, 2);
  EXPECT_EQ(reprise("filter cap -o out2 --scale 0.5").code, 2);
  EXPECT_EQ(reprise("compare cap -t reprise -o out2 --scale 2").code, 2);
  const Ran ran = reprise(
      "compare brick/pan -t none,reprise --scale 2 --size 64x36 --frames 2 --samples 2 -o out3 "
      "--json");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const auto runs = nlohmann::json::parse(ran.out)["runs"];
  EXPECT_FALSE(runs[0]["settings"].contains("input"));
  EXPECT_EQ(runs[1]["settings"]["input"], "32x18");
}

TEST_F(Cli, FilterGuessesWithoutDescriptionAndSaysSo) {
  renderSmall();
  std::filesystem::remove(directory.path() / "cap/capture.json");
  for (int i = 1; i <= 10; ++i) {
    char name[64];
    std::snprintf(name, sizeof(name), "cap/reference_%04d.exr", i);
    std::filesystem::remove(directory.path() / name);
  }
  const Ran ran = reprise("filter cap -o out");
  EXPECT_EQ(ran.code, 0) << ran.error;
  EXPECT_NE(ran.error.find("capture.json is missing; assumed:"), std::string::npos);
  EXPECT_NE(ran.error.find("jitter is not known"), std::string::npos);
  EXPECT_EQ(reprise("filter cap -o out2 --layout blender").code, 3);
}

TEST_F(Cli, VideoIsWrittenOrRefusedInOneLine) {
  renderSmall();
  const bool ffmpeg = std::system("ffmpeg -version >/dev/null 2>&1") == 0;
  const Ran ran = reprise("filter cap -o out --video film.mp4");
  EXPECT_EQ(ran.code, ffmpeg ? 0 : 3) << ran.error;
  EXPECT_EQ(exists("film.mp4"), ffmpeg);
}

TEST_F(Cli, InterruptedIs130AndLeavesWholeFiles) {
  // Signalled once a frame is written, and twice at once, as `timeout -s INT` and a terminal do.
  const Ran ran = shell("(REPRISE_CACHE=none " REPRISE_COMMAND
                        " render brick/pan --size 960x540 --frames 2000 -o cap & p=$!; "
                        "while kill -0 $p && ! ls cap/*.exr; do sleep 0.05; done >/dev/null 2>&1; "
                        "kill -INT $p; sleep 0.05; kill -INT $p; wait $p)");
  EXPECT_EQ(ran.code, 130) << ran.error;
  EXPECT_NE(ran.error.find("interrupted; what is written is whole"), std::string::npos)
      << ran.error;
  EXPECT_FALSE(exists("cap/capture.json"));
  for (const auto& entry : std::filesystem::directory_iterator(directory.path() / "cap")) {
    EXPECT_EQ(entry.path().extension(), ".exr");
    EXPECT_NO_THROW(readExr(entry.path()));
  }
}

TEST_F(Cli, CompareWritesItsResultsAndGatesOnABaseline) {
  const std::string compare =
      "compare chart/pan chart/still -t none,reprojection,taa:alpha=0.1,clip=none,ss:n=2 "
      "--size 64x36 --frames 12 --samples 16 -o cmp";
  const Ran ran = reprise(compare);
  ASSERT_EQ(ran.code, 0) << ran.error;
  EXPECT_NE(ran.out.find("PSNR"), std::string::npos);
  for (const char* name :
       {"cmp/results.json", "cmp/results.csv", "cmp/report.html",
        "cmp/frames/chart-pan/none/0011.png", "cmp/frames/chart-pan/reference/0000.png",
        "cmp/errors/chart-still/ss-n=2/0003.png"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
  const auto results = nlohmann::json::parse(readWholeFile(path("cmp/results.json")));
  ASSERT_EQ(results["runs"].size(), 8u);
  EXPECT_EQ(results["version"], 1);
  EXPECT_EQ(results["extent"], nlohmann::json({64, 36}));
  const auto& run = results["runs"][2];
  EXPECT_EQ(run["technique"], "taa:alpha=0.1,clip=none");
  EXPECT_EQ(run["settings"]["alpha"], 0.1);
  EXPECT_EQ(run["settings"]["clip"], "none");
  EXPECT_EQ(run["reference"]["samples"], 16);
  EXPECT_EQ(run["frames"].size(), 12u);
  EXPECT_EQ(run["mean"]["frames"], 4);
  EXPECT_TRUE(run["still"].is_null());
  EXPECT_TRUE(results["runs"][4]["moving"].is_null());
  EXPECT_GT(run["cost"]["gpu_ms"]["passes"]["resolve"], 0.0);
  EXPECT_GT(run["cost"]["history_bytes"], 0);
  EXPECT_NEAR(results["runs"][3]["cost"]["shading_evaluations_per_pixel"].get<double>(), 4.0, 0.01);

  EXPECT_EQ(reprise(compare + " --baseline cmp/results.json --quiet").code, 0);
  auto raised = results;
  raised["runs"][2]["mean"]["psnr"] = results["runs"][2]["mean"]["psnr"].get<double>() + 0.5;
  std::ofstream(path("raised.json")) << raised.dump();
  const Ran gate = reprise(compare + " --baseline raised.json --max-drop 0.1");
  EXPECT_EQ(gate.code, 1);
  EXPECT_NE(gate.error.find("taa:alpha=0.1,clip=none: PSNR"), std::string::npos) << gate.error;
  EXPECT_EQ(reprise(compare + " --baseline raised.json --max-drop 0.6 --quiet").code, 0);
  EXPECT_EQ(reprise(compare + " --baseline missing.json").code, 3);
  const Ran json = reprise(compare + " --json");
  EXPECT_EQ(nlohmann::json::parse(json.out)["runs"].size(), 8u);
}

TEST_F(Cli, TuneFindsWhatComparesBetter) {
  const std::string scenes = " --size 64x36 --frames 12 --samples 8 ";
  const Ran ran = reprise(
      "tune brick/pan chart/pan -t taa:alpha=1 --over alpha=0.01:1 clip --held-out brick/zoom -o "
      "tuned --evaluations 20 --json" +
      scenes);
  ASSERT_EQ(ran.code, 0) << ran.error;
  const auto found = nlohmann::json::parse(ran.out);
  EXPECT_EQ(found, nlohmann::json::parse(readWholeFile(path("tuned/tune.json"))));
  const auto& sources = found["sources"];
  ASSERT_EQ(sources.size(), 5u) << found.dump(1);
  EXPECT_EQ(sources[2]["source"], "mean");
  EXPECT_EQ(sources[3]["kind"], "held out");
  EXPECT_GT(sources[2]["after"].get<double>(), sources[2]["before"].get<double>() + 1.0);

  // What it prints can be typed, and gives what it says.
  const std::string best = found["technique"];
  EXPECT_EQ(best.rfind("taa:alpha=0.", 0), 0u) << best;
  const Ran compared =
      reprise("compare chart/pan -t taa:alpha=1 " + best + " -o cmp --json" + scenes);
  ASSERT_EQ(compared.code, 0) << compared.error;
  const auto runs = nlohmann::json::parse(compared.out)["runs"];
  EXPECT_DOUBLE_EQ(runs[0]["mean"]["psnr"].get<double>(), sources[1]["before"].get<double>());
  EXPECT_DOUBLE_EQ(runs[1]["mean"]["psnr"].get<double>(), sources[1]["after"].get<double>());

  const Ran none = reprise("tune chart/still -t none --size 16x9 --frames 1 --samples 2");
  EXPECT_EQ(none.code, 2) << none.error;
  const Ran undefined = reprise(
      "tune chart/still -t taa --score disoccluded --size 16x9 --frames 2 --samples 2 "
      "--evaluations 1");
  EXPECT_EQ(undefined.code, 2);
  EXPECT_NE(undefined.error.find("has no value on chart/still"), std::string::npos)
      << undefined.error;
}

TEST_F(Cli, PostStandsBetweenTheTechniqueAndTheDisplay) {
  const char* small = "chart/pan -t none --size 64x36 --frames 4 --samples 4 -o ";
  ASSERT_EQ(reprise(std::string("compare --post ") + small + "with").code, 0);
  ASSERT_EQ(reprise(std::string("compare ") + small + "without").code, 0);
  const auto with = nlohmann::json::parse(readWholeFile(directory.path() / "with/results.json"));
  const auto without =
      nlohmann::json::parse(readWholeFile(directory.path() / "without/results.json"));
  EXPECT_FALSE(with["post"].get<std::string>().empty());
  EXPECT_FALSE(without.contains("post"));
  const auto& run = with["runs"][0];
  EXPECT_EQ(run["cost"]["gpu_ms"]["post"].size(), 4u);
  EXPECT_NE(run["mean"]["psnr"], without["runs"][0]["mean"]["psnr"]);
  ASSERT_EQ(reprise("render chart/pan --size 64x36 --frames 2 --png --post -o shown").code, 0);
  ASSERT_EQ(reprise("render chart/pan --size 64x36 --frames 2 --png -o plain").code, 0);
  EXPECT_EQ(readWholeFile(directory.path() / "shown/frame_0002.exr"),
            readWholeFile(directory.path() / "plain/frame_0002.exr"));
  EXPECT_NE(readWholeFile(directory.path() / "shown/frame_0002.png"),
            readWholeFile(directory.path() / "plain/frame_0002.png"));
}

TEST_F(Cli, MetricsAreChosenAndAMissingTableIsOneLine) {
  const std::string compare =
      "compare chart/still -t none,taa --size 64x36 --frames 17 --samples 4 -o cmp --metrics ";
  EXPECT_EQ(reprise(compare + "ssim,sharpnes").code, 2);
  // Without REPRISE_DATA there is no table: a line, and the rest is measured.
  const Ran without = shell("env -u REPRISE_DATA REPRISE_CACHE=" + path("cache") +
                            " " REPRISE_COMMAND " " + compare + "ssim,residue,convergence,cvvdp");
  EXPECT_EQ(without.code, 0) << without.error;
  EXPECT_NE(without.error.find("ColorVideoVDP is unavailable"), std::string::npos);
  auto run = nlohmann::json::parse(readWholeFile(path("cmp/results.json")))["runs"][1];
  EXPECT_TRUE(run["mean"]["jod"].is_null());
  EXPECT_TRUE(run["mean"]["flip"].is_null());
  EXPECT_TRUE(run["mean"]["ssim"].is_number());
  EXPECT_EQ(run["residue"]["frames"], 9);
  EXPECT_GT(run["residue"]["sigma_mean"], 0.0);
  EXPECT_GE(run["convergence"]["frames"], 1);
  EXPECT_EQ(run["metrics_cpu_s"].size(), 4u);
  std::ofstream(path("table.json")) << "{}";
  const Ran damaged = reprise(compare + "cvvdp --cvvdp-table table.json");
  EXPECT_EQ(damaged.code, 3);
  EXPECT_NE(damaged.error.find("table.json: is no table of ColorVideoVDP"), std::string::npos)
      << damaged.error;
  const char* root = std::getenv("REPRISE_DATA");
  if (root == nullptr || !std::filesystem::exists(std::filesystem::path(root) / "cvvdp"))
    GTEST_SKIP() << "REPRISE_DATA holds no cvvdp";
  ASSERT_EQ(reprise(compare + "cvvdp").code, 0);
  run = nlohmann::json::parse(readWholeFile(path("cmp/results.json")))["runs"][1];
  EXPECT_GT(run["mean"]["jod"], 0.0);
  EXPECT_LT(run["mean"]["jod"], 10.0);
  EXPECT_TRUE(run["frames"][16]["jod"].is_number());
}

TEST_F(Cli, TheReportWorksInABrowser) {
  ASSERT_EQ(
      reprise("compare chart/pan -t none,taa --size 64x36 --frames 10 --samples 16 -o cmp").code,
      0);
  const std::string found = probe(path("cmp/report.html"), REPRISE_CHROMIUM_SCRIPT);
  if (found.empty()) GTEST_SKIP() << "chromium is not installed";
  for (const char* expected :
       {"rows=2", "series=2", "metric=FLIP", "drawn0=none|reference|slider|0|4", "flips=true",
        "drawn1=none|reference|difference|0|4", "drawn2=flip of none|reference|side|9|4",
        "size=true", "flip of taa"}) {
    EXPECT_NE(found.find(expected), std::string::npos) << expected << "\n" << found;
  }
  EXPECT_EQ(found.find("error="), std::string::npos) << found;
}

TEST_F(Cli, BenchTimesEachPass) {
  const Ran ran = reprise("bench -t taa,none --size 64x36 --frames 3 -o b");
  EXPECT_EQ(ran.code, 0) << ran.error;
  EXPECT_NE(ran.out.find("of copy bandwidth"), std::string::npos);
  const auto json = nlohmann::json::parse(readWholeFile(path("b/bench.json")));
  ASSERT_EQ(json["runs"].size(), 2u);
  EXPECT_EQ(json["runs"][0]["passes"][0]["pass"], "resolve");
  EXPECT_GT(json["runs"][0]["bytes_moved_at_least"], 64 * 36 * 36);
  EXPECT_GT(json["copy_bytes_per_second"], 0.0);
}

TEST_F(Cli, ValidationStaysSilent) {
  const Ran ran = reprise(
      "--validation compare brick/pan -t none,reprojection,taa,taa:average=3,sharpen=0.5,ss:n=2 "
      "--size 65x37 --frames 10 --samples 4 -o cmp");
  if (ran.error.find("validation layer") != std::string::npos && ran.code == 4) {
    GTEST_SKIP() << ran.error;
  }
  EXPECT_EQ(ran.code, 0) << ran.error;
}

}  // namespace
}  // namespace reprise::lab
