// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace reprise::lab {

// Calls work(0) ... work(count - 1), each once, on as many threads as the machine has; returns when
// all have returned. The first exception of one is thrown again here.
void onWorkers(size_t count, const std::function<void(size_t)>& work);

}  // namespace reprise::lab
