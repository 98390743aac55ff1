// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// Flange (tool0) in base_link of a Comau Smart5 SiX: the chain of urdf/smart5_six.urdf, lengths
/// and signs of the data sheet.
/// @param joints [rad]
Eigen::Isometry3d flange_at(const Joints& joints);

}  // namespace c4g_driver
