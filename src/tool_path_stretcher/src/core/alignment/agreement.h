// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/residuals.h"
#include "surface/border.h"

namespace tool_path_stretcher {

/// How well two surfaces agree where both are known. Beyond the other surface's border nothing is
/// known: the part may continue there.
struct Agreement {
  double known = 0;         //!< share of known points, the lower of the two surfaces'
  double object_known = 0;  //!< share of the object's points that are known
  double agreeing = 0;      //!< share of known points that lie on the other surface, likewise
  double noise = 0;  //!< [m] robust deviation of the object's known points, or the resolution
  double cost = 0;   //!< [m] RMS capped distance of all points; unknown points count a middling one
  std::vector<double> object_off;     //!< [m] of the known points; 0 where an edge may be the cause
  std::vector<double> reference_off;  //!< [m] the same of the reference's

  /// Share of known points that lie farther off the other surface than noise of that deviation [m]
  /// explains, the higher of the two surfaces'.
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
