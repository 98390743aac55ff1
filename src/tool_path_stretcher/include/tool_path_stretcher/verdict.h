// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// Whether an adapted path may be used, and why not. The numbers are StretchVerdict.msg's.
enum class Reason {
  kAccepted = 1,
  kUnusableInput = 2,
  kTooFewPoints = 3,
  kPathOffReference = 4,
  kWrongPart = 5,
  kAmbiguous = 6,
  kScaleAtBound = 7,
  kPathNotScanned = 8,
  kToleranceExceeded = 9,
  kCancelled = 10,
  kFoldOver = 11,
  kMirroredPart = 12,
  kOrientationUncertain = 13,
  kPositionUncertain = 14,
};

/// Lower case with underscores, as in reports.
std::string to_string(Reason reason);

/// A pose that explains the object, and where it would put the path.
struct PoseCandidate {
  Similarity similarity;  //!< reference to object
  Points waypoints;       //!< [m] in the object's frame, over all segments
};

/// The message of an accepted path; details may follow it.
constexpr char kAdapted[] = "the path was adapted";

/// Accepted, or the reason to refuse.
struct Verdict {
  Reason reason = Reason::kAccepted;   //!< kAccepted, or why not
  std::string message;                 //!< kAdapted, or the thing, the value and the cure
  std::vector<std::size_t> waypoints;  //!< concerned, counted over all segments
  /// Ambiguous: the poses that nothing tells apart, best first. Accepted: the pose taken and the
  /// others that explain the object as well and lay the path along the same line, if any.
  std::vector<PoseCandidate> candidates = {};

  bool accepted() const { return reason == Reason::kAccepted; }  //!< whether there is a path
};

/// Thrown to end the work with a verdict; stretch() catches it.
struct Refusal {
  Verdict verdict;  //!< the refusal and its reason
};

}  // namespace tool_path_stretcher
