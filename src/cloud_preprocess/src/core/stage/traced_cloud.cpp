// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/traced_cloud.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cloud_preprocess {

TracedCloud::TracedCloud(Cloud cloud) : cloud_(std::move(cloud)), sources_(cloud_.size()) {
  std::iota(sources_.begin(), sources_.end(), 0U);
}

void TracedCloud::set_floor(SeenFloor floor) {
  floor_ = std::make_shared<const SeenFloor>(std::move(floor));
}

void TracedCloud::replace(Cloud cloud, const std::vector<std::uint32_t>& points) {
  std::vector<std::uint32_t> sources;
  sources.reserve(points.size());
  for (const std::uint32_t point : points)
    sources.push_back(sources_.at(point));
  cloud_ = std::move(cloud);
  sources_ = std::move(sources);
}

}  // namespace cloud_preprocess
