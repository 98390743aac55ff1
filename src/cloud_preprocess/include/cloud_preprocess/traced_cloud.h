// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace cloud_preprocess {

using scan_cell_common::Cloud;

/// The removed floor. Nothing stands where it was seen.
struct SeenFloor {
  Cloud points;           //!< [m] on or below it
  Eigen::Vector3f point;  //!< [m] of its plane
  Eigen::Vector3f up;     //!< unit length, away from the floor
};

/// A cloud that records for each point its source: the point of the input cloud that it comes from.
/// The source has the point's other fields.
class TracedCloud {
 public:
  TracedCloud() = default;
  /// Each point is its own source.
  explicit TracedCloud(Cloud cloud);

  const Cloud& cloud() const { return cloud_; }                           //!< [m]
  const std::vector<std::uint32_t>& sources() const { return sources_; }  //!< one per point

  /// Null if the floor was not looked for or not found.
  const SeenFloor* floor() const { return floor_.get(); }
  /// Stores the floor for later stages.
  void set_floor(SeenFloor floor);

  /// Keeps the points for which `keep(index)` is true, in their order.
  /// @return number of points removed
  template <class Keep>
  std::size_t keep_if(const Keep& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (!keep(i)) continue;
      cloud_[kept] = cloud_[i];
      sources_[kept++] = sources_[i];
    }
    const std::size_t removed = cloud_.size() - kept;
    cloud_.resize(kept);
    sources_.resize(kept);
    return removed;
  }

  /// Replaces the points.
  /// @param points for each new point, the index of the old one it comes from
  void replace(Cloud cloud, const std::vector<std::uint32_t>& points);

 private:
  Cloud cloud_;
  std::vector<std::uint32_t> sources_;
  std::shared_ptr<const SeenFloor> floor_;
};

}  // namespace cloud_preprocess
