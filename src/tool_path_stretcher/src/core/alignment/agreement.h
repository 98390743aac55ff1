// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/residuals.h"
#include "surface/border.h"

namespace tool_path_stretcher {

/// How two surfaces agree where both are known. A point beyond the other's border is not: the part
/// may go on there.
struct Agreement {
  double known = 0;         //!< lesser share of either's points that are
  double object_known = 0;  //!< share of the object's points that are
  double agreeing = 0;      //!< lesser share, of the known points of either, that lie on the other
  double noise = 0;         //!< [m] robust standard deviation of the known points of the object, or
                            //!< the resolution
  double cost = 0;          //!< [m] RMS distance of all, capped; of points not known a middling one
  std::vector<double> object_off;     //!< [m] of the known points; 0 where an edge may be to blame
  std::vector<double> reference_off;  //!< [m] the same of the reference's

  /// Greater share, of the known points of either, that noise of that deviation [m] does not put so
  /// far off the other.
  double contradicted(double deviation) const;
};

/// Compares two surfaces under any number of mappings.
class Comparison {
 public:
  explicit Comparison(const SurfacePair& surfaces);

  Agreement under(const Mapping& mapping) const;

 private:
  struct Known;
  Known object_on_reference(const Mapping& mapping) const;
  Known reference_on_object(const Mapping& mapping) const;

  const SurfacePair surfaces_;
  Border reference_border_;
  Border object_border_;
};

}  // namespace tool_path_stretcher
