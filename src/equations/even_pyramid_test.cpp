// SPDX-License-Identifier: MIT
#include "equations/even_pyramid.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(EvenPyramid, UpIsTwiceTheTransposeOfDown) {
  for (int fine = 8; fine < 16; ++fine) {
    for (int coarse = 0; coarse < 16; ++coarse) {
      const int i = fine - (2 * coarse - 1);
      const float down = i >= 0 && i < 4 ? evenPyramidWeight(i) : 0.0f;
      const float up = coarse == fine / 2                    ? kEvenPyramidNear
                       : coarse == evenPyramidFarTexel(fine) ? kEvenPyramidFar
                                                             : 0.0f;
      EXPECT_FLOAT_EQ(up, 2.0f * down) << fine << " " << coarse;
    }
  }
}

}  // namespace
}  // namespace reprise::eq
