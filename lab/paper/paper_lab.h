// SPDX-License-Identifier: MIT
//
// What an experiment of a paper is given: scenes opened at the run's size with their references,
// techniques measured on them. A measurement that another experiment made is not made again, and
// with resumption not that of an earlier process either.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lab/float_image.h"
#include "lab/metrics/sequence_meter.h"
#include "lab/paper/geometry_classes.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "lab/vk/device.h"

namespace reprise::lab {

struct PaperScale {
  VkExtent2D extent{};
  uint32_t frames = 0;         // of a moving view
  uint32_t judge_every = 1;    // frames from one that is compared with its reference to the next
  uint32_t still_frames = 0;   // of a still one
  uint32_t samples = 0;        // of a reference, a pixel
  uint32_t still_samples = 0;  // of the one reference of a still view
  uint32_t grid = 0;           // values a side where an experiment samples a plane
  bool whole = false;          // runs too that a reduced run leaves out for time
};

// Whether silhouettes count. Centre: visibility at the pixel centre in frames and reference alike,
// shading alone is antialiased, as a paper on shading judges it. Pixel: the whole pixel.
enum class Judged { kCentre, kPixel };

struct PaperView {
  Judged judged = Judged::kCentre;
  ReferenceFilter reference_filter = ReferenceFilter::kGaussian;
  // Every frame is judged, and what only a sequence shows is measured too: Measured::over_time.
  bool over_time = false;
  TextureFilter texture_filter = TextureFilter::kAniso16;
  uint32_t samples = 1;  // a pixel: RenderSwitches::samples
  // Of a figure that was published at another size than the paper's: what a full run takes.
  VkExtent2D published_extent{};
  // RenderSwitches::defer_lights: the deferred layer of light is kept from the technique.
  bool defer_lights = false;
  // What is measured is measured by class of geometry too: Measured::by_class.
  bool by_class = false;
};

struct OverTime {
  double tpsnr_db = kNoFigure;  // MeanFigures, of the frames that count
  double flicker = kNoFigure;
  double disoccluded_db = kNoFigure;
  double sharpness = kNoFigure;
  std::vector<double> ages, age_psnr_db;  // AgeFigures
};

// PSNR of the frames that count, apart by class of geometry; indices as GeometryClass has them.
struct ByClass {
  std::array<double, kGeometryClasses> db{kNoFigure, kNoFigure, kNoFigure};
  std::array<double, kGeometryClasses> share{};  // of the pixels

  double dbOf(GeometryClass of) const { return db[static_cast<size_t>(of)]; }
  double shareOf(GeometryClass of) const { return share[static_cast<size_t>(of)]; }
};

// GPU times of a frame, medians.
struct FrameTimes {
  double render_ms = 0.0;
  double shade_ms = 0.0;  // of it, shading without geometry and lists of lights
  double resolve_ms = 0.0;

  double frameMs() const { return render_ms + resolve_ms; }
  // Where the shader dominates, geometry is nothing.
  double shadedMs() const { return shade_ms + resolve_ms; }
};

// Frames before `first_timed` do not count.
FrameTimes timesOf(const SequenceRun& run, size_t first_timed);

// Its times are those of one method after another: ratios of them are only as good as the machine
// is quiet. What claims a ratio takes PaperLab::timesTogether.
struct Measured : FrameTimes {
  std::vector<uint32_t> frames;  // that were compared with their references
  std::vector<double> psnr_db;   // one each
  double evaluations_per_pixel = 0.0;
  FloatImage last;     // display values of the last frame
  OverTime over_time;  // with PaperView::over_time
  ByClass by_class;    // with PaperView::by_class

  // Mean over the frames from `first` on; of the last where there is none.
  double meanPsnr(uint32_t first) const;
};

// A scene at the run's size on a device of its own, and its references.
class PaperScene {
 public:
  PaperScene(std::unique_ptr<Device> device, const std::string& run, const PaperScale& scale,
             bool still, const PaperView& view, const std::filesystem::path& cache, bool quiet);

  Device& device() { return *device_; }
  SceneSource& source() { return *source_; }
  uint32_t frames() const { return frames_; }
  // With PaperView::over_time: of all frames.
  const SequenceTruth& truth() const { return truth_; }
  // Every judge_every-th, the last among them.
  const std::vector<uint32_t>& judgedFrames() const { return judged_frames_; }
  bool isJudged(uint32_t frame) const {
    return std::binary_search(judged_frames_.begin(), judged_frames_.end(), frame);
  }
  // Display values, of a judged frame or one that was added.
  const FloatImage& reference(uint32_t frame) const {
    return references_[reference_of_frame_.at(frame)];
  }
  // Outside of a run: it renders.
  void addReference(uint32_t frame);
  // PSNR of a technique's linear image against the frame's reference, whose own noise is taken
  // off: independent of the image, it adds its variance, known from the reference's two halves, to
  // the mean squared error.
  double psnr(uint32_t frame, const FloatImage& linear) const;
  // Adds the same by class, with PaperView::by_class, of a judged frame.
  void addByClass(uint32_t frame, const FloatImage& linear, ClassError& error) const;

 private:
  std::unique_ptr<Device> device_;
  std::unique_ptr<SceneSource> source_;
  SequenceTruth truth_;
  std::vector<FloatImage> linear_references_;
  std::vector<FloatImage> references_;
  std::vector<double> noise_;  // mean squared error of each reference
  std::vector<std::vector<float>> pixel_noise_;
  std::map<uint32_t, std::vector<GeometryClass>> classes_;
  std::map<uint64_t, size_t> reference_of_;  // by a hash of what the frame shows
  std::map<uint32_t, size_t> reference_of_frame_;
  std::vector<uint32_t> judged_frames_;
  uint32_t frames_ = 0;
};

struct PaperLabOptions {
  PaperScale scale;
  std::filesystem::path directory;  // measurements are kept in its folder "runs"
  std::filesystem::path cache;      // of references; see ReferenceOptions
  bool resume = false;
  bool quiet = false;
  std::function<std::unique_ptr<Device>()> open_device;
};

class PaperLab {
 public:
  explicit PaperLab(PaperLabOptions options);

  const PaperScale& scale() const { return options_.scale; }
  // With the view's own size where the run is a full one.
  PaperScale scaleOf(const PaperView& view) const;
  bool quiet() const { return options_.quiet; }
  std::unique_ptr<Device> openDevice() const { return options_.open_device(); }
  // Of the scenes opened so far; closes the open one.
  std::vector<std::string> takeValidationMessages();
  // Of a device that an experiment opened for itself.
  void keepValidation(const Device& device);

  // `technique` over the scene "brick/pan". A camera named "still" runs still_frames.
  const Measured& measure(const std::string& run, const std::string& technique,
                          const PaperView& view = {});
  // The same of several, for measure() to find: techniques that sample alike share the rendering,
  // and their resolves take turns frame by frame. What measure() had before stays.
  void measureTogether(const std::string& run, const std::vector<std::string>& techniques,
                       const PaperView& view = {});
  // Of each technique, over the first frames of the scene, in turn frame by frame.
  std::vector<FrameTimes> timesTogether(const std::string& run,
                                        const std::vector<std::string>& techniques,
                                        const PaperView& view = {});
  // The last one opened stays open.
  PaperScene& scene(const std::string& run, const PaperView& view = {});
  // Runs `technique` over the scene as measure does: all frames, or, where it keeps no history, the
  // judged ones.
  SequenceRun filter(const std::string& run, const std::string& technique,
                     const std::function<void(const FrameDone&)>& done, const PaperView& view = {});
  // The same of several, those that sample alike together; `done` is called with the technique's
  // number.
  std::vector<SequenceRun> filterTogether(const std::string& run,
                                          const std::vector<std::string>& techniques,
                                          const std::function<void(size_t, const FrameDone&)>& done,
                                          const PaperView& view = {});
  // Frames at the start of a run of `frames` that do not count.
  static uint32_t warmUp(uint32_t frames);

 private:
  std::string key(const std::string& run, const std::string& technique,
                  const PaperView& view) const;
  std::filesystem::path stemOf(const std::string& key) const;
  // What was measured before, by this process or, with resumption, an earlier one.
  bool isMeasured(const std::string& key);
  void measureBatch(const std::string& run, std::span<const std::string> techniques,
                    const PaperView& view);
  void close();

  PaperLabOptions options_;
  std::map<std::string, Measured> measured_;
  std::string open_key_;
  std::unique_ptr<PaperScene> scene_;
  std::vector<std::string> validation_;
};

// Whether `scene` is in the list of scenes.
bool sceneIsHere(const std::string& scene);

}  // namespace reprise::lab
