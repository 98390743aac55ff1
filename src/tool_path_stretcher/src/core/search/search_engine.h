// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "alignment/candidate.h"
#include "search/rounds.h"

namespace tool_path_stretcher {

/// Poses found before, near which no other is kept, and the best one's bulk cost [m].
struct FoundPoses {
  std::vector<Similarity> poses;
  double bulk_cost = kNever;
};

/// Runs the rounds of a search.
class SearchEngine {
 public:
  /// Improves a pose for a round and rates it. Returns false if it contradicts the prior. Called
  /// for several poses in parallel.
  using Improve = std::function<bool(const Round& round, Candidate& candidate)>;

  /// @param probes points of the reference that tell poses apart [m]
  /// @param size of the object [m]
  SearchEngine(Points probes, double size, Improve improve)
      : probes_(std::move(probes)), size_(size), improve_(std::move(improve)) {}

  void run(const Round& round, std::vector<Candidate>& candidates,
           const FoundPoses& found = {}) const {
    improve(round, candidates);
    select(round, candidates, found);
  }

  void improve(const Round& round, std::vector<Candidate>& candidates) const;

  /// Keeps the candidates that the round keeps, best first.
  void select(const Round& round, std::vector<Candidate>& candidates,
              const FoundPoses& found = {}) const;

 private:
  bool is_near(const Similarity& pose, const std::vector<Similarity>& others, double radius) const;

  Points probes_;
  double size_;
  Improve improve_;
};

}  // namespace tool_path_stretcher
