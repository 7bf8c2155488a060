// SPDX-License-Identifier: MIT
//
// The scenes of Xiao, Liktor, Vaidyanathan 2018, what stands for them here, and the methods that
// they compare.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/paper/paper_lab.h"
#include "lab/run/sequence_run.h"

namespace reprise::lab::cpst {

// A line of table 1, ms and evaluations.
struct PublishedCost {
  double visibility_ms, lighting_ms, resolve_ms, total_ms, evaluations;
};

struct Subject {
  std::string name;  // of the paper's scene
  std::string run;
  std::string note;  // where `run` is not that scene: why
  uint32_t lamps;
  PublishedCost ps, cbr, cpst;
};

// Sponza, Bistro, San Miguel. The models are the user's (REPRISE_DATA); where there are none, and
// for San Miguel always, another scene stands for it.
const std::vector<Subject>& subjects();
const Subject& sponza();
const Subject& bistro();
const Subject& sanMiguel();

// A method of the comparison: name in the paper, and what we run.
struct Contender {
  std::string name;
  std::string technique;
};
inline const std::string kPs = "taa";
inline const std::string kCps = "cps";
inline const std::string kCbr = "checkerboard";
inline const std::string kCpst = "cpst";
// PS, CBR, CPS-T.
const std::vector<Contender>& timed();
// And CPS.
const std::vector<Contender>& judged();

// A scene without references, for times and counts.
class BareScene {
 public:
  // `lamps`: none given, the scene's own; `lamp_reach` as in RenderSwitches.
  BareScene(PaperLab& lab, const std::string& run, VkExtent2D extent, uint32_t frames,
            std::optional<uint32_t> lamps, double frame_rate = 60.0, float lamp_reach = 1.0f);
  ~BareScene();
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  Device& device() { return *device_; }
  SceneSource& source() { return *source_; }
  // PS, CBR, CPS-T, frame by frame in turn.
  std::vector<SequenceRun> timedRuns();
  // Evaluations of each frame that the technique asks for; it resolves nothing.
  std::vector<uint64_t> evaluations(const std::string& technique);

 private:
  PaperLab& lab_;
  std::string name_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<SceneSource> source_;
  uint32_t frames_;
};

struct Cost {
  double visibility_ms = 0.0;  // transform, depth and triangles
  double lighting_ms = 0.0;    // shading, and the lights of each tile
  double resolve_ms = 0.0;
  double total_ms = 0.0;  // shadows and motion with it
  double evaluations_per_pixel = 0.0;
};
// Medians over the frames after the first `untimed`. The first builds caches; in those that follow
// history fills, and a resolve does more than it does later.
constexpr size_t kUntimedFrames = 4;
Cost costOf(const SequenceRun& run, size_t untimed = kUntimedFrames);

// What was asked of a frame at 512 lights, and what Table 2 published: CPS-T over PS and over CBR.
constexpr double kMostFrameOfPs = 0.55;
constexpr double kMostFrameOfCbr = 0.72;
constexpr double kPublishedOfPs = 9.48 / 17.95;
constexpr double kPublishedOfCbr = 9.48 / 13.66;

// Share of lighting in PS's frame at 512 lights: 17.95 ms of Table 2, of which all but lighting
// takes 1.56 (Table 1, Sponza).
constexpr double kPublishedShareOfLighting = (17.95 - 1.56) / 17.95;
// Reach of the lamps in Table 2. The paper says that it set the number of lights that overlap, and
// not to what; this is the shortest reach, in whole steps, at which lighting has that share here
// (item "time by price").
constexpr float kWorkloadReach = 3.0f;

// Extent and frames of what is timed: a few frames, large enough that coarse pixels are coarse.
VkExtent2D timedExtent(const PaperLab& lab);
uint32_t timedFrames(const PaperLab& lab);

// Whole pixels, references of the pixel's box.
PaperView view();

}  // namespace reprise::lab::cpst
