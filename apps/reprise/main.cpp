// SPDX-License-Identifier: MIT
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>

#include "globals.h"
#include "lab/capture/capture_error.h"
#include "lab/run/interrupt.h"
#include "lab/run/technique_choice.h"
#include "lab/scene/gltf/scene_file_error.h"
#include "reprise/reprise.hpp"
#include "verbs.h"

namespace reprise::app {
namespace {

void addGlobals(CLI::App& app, Globals& globals) {
  app.add_option(
      "--device", globals.device,
      "GPU by index or by part of its name (default: the first GPU, else the CPU driver)");
  app.add_flag(
      "--validation", globals.validation,
      "run under the Khronos validation layer with synchronization checks; a finding is exit 4");
  app.add_option("--log", globals.log_level, "messages on standard error from this level on")
      ->check(CLI::IsMember({"debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  app.add_flag("--quiet", globals.quiet, "errors only, no progress");
  app.add_flag("--json", globals.json, "one JSON document on standard output, nothing else there");
}

std::string typedCommand(int argc, char** argv) {
  std::string command = "reprise";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

int fail(ExitCode code, const std::string& text) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  spdlog::error("{}", line);
  return code;
}

int run(const Action& action) {
  try {
    return action();
  } catch (const lab::Interrupted&) {
    return fail(kInterrupted, "interrupted; what is written is whole, --resume goes on");
  } catch (const lab::UsageError& error) {
    return fail(kUsage, error.what());
  } catch (const std::invalid_argument& error) {
    return fail(kUsage, error.what());
  } catch (const lab::CaptureError& error) {
    return fail(kInput, error.what());
  } catch (const lab::SceneFileError& error) {
    return fail(kInput, error.what());
  } catch (const ApiError& error) {
    return fail(error.result == REPRISE_ERROR_INVALID_ARGUMENT ? kUsage : kDevice, error.what());
  } catch (const std::exception& error) {
    return fail(kDevice, error.what());
  }
}

int main(int argc, char** argv) {
  Globals globals;
  globals.command = typedCommand(argc, argv);
  Action action;
  CLI::App app(
      "Temporal antialiasing and supersampling: compare techniques on evidence, clean up "
      "rendered sequences.",
      "reprise");
  app.set_version_flag("--version", std::string("reprise ") + repriseGetVersion());
  app.require_subcommand(1);
  // Global options may also stand after the verb.
  app.fallthrough();
  addGlobals(app, globals);
  addVerbs(app, globals, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  startLog(globals);
  lab::catchInterrupts();
  return run(action);
}

}  // namespace
}  // namespace reprise::app

int main(int argc, char** argv) {
  return reprise::app::main(argc, argv);
}
