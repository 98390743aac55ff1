// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignment/candidate.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

/// Finds the poses in which both surfaces agree where both are known. Either may show only a part
/// of the other, as long as they share about half of it.
class PartialSearch {
 public:
  PartialSearch(const SurfacePair& surfaces, const Prior& prior)
      : surfaces_(surfaces), prior_(prior) {}

  /// Distinct poses, best first, each with its agreement; searched on the first call. None
  /// contradicts the prior.
  const std::vector<Candidate>& fits();

  /// Whether the best pose, undeformed, agrees to within the noise and almost nothing contradicts
  /// it.
  bool is_certain();

  Agreement agreement(const Mapping& mapping);

 private:
  std::vector<Candidate> search();
  const Comparison& comparison();
  bool agrees_to_the_noise(const Candidate& best) const;

  const SurfacePair surfaces_;
  const Prior prior_;
  std::optional<Comparison> comparison_;  // created on demand: most scans need none
  std::optional<std::vector<Candidate>> fits_;
  std::optional<bool> certain_;
};

}  // namespace tool_path_stretcher
