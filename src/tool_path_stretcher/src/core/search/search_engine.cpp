// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/search_engine.h"

#include <algorithm>
#include <cmath>

#include "cores/by_index.h"

namespace tool_path_stretcher {
namespace {

template <class Condition>
void erase_if(std::vector<Candidate>& candidates, const Condition& condition) {
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), condition),
                   candidates.end());
}

void drop_hopeless(double hopeless, double best, std::vector<Candidate>& candidates) {
  if (hopeless == kNever) return;
  for (const Candidate& each : candidates)
    best = std::min(best, each.bulk_cost);
  erase_if(candidates, [&](const Candidate& each) { return !(each.bulk_cost <= hopeless * best); });
}

}  // namespace

void SearchEngine::improve(const Round& round, std::vector<Candidate>& candidates) const {
  const std::size_t grain = round.density ? kSingly : kDozens;
  const auto allowed = by_index<char>(
      candidates.size(), grain, [&](std::size_t i) { return improve_(round, candidates[i]); });
  std::vector<Candidate> improved;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (allowed[i]) improved.push_back(std::move(candidates[i]));
  }
  candidates = std::move(improved);
}

void SearchEngine::select(const Round& round, std::vector<Candidate>& candidates,
                          const FoundPoses& found) const {
  drop_hopeless(round.hopeless, found.bulk_cost, candidates);
  if (round.max_kept == Round::kAll) return;
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  if (round.radius == 0) {
    if (candidates.size() > round.max_kept) candidates.resize(round.max_kept);
    return;
  }
  const double radius = round.radius * size_;
  std::vector<Candidate> kept;
  std::vector<Similarity> poses;
  for (Candidate& each : candidates) {
    if (kept.size() == round.max_kept || !std::isfinite(each.cost)) break;
    if (is_near(each.similarity, found.poses, radius) || is_near(each.similarity, poses, radius))
      continue;
    poses.push_back(each.similarity);
    kept.push_back(std::move(each));
  }
  candidates = std::move(kept);
}

bool SearchEngine::is_near(const Similarity& pose, const std::vector<Similarity>& others,
                           double radius) const {
  return std::any_of(others.begin(), others.end(), [&](const Similarity& other) {
    return distance(pose, other, probes_) < radius;
  });
}

}  // namespace tool_path_stretcher
