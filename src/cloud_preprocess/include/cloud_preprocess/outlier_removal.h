// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

struct OutlierParameters {
  bool automatic = true;    //!< statistical removal; false: only the limits cut
  int neighbours = 12;      //!< nearest points whose mean distance is looked at
  double deviations = 3.0;  //!< standard deviations above the mean that are still no outlier
  Limits limits;
};

template <class Reader>
void describe(Reader& reader, OutlierParameters& parameters) {
  using Range = typename Reader::Range;
  reader.read("automatic", parameters.automatic);
  reader.read("neighbours", parameters.neighbours, Range{1, 200});
  reader.read("deviations", parameters.deviations, Range{0, 100});
  describe(reader, parameters.limits);
}

/// Statistical outlier removal (Rusu et al. 2008, as in PCL): a point goes if the mean distance to
/// its nearest neighbours is more than so many standard deviations above the mean over the cloud.
/// Unlike PCL's, a mean distance counts as at most ten times the median in these statistics: one
/// point metres away would otherwise hide all others.
class OutlierRemoval final : public Stage {
 public:
  using Parameters = OutlierParameters;

  /// @throw scan_cell_common::InvalidParameter
  explicit OutlierRemoval(const OutlierParameters& parameters);

  std::string name() const override { return "outliers"; }

 private:
  std::string apply(Cloud& cloud) const override;

  OutlierParameters parameters_;
};

}  // namespace cloud_preprocess
