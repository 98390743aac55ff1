// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/verdict.h"

namespace tool_path_stretcher {

std::string to_string(Reason reason) {
  switch (reason) {
    case Reason::kAccepted:
      return "accepted";
    case Reason::kUnusableInput:
      return "unusable_input";
    case Reason::kTooFewPoints:
      return "too_few_points";
    case Reason::kPathOffReference:
      return "path_off_reference";
    case Reason::kWrongPart:
      return "wrong_part";
    case Reason::kAmbiguous:
      return "ambiguous";
    case Reason::kScaleAtBound:
      return "scale_at_bound";
    case Reason::kPathNotScanned:
      return "path_not_scanned";
    case Reason::kToleranceExceeded:
      return "tolerance_exceeded";
    case Reason::kCancelled:
      return "cancelled";
    case Reason::kFoldOver:
      return "fold_over";
    case Reason::kMirroredPart:
      return "mirrored_part";
    case Reason::kOrientationUncertain:
      return "orientation_uncertain";
    case Reason::kPositionUncertain:
      return "position_uncertain";
  }
  return "unknown";
}

}  // namespace tool_path_stretcher
