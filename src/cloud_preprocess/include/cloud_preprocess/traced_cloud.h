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

/// The floor that was removed: where it was seen nothing stands.
struct SeenFloor {
  Cloud points;           //!< [m] on or below it
  Eigen::Vector3f point;  //!< [m] of its plane
  Eigen::Vector3f up;     //!< of length 1, away from it
};

/// A cloud, and from which point of the cloud that went in each of its points comes: what a point
/// carries besides its place is found there.
class TracedCloud {
 public:
  TracedCloud() = default;
  /// Each point comes from itself.
  explicit TracedCloud(Cloud cloud);

  const Cloud& cloud() const { return cloud_; }                           //!< [m]
  const std::vector<std::uint32_t>& sources() const { return sources_; }  //!< one a point

  /// None: it was not looked for or not found.
  const SeenFloor* floor() const { return floor_.get(); }
  /// Tells the stages that come after.
  void set_floor(SeenFloor floor);

  /// Keeps the points for which `keep(index)` is true, in their order.
  /// @return how many went
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

  /// Puts other points in place of these.
  /// @param points index of one of these for each of them
  void replace(Cloud cloud, const std::vector<std::uint32_t>& points);

 private:
  Cloud cloud_;
  std::vector<std::uint32_t> sources_;
  std::shared_ptr<const SeenFloor> floor_;
};

}  // namespace cloud_preprocess
