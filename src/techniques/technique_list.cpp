// SPDX-License-Identifier: MIT
//
// The one list of techniques. Each entry is defined in its own folder.
#include <cstring>

#include "core/technique.h"

namespace reprise {

extern const TechniqueEntry kAmortizedEntry;
extern const TechniqueEntry kCheckerboardEntry;
extern const TechniqueEntry kCpsEntry;
extern const TechniqueEntry kCpstEntry;
extern const TechniqueEntry kFxaaEntry;
extern const TechniqueEntry kNoneEntry;
extern const TechniqueEntry kPhlmEntry;
extern const TechniqueEntry kRepriseEntry;
extern const TechniqueEntry kReprojectionEntry;
extern const TechniqueEntry kTaaEntry;
extern const TechniqueEntry kUe4TaaEntry;

std::span<const TechniqueEntry> techniqueList() {
  static const TechniqueEntry kList[] = {
      kNoneEntry, kFxaaEntry,      kReprojectionEntry, kUe4TaaEntry,
      kTaaEntry,  kAmortizedEntry, kPhlmEntry,         kRepriseEntry,
      kCpsEntry,  kCpstEntry,      kCheckerboardEntry,
  };
  return kList;
}

const TechniqueEntry* findTechnique(const char* name) {
  for (const TechniqueEntry& entry : techniqueList()) {
    if (std::strcmp(entry.info->name, name) == 0) return &entry;
  }
  return nullptr;
}

}  // namespace reprise
