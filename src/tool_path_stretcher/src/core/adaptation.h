// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "search/candidates.h"
#include "search/partial_search.h"
#include "stages.h"
#include "tool_path_stretcher/stretcher.h"
#include "views/views.h"

namespace tool_path_stretcher {

/// The work on one path: finds the part's pose and deformation, judges both, and places the
/// waypoints.
class Adaptation {
 public:
  /// @throw Refusal if the path makes no sense
  Adaptation(const SurfacePair& surfaces, const ToolPath& path, const StretchParameters& parameters,
             const Stages& stages);

  /// Fills in the attempt as far as the work gets.
  /// @throw Refusal
  void run(Attempt& attempt);

 private:
  /// There is no path, so poses do not differ in anything that matters.
  bool lays_only() const { return path_.segments.empty(); }

  Fitted explained(const Mapping& mapping) const;

  /// The mappings that the prior allows.
  std::vector<Fitted> allowed(const std::vector<Mapping>& mappings) const;

  /// If the object covers too little of an open reference, counts only what a scan from there can
  /// show.
  void count_what_could_be_seen(Fitted& fitted) const;

  /// All poses that may explain the object, best first.
  /// @throw Refusal if there is none
  std::vector<Candidate> search();

  /// The mappings made from the candidates, best first.
  std::vector<Fitted> choose(const std::vector<Candidate>& candidates) const;

  /// Judges the pose from the thesis' registration against those from the search.
  /// @throw Refusal
  void put_registration_first(std::vector<Fitted>& fitted) const;

  /// The candidates that may still win, with a coarse deformation graph, best first. A pose is
  /// judged with a graph so that a bend does not decide between two poses that a small feature
  /// tells apart.
  std::vector<Fitted> sketched(const std::vector<Candidate>& candidates) const;

  /// Fits the finest deformation graph and sorts again.
  void deform(std::vector<Fitted>& fitted) const;

  /// The search may end beside the right place if the part can slide along itself, like an
  /// extrusion. Moves the best mapping on as long as a slid one is clearly better. Not for the
  /// thesis' methods.
  /// @return the places it may still slide to; empty if it explains too little of the object
  std::vector<Fitted> slide_on(Fitted& best) const;

  /// @param slid as returned by slide_on()
  /// @return the best and the others that explain the object as well, if they lay the path along
  /// the same line; empty if there are no others
  /// @throw Refusal if the best does not explain the object, or another one explains it too
  std::vector<PoseCandidate> check_choice(const std::vector<Fitted>& fitted,
                                          const std::vector<Fitted>& slid, bool partial_reference);

  Mapping affine_mapping(const Similarity& start) const;

  void adapt(const Mapping& mapping, StretchResult& result) const;

  const SurfacePair surfaces_;
  const ToolPath path_;
  const StretchParameters& parameters_;
  const Stages& stages_;
  const Eigen::Vector3d centroid_;  // of the reference [m]
  PartialSearch partial_;
};

}  // namespace tool_path_stretcher
