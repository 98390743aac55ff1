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

/// The work on one path: the pose of the part, its deformation, the judgement of both, and the
/// placement of the waypoints.
class Adaptation {
 public:
  /// @throw Refusal if the path makes no sense
  Adaptation(const SurfacePair& surfaces, const ToolPath& path, const StretchParameters& parameters,
             const Stages& stages);

  /// Fills in the attempt as far as the work comes.
  /// @throw Refusal
  void run(Attempt& attempt);

 private:
  /// There is no path: poses differ in nothing that matters.
  bool lays_only() const { return path_.segments.empty(); }

  Fitted explained(const Mapping& mapping) const;

  /// Those that what is known of pose and scale allows.
  std::vector<Fitted> allowed(const std::vector<Mapping>& mappings) const;

  /// Where the object covers too little of an open reference: of what a scan from there can show.
  void count_what_could_be_seen(Fitted& fitted) const;

  /// All poses that may explain the object, best first.
  /// @throw Refusal if there is none
  std::vector<Candidate> search();

  /// The mappings that they become, best first.
  std::vector<Fitted> choose(const std::vector<Candidate>& candidates) const;

  /// What the thesis' registration finds, judged beside what the search found.
  /// @throw Refusal
  void put_registration_first(std::vector<Fitted>& fitted) const;

  /// The candidates that may yet win with a coarse deformation graph, best first. A pose is judged
  /// with a graph: a bend must not decide between two poses that a small feature tells apart.
  std::vector<Fitted> sketched(const std::vector<Candidate>& candidates) const;

  /// Fits the finest deformation graph, and sorts again.
  void deform(std::vector<Fitted>& fitted) const;

  /// The search may end beside the right place where a part, as an extruded one, can slide along
  /// itself: there the best goes on for as long as a slid one is clearly better. Not the thesis'.
  /// @return where it may yet slide to; nothing where it explains too little of the object
  std::vector<Fitted> slide_on(Fitted& best) const;

  /// @param slid as slide_on() gives them
  /// @return the best and the others that explain the object as well, where those lay the path
  /// along the same line; nothing where there are none
  /// @throw Refusal if the best does not explain the object, or another one does, too
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
