// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/shared_ptr.hpp>

#include "sequence/devices.h"

namespace scan_cell {

/// How a motion ended that did not reach its target.
/// @param result of the driver's action move or follow; null: the driver is gone
template <class Result>
Motion motion_of(const boost::shared_ptr<const Result>& result) {
  if (!result) return {Motion::State::kLost, 0, ""};
  Motion motion{Motion::State::kFailed, 0, result->message};
  if (result->outcome == Result::LINK_LOST) motion.state = Motion::State::kLost;
  if (result->outcome == Result::STOPPED) motion.state = Motion::State::kStopped;
  return motion;
}

}  // namespace scan_cell
