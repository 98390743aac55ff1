// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cores/by_index.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace tool_path_stretcher {

void for_ranges(std::size_t count, std::size_t grain,
                const std::function<void(std::size_t, std::size_t)>& work) {
  if (count <= grain) {
    if (count > 0) work(0, count);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain),
      [&work](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
}

}  // namespace tool_path_stretcher
