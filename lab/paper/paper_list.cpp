// SPDX-License-Identifier: MIT
//
// The one list of papers; each is defined in its own folder.
#include "lab/paper/paper.h"

namespace reprise::lab {

Paper amortizedPaper();
Paper cpstPaper();
Paper phlmPaper();

const std::vector<Paper>& paperList() {
  static const std::vector<Paper> list = {
      amortizedPaper(),
      phlmPaper(),
      cpstPaper(),
  };
  return list;
}

std::string itemFolder(const std::string& item) {
  std::string folder = item;
  for (char& c : folder) c = c == ' ' ? '-' : c;
  return folder;
}

}  // namespace reprise::lab
