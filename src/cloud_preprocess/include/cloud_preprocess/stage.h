// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cloud_preprocess/traced_cloud.h"

namespace cloud_preprocess {

/// What one stage did to one cloud.
struct StageReport {
  std::string stage;           //!< its name
  std::size_t points_in = 0;   //!< of the input cloud
  std::size_t non_finite = 0;  //!< of points_in: with NaN or infinity, dropped first
  std::size_t points_out = 0;  //!< of the output cloud
  std::string message;         //!< findings, for a person
};

/// One stage of preprocessing. Stages are immutable: the same cloud gives the same bytes.
class Stage {
 public:
  virtual ~Stage() = default;

  virtual std::string name() const = 0;  //!< floor, outliers, isolate or grid

  /// @param cloud [m]; points that are not finite are dropped and counted
  /// @param report filled in as far as the stage got, even if it throws
  /// @throw scan_cell_common::UnusableInput if the cloud has no finite point or none is left: the
  /// output is never empty
  Cloud run(Cloud cloud, StageReport& report) const;

  /// The same, with the source of each point.
  void run(TracedCloud& cloud, StageReport& report) const;

 protected:
  /// Changes a finite, non-empty cloud, and returns in a few words what was done.
  virtual std::string apply(TracedCloud& cloud) const = 0;
};

/// "x 0.1 .. 0.2, y ..., z ... m", for error messages.
std::string bounds_text(const Cloud& cloud);

}  // namespace cloud_preprocess
