// SPDX-License-Identifier: MIT
//
// Captures without capture.json: which channels hold what, told from their names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/capture/description.h"

namespace reprise::lab {

enum class CaptureLayout { kAuto, kBlender, kEngine };

// "auto", "blender", "engine"; the order of the enumeration.
extern const std::vector<std::string> kCaptureLayouts;

struct DetectedCapture {
  CaptureDescription description;
  // A line for each thing that the files do not say and that was assumed.
  std::vector<std::string> assumptions;
};

// Looks at the EXR files of `directory` (NAME0001.exr ...) and the channels of the first. Throws
// CaptureError when a needed channel has none of the known names.
DetectedCapture detectCapture(const std::filesystem::path& directory, CaptureLayout layout);

}  // namespace reprise::lab
