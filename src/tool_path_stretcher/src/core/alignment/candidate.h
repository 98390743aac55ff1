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
  double bulk_cost = 0;  //!< [m] the same without more of the object: floor and loose points
  std::optional<Agreement> agreement = {};  //!< only where either surface may be partial
};

/// The root mean square residual of both directions, each point counted up to a cap; of the object
/// without the share that may not belong to the part, of the reference only the share that any scan
/// covers. Added to that is what the surfaces cannot resolve: without noise one pose is not many
/// times as good as another because it was refined further.
Candidate judged(const SurfacePair& surfaces, const Mapping& mapping, Density density);

}  // namespace tool_path_stretcher
