// SPDX-License-Identifier: MIT
#include "verbs.h"

namespace reprise::app {

void addVerbs(CLI::App& app, const Globals& globals, Action& action) {
  addList(app, globals, action);
  addRender(app, globals, action);
  addFilter(app, globals, action);
  addCompare(app, globals, action);
  addBench(app, globals, action);
  addPaper(app, globals, action);
  addTune(app, globals, action);
}

}  // namespace reprise::app
