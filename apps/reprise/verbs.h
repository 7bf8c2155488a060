// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "globals.h"

namespace reprise::app {

// What the parsed verb does; returns an ExitCode.
using Action = std::function<int()>;

// Each adds its subcommand to `app` and sets `action` when that is the one parsed.
void addList(CLI::App& app, const Globals& globals, Action& action);
void addRender(CLI::App& app, const Globals& globals, Action& action);
void addFilter(CLI::App& app, const Globals& globals, Action& action);
void addCompare(CLI::App& app, const Globals& globals, Action& action);
void addBench(CLI::App& app, const Globals& globals, Action& action);
void addPaper(CLI::App& app, const Globals& globals, Action& action);
void addTune(CLI::App& app, const Globals& globals, Action& action);

// The one list of verbs.
void addVerbs(CLI::App& app, const Globals& globals, Action& action);

}  // namespace reprise::app
