// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// Parameters of the stage outliers; see docs/cloud_preprocess.md.
struct OutlierParameters {
  bool automatic = true;    //!< statistical removal; false: only the limits cut
  int neighbours = 12;      //!< nearest points over which the mean distance is taken
  double deviations = 3.0;  //!< standard deviations above the mean that are still no outlier
  Limits limits;            //!< by hand, cut before all else
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, OutlierParameters& parameters);

/// Statistical outlier removal (Rusu et al. 2008, as in PCL): removes a point if the mean distance
/// to its nearest neighbours is more than `deviations` standard deviations above the mean over the
/// cloud. Unlike in PCL, these statistics cap each mean distance at ten times the median: otherwise
/// one point metres away would hide all others. In addition, a point up to three times that limit
/// stays if half of its neighbours are about as far from theirs: a scan is several times sparser on
/// a flank in grazing light than on a face that two passes saw, and the flank is not an outlier.
class OutlierRemoval final : public Stage {
 public:
  using Parameters = OutlierParameters;  //!< parameters of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit OutlierRemoval(const OutlierParameters& parameters);

  std::string name() const override { return "outliers"; }  //!< name of the stage

 private:
  std::string apply(TracedCloud& cloud) const override;

  OutlierParameters parameters_;
};

}  // namespace cloud_preprocess
