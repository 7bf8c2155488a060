// SPDX-License-Identifier: MIT
//
// How far from their place the samples lie that a subpixel buffer holds after long panning at a
// constant velocity (Yang et al. 2009, section 5.2). The paper tracks samples; here their first
// and second moments follow a linear recurrence, since under constant panning every pixel of a
// buffer holds the same distribution:
//   a sample set moved by d:  m1 + d,  m2 + 2 d m1 + d^2;  sets mixed by weights: moments too.
// One period of the update order is an affine map of the moments; its fixed point is what the
// buffers converge to.
#pragma once

#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {

// Gathers of one period at one velocity: independent of the smoothing factor.
class PanningGathers {
 public:
  // previous_px = px + (vx, vy) each frame. `order[n]` is the buffer written in frame n.
  PanningGathers(const BufferLayout& layout, double vx, double vy);
  PanningGathers(const BufferLayout& layout, const std::array<uint32_t, kPeriod>& order, double vx,
                 double vy);

  struct Moments {
    double first_x;  // mean, px: the drift
    double first_y;
    double second;  // about zero, mean of x and y, px^2: blur and drift
  };
  // Mean over the buffers and one period; `sample_variance` is that of a component of the jitter,
  // `alpha` the weight of the new sample in its buffer.
  Moments moments(double alpha, double sample_variance) const;

 private:
  // What buffer k contributes to the gather of one frame.
  struct Contribution {
    double weight;   // sum over its texels
    double shift_x;  // sum of weight * displacement
    double shift_y;
    double square;  // sum of weight * squared displacement, mean of x and y
  };
  struct Gather {
    uint32_t written;
    bool empty;  // no texel under the tent: the buffer starts anew
    std::array<Contribution, kMaxBuffers> from;
  };
  uint32_t count_;
  std::array<Gather, kPeriod> gathers_;
};

}  // namespace reprise::amortized
