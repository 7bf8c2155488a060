// SPDX-License-Identifier: MIT
// blur_table_generator BUFFERS FILE: writes the table for 2 or 4 buffers as a C list of bytes,
// [threshold][vy][vx]. Run by the build; takes seconds.
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "techniques/amortized/blur_table.h"

using namespace reprise::amortized;

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto buffers = static_cast<uint32_t>(std::atoi(argv[1]));
  std::vector<uint8_t> table(kTableSize * kTableSize * kTableSize);
  const auto fillRows = [&](uint32_t first, uint32_t step) {
    for (uint32_t y = first; y < kTableSize; y += step) {
      for (uint32_t x = 0; x < kTableSize; ++x) {
        const auto column =
            blurColumn(buffers, x / double{kTableSize - 1}, y / double{kTableSize - 1});
        for (uint32_t j = 0; j < kTableSize; ++j) {
          table[(j * kTableSize + y) * kTableSize + x] = column[j];
        }
      }
    }
  };
  std::thread odd(fillRows, 1, 2);
  fillRows(0, 2);
  odd.join();
  FILE* file = std::fopen(argv[2], "w");
  if (file == nullptr) return 1;
  for (size_t i = 0; i < table.size(); ++i) {
    std::fprintf(file, i % 32 == 31 ? "%d,\n" : "%d,", table[i]);
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
