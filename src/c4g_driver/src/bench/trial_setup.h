// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "c4g_driver/client.h"
#include "scan_cell_sim/controller/controller.h"

/// Setup of trials of the client against the emulated controller.
namespace c4g_driver {

constexpr double kPatience = 30;  // [s] chosen

/// Patient with a busy machine; a retry every 5 ms.
ClientOptions options_for(const scan_cell_sim::Controller& controller,
                          const std::shared_ptr<const RobotModel>& robot);

/// @throw scan_cell_common::ConnectionError if the link does not come up
void wait_for_link(const Client& client);

/// A pose of the flange that the robot reaches, as it does all poses within 0.3 m of it. @param y
/// [m]
Eigen::Isometry3d looking_down(double y);

}  // namespace c4g_driver
