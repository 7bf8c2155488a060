// SPDX-License-Identifier: MIT
//
// The scenes that Yang et al. 2009 measure, what they print of them, and the techniques of their
// comparison.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/paper/masked_error.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab::amortized {

// Figure 14: dB and frames a second.
struct PublishedFigures {
  double none_db, ss2_db, ss3_db, ss4_db;
  double reprojection_moving_db, reprojection_still_db;
  double amortized_moving_db, amortized_still_db;
  double none_fps, ss4_fps, reprojection_fps, amortized_fps;
};

struct Subject {
  std::string scene;
  std::string moving;  // run
  std::string still;
  bool shading_changes;  // lights move: residuals are kept (section 6)
  // Its strongly moving light is shaded at native rate and added after (section 8); for every
  // technique alike.
  bool defer_lights;
  std::optional<PublishedFigures> published;

  PaperView view() const { return {.defer_lights = defer_lights}; }
};

const Subject& horse();
const Subject& brick();
const Subject& indoor();
const Subject& teapot();

// Tolerances of the residual that Figure 10 goes through; 0: no residuals.
const std::vector<double>& residualTolerances();
// With motion as the paper's vertex shader computes it: to the buffers' own frames.
std::string amortizedWith(double residual);
// The technique as the paper runs it on the scene: its residual tolerance, where shading changes,
// is that of the best PSNR in motion (section 6.2).
std::string amortizedFor(PaperLab& lab, const Subject& subject);

// Jittered reprojection as section 7 has it: uniform jitter, and the constant smoothing factor of
// the best PSNR in motion.
std::string bestReprojection(PaperLab& lab, const std::string& run, const PaperView& view = {});

// Evaluations beyond the first in each pixel of a frame, 0 to 4: the requests that were served.
PixelMask addedEvaluations(Device& device, const FrameInputs& inputs);

// Mean PSNR of a moving run over the frames that count.
double movingPsnr(PaperLab& lab, const std::string& run, const std::string& technique,
                  const PaperView& view = {});
// Of a still run, over its last quarter.
double stillPsnr(PaperLab& lab, const std::string& run, const std::string& technique,
                 const PaperView& view = {});

}  // namespace reprise::lab::amortized
