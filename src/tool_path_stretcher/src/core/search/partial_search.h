// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "search/agreement.h"
#include "search/hypotheses.h"

namespace tool_path_stretcher {

struct PartialFit {
  Similarity similarity;
  Agreement agreement;
};

/// The poses where both surfaces agree as far as both are known: either may show only a part of
/// what the other shows, as long as they share about half of it.
class PartialSearch {
 public:
  /// The surfaces must outlive it.
  PartialSearch(const Surface& reference, const Surface& object, const Prior& prior)
      : reference_(reference), object_(object), prior_(prior) {}

  /// Distinct ones, best first; searched for at the first call. None contradicts the prior.
  const std::vector<PartialFit>& fits();

  /// Whether the best agrees to the noise, undeformed, and next to nothing contradicts it.
  bool is_certain();

  Agreement agreement(const Mapping& mapping);

 private:
  void search();
  bool agrees_to_the_noise() const;

  const Surface& reference_;
  const Surface& object_;
  Prior prior_;
  std::optional<Comparison> comparison_;  // most scans need none
  bool searched_ = false;
  std::optional<bool> certain_;
  std::vector<PartialFit> fits_;
};

}  // namespace tool_path_stretcher
