// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "alignment/agreement.h"

namespace tool_path_stretcher {

/// A pose and size of the reference, and how well it explains the object.
struct Candidate {
  Similarity similarity;
  double cost = 0;       //!< [m, object] residual of both directions
  double bulk_cost = 0;  //!< [m] the same, leaving out more of the object: floor and loose points
  std::optional<Agreement> agreement = {};  //!< only where either surface may be partial
};

/// RMS residual in both directions, each point counted up to a cap. Leaves out the share of the
/// object that may not belong to the part, and counts only the share of the reference that any scan
/// covers. The surfaces' resolution is added: otherwise, without noise, a pose would seem many
/// times better than another just because it was refined further.
Candidate judged(const SurfacePair& surfaces, const Mapping& mapping, Density density);

}  // namespace tool_path_stretcher
