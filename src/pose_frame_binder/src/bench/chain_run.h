// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "profile_feeder.h"

namespace pose_frame_binder {

/// Feeds binder and triangulation and prints the result.
/// @param program path of this program; the nodes are in the same folder
/// @param kind "nodelets": in this process; "nodes": each in its own
/// @return exit code
int run_chain(const std::string& program, const std::string& kind, const Pace& pace);

/// The baseline: the same profiles through two nodes that only pass them on.
int run_relays(const std::string& program, const Pace& pace);

/// Runs one of these nodes until it is stopped.
int relay(const std::string& from, const std::string& to);

}  // namespace pose_frame_binder
