// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "lab/paper/paper_run.h"
#include "lab/run/technique_choice.h"
#include "verbs.h"

namespace reprise::app {
namespace {

struct PaperFlags {
  std::string paper;
  std::filesystem::path directory;
  bool full = false;
  bool resume = false;
  std::vector<std::string> items;
  std::string cache;
  // For tests; 0 and "": what the paper's scale says.
  std::string extent;
  uint32_t frames = 0;
  uint32_t samples = 0;
  uint32_t grid = 0;
};

lab::PaperScale scaleOf(const lab::Paper& paper, const PaperFlags& flags) {
  lab::PaperScale scale = flags.full ? paper.full : paper.scale;
  if (!flags.extent.empty()) scale.extent = parseExtent(flags.extent);
  if (flags.frames > 0) scale.frames = scale.still_frames = flags.frames;
  if (flags.samples > 0) scale.samples = scale.still_samples = flags.samples;
  if (flags.grid > 0) scale.grid = flags.grid;
  return scale;
}

// Exit 1 where a claim does not hold would make every rerun at a reduced size a failure: papers
// are reported on, not gated.
int runOne(const Globals& globals, const lab::Paper& paper, const PaperFlags& flags,
           const std::filesystem::path& directory, nlohmann::ordered_json& document) {
  lab::PaperRunOptions options;
  options.command = globals.command;
  options.items = flags.items;
  options.lab.scale = scaleOf(paper, flags);
  options.lab.directory = directory;
  options.lab.cache = flags.cache;
  // The published size takes hours: it goes on where it stopped.
  options.lab.resume = flags.resume || flags.full;
  options.lab.quiet = globals.quiet;
  options.lab.open_device = [&globals] { return openDevice(globals); };
  const lab::PaperScale& s = options.lab.scale;
  globals.print(fmt::format(
      "{}\n{} x {} px, {} frames in motion, {} at rest, references of {} and {} samples a pixel; "
      "published {} x {} px, {} samples{}\n\n",
      paper.citation, s.extent.width, s.extent.height, s.frames, s.still_frames, s.samples,
      s.still_samples, paper.full.extent.width, paper.full.extent.height, paper.full.samples,
      flags.full ? "" : " (--full)"));
  const lab::PaperRun run = lab::runPaper(paper, options, [&](const lab::PaperItem& item) {
    globals.print(lab::itemTable(item) + "\n");
  });
  globals.print(fmt::format("page: {}\n", (directory / "paper.html").string()));
  for (const auto& row : lab::paperJson(run.items)) document.push_back(row);
  for (const std::string& message : run.validation_messages) {
    spdlog::error("validation: {}", message);
  }
  return run.validation_messages.empty() ? kDone : kDevice;
}

int paper(const Globals& globals, const PaperFlags& flags) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  int code = kDone;
  for (const lab::Paper& known : lab::paperList()) {
    if (flags.paper == "all") {
      const int one = runOne(globals, known, flags, flags.directory / known.name, document);
      code = std::max(code, one);
    } else if (flags.paper == known.name) {
      code = runOne(globals, known, flags, flags.directory, document);
    }
  }
  globals.printJson(document);
  return code;
}

}  // namespace

void addPaper(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "paper", "reruns a paper's figures and tables and sets them beside the published numbers");
  auto flags = std::make_shared<PaperFlags>();
  std::vector<std::string> names;
  for (const lab::Paper& known : lab::paperList()) names.push_back(known.name);
  names.push_back("all");
  verb->add_option("PAPER", flags->paper, "which paper; all: each in a folder of its name")
      ->check(CLI::IsMember(names))
      ->required();
  verb->add_option("-o,--output", flags->directory, "directory of paper.html and paper.json")
      ->required();
  verb->add_flag("--full", flags->full,
                 "the published size: hours; goes on where it stopped (default: a reduced size, "
                 "within 15 minutes on two cores)");
  verb->add_flag("--resume", flags->resume, "keeps what an earlier run of the same size finished");
  verb->add_option("--item", flags->items, "only this figure or table, such as 'figure 8'");
  verb->add_option("--cache", flags->cache,
                   "directory of rendered references, or none (default: $REPRISE_CACHE, "
                   "$XDG_CACHE_HOME/reprise, ~/.cache/reprise)");
  verb->add_option("--size", flags->extent)->group("");
  verb->add_option("--frames", flags->frames)->check(CLI::Range(1u, 100000u))->group("");
  verb->add_option("--samples", flags->samples)->check(CLI::Range(2u, 65536u))->group("");
  verb->add_option("--grid", flags->grid)->check(CLI::Range(2u, 64u))->group("");
  verb->footer("Example: reprise paper amortized -o /tmp/amortized");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return paper(globals, *flags); };
  });
}

}  // namespace reprise::app
