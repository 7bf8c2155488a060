// SPDX-License-Identifier: MIT
//
// What amortized supersampling trades for time: a budget of evaluations, and the number of buffers
// in use, which may change from frame to frame.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{97, 61};

SceneSourceOptions optionsOf(uint32_t frames) {
  SceneSourceOptions options;
  options.extent = kExtent;
  options.frames = frames;
  options.reference.samples = 64;
  options.reference.filter = ReferenceFilter::kGaussian;
  options.reference.cache = "none";
  return options;
}

// A scene and a technique, frame by frame.
class Sequence {
 public:
  Sequence(const char* scene, const std::string& technique, uint32_t frames = 64)
      : source_(testDevice(), parseSceneRun(scene), optionsOf(frames)),
        resolver_(testDevice(), parseTechnique(technique), source_.info()) {}

  FloatImage next() {
    const SamplePlan plan = resolver_.plan(index_);
    source_.prepare(plan);
    testDevice().submitAndWait([&](VkCommandBuffer commands) {
      resolver_.record(commands, source_.frame(commands, index_, plan), nullptr);
    });
    evaluations_per_pixel =
        static_cast<double>(source_.takeEvaluations()) / (kExtent.width * kExtent.height);
    ++index_;
    return download(testDevice(), resolver_.output());
  }
  FloatImage run(uint32_t frames) {
    FloatImage image;
    for (uint32_t i = 0; i < frames; ++i) image = next();
    return image;
  }
  double psnrOfNext() {
    const FloatImage reference = displayImage(*source_.reference(index_));
    source_.takeEvaluations();
    return psnrDb(meanSquaredError(reference, displayImage(next())));
  }
  OwnedContext& context() { return resolver_.context(); }

  double evaluations_per_pixel = 0.0;

 private:
  SceneSource source_;
  Resolver resolver_;
  uint32_t index_ = 0;
};

bool equal(const FloatImage& a, const FloatImage& b) {
  return a.texels.size() == b.texels.size() &&
         std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

class Effort : public testing::Test {
 protected:
  void TearDown() override { expectNoValidationMessages(); }
};
class Budget : public Effort {};

TEST_F(Budget, HoldsExactlyAndIsSpent) {
  for (const double budget : {1.0, 1.1, 1.5, 2.0, 3.3, 5.0}) {
    Sequence sequence("brick/pan", "amortized:budget=" + std::to_string(budget));
    sequence.next();
    EXPECT_LE(sequence.evaluations_per_pixel, budget);
    EXPECT_GT(sequence.evaluations_per_pixel, budget - 0.02);
  }
}

TEST_F(Budget, MoreIsBetterAndTheFirstSamplesHelpMost) {
  const auto first = [](const char* budget) {
    return Sequence("brick/still", std::string("amortized:budget=") + budget).psnrOfNext();
  };
  const double one = first("1");
  const double two = first("2");
  const double three = first("3");
  const double five = first("5");
  EXPECT_GT(two, one + 1.0);
  EXPECT_GT(three, two + 0.3);
  EXPECT_GT(five, three + 0.3);
  EXPECT_GT(two - one, three - two);
}

TEST_F(Budget, GoesToThoseThatHaveNothingFirst) {
  // In motion the strip that comes into view has no history: one evaluation a pixel of it comes
  // before a second.
  Sequence whole("brick/pan", "amortized");
  Sequence tight("brick/pan", "amortized:budget=1.02");
  whole.run(16);
  tight.run(16);
  const double wanted = whole.psnrOfNext();
  const double got = tight.psnrOfNext();
  EXPECT_GT(whole.evaluations_per_pixel, 1.02);
  EXPECT_LE(tight.evaluations_per_pixel, 1.02);
  EXPECT_GT(got, wanted - 1.0);
}

TEST_F(Budget, TheChoiceIsTheSameEveryTime) {
  Sequence a("brick/rotate", "amortized:budget=1.3");
  Sequence b("brick/rotate", "amortized:budget=1.3");
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(equal(a.next(), b.next())) << i;
}

// What a request gathers before shading is what a frame without one gathers after: but for
// halves between the two, rounded like the buffers themselves. With residuals, whose eight bits are
// compared with a tolerance, the two drift apart.
TEST_F(Effort, ARequestGathersWhatTheResolveWould) {
  constexpr double kAlike_db = 75.0;
  constexpr double kDrifted_db = 50.0;
  const std::pair<const char*, double> all[] = {{"", kAlike_db},
                                                {",samples=frame", kAlike_db},
                                                {",shutter=0.7", kAlike_db},
                                                {",effort=2,motion=exact", kAlike_db},
                                                {",residual=0.02", kDrifted_db}};
  for (const auto& [settings, least_db] : all) {
    // A budget of one lets nothing be served.
    Sequence asks("brick/rotate", std::string("amortized:budget=1") + settings);
    Sequence does_not("brick/rotate", std::string("amortized:requests=false") + settings);
    double worst_db = 1.0e9;
    for (int i = 0; i < 12; ++i) {
      const double mse = meanSquaredError(displayImage(asks.next()), displayImage(does_not.next()));
      worst_db = std::min(worst_db, psnrDb(mse));
    }
    EXPECT_GT(worst_db, least_db) << settings;
  }
}

TEST_F(Effort, FewerBuffersInUseAreAsGoodAsFewerBuffers) {
  for (const char* count : {"1", "2"}) {
    Sequence used("brick/rotate", std::string("amortized:effort=") + count);
    Sequence made("brick/rotate", std::string("amortized:buffers=") + count);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(equal(used.next(), made.next())) << count << " " << i;
  }
}

TEST_F(Effort, AChangeKeepsWhatWasGathered) {
  for (const char* scene : {"brick/still", "brick/pan"}) {
    Sequence sequence(scene, "amortized");
    sequence.run(24);
    double worst_db = sequence.psnrOfNext();
    const double fresh_db = Sequence(scene, "amortized:requests=false").psnrOfNext();
    for (const char* effort : {"2", "1", "4", "1", "2", "4"}) {
      sequence.context().set("effort", effort);
      for (int i = 0; i < 5; ++i) {
        worst_db = std::min(worst_db, sequence.psnrOfNext());
        // No burst of requests for what a change left empty.
        EXPECT_LT(sequence.evaluations_per_pixel, 1.2) << scene << " " << effort;
      }
    }
    EXPECT_GT(worst_db, fresh_db + 5.0) << scene;
  }
}

TEST_F(Effort, AChangeAtRestConvergesOn) {
  Sequence sequence("brick/still", "amortized");
  const double before = (sequence.run(16), sequence.psnrOfNext());
  sequence.context().set("effort", "2");
  sequence.run(16);
  sequence.context().set("effort", "4");
  const double after = (sequence.run(32), sequence.psnrOfNext());
  EXPECT_GT(after, before);
}

TEST_F(Effort, TheHeldFrameTimeChoosesSettingsWithoutPrepare) {
  Sequence sequence("brick/pan", "amortized");
  sequence.run(2);
  const RepriseContext context = sequence.context().handle();
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(repriseHoldFrameTime(context, 0.030, 0.016), REPRISE_SUCCESS);
  }
  double effort = -1.0;
  double budget = -1.0;
  ASSERT_EQ(repriseGetSetting(context, "effort", &effort), REPRISE_SUCCESS);
  ASSERT_EQ(repriseGetSetting(context, "budget", &budget), REPRISE_SUCCESS);
  EXPECT_EQ(effort, 0.0);  // the choice "1"
  EXPECT_EQ(budget, 1.0);
  sequence.run(2);
  EXPECT_LE(sequence.evaluations_per_pixel, 1.0);
  for (int i = 0; i < 400; ++i) {
    ASSERT_EQ(repriseHoldFrameTime(context, 0.004, 0.016), REPRISE_SUCCESS);
  }
  ASSERT_EQ(repriseGetSetting(context, "effort", &effort), REPRISE_SUCCESS);
  EXPECT_EQ(effort, 2.0);  // the choice "4"
  sequence.run(2);
}

TEST_F(Effort, HoldingAFrameTimeRefusesNonsense) {
  Sequence sequence("brick/pan", "amortized");
  const RepriseContext context = sequence.context().handle();
  for (const double bad : {0.0, -1.0, 16.0, std::nan("")}) {
    EXPECT_EQ(repriseHoldFrameTime(context, bad, 0.016), REPRISE_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(repriseHoldFrameTime(context, 0.016, bad), REPRISE_ERROR_INVALID_ARGUMENT);
  }
  EXPECT_EQ(repriseHoldFrameTime(nullptr, 0.016, 0.016), REPRISE_ERROR_INVALID_ARGUMENT);
  Sequence taa("brick/pan", "taa");
  EXPECT_EQ(repriseHoldFrameTime(taa.context().handle(), 0.016, 0.016), REPRISE_ERROR_UNSUPPORTED);
}

}  // namespace
}  // namespace reprise::lab
