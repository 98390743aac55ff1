// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "c4g_driver/client.h"
#include "wire/wire_units.h"

/// The commands of the tool `c4g`. Each prints its result in the units of the wire and the pendant,
/// millimetres and degrees, and throws scan_cell_common::Error on failure.
namespace c4g_driver {

/// @param patience [s]
/// @throw scan_cell_common::ConnectionError if there is no link by then
/// @throw scan_cell_common::Refused if interrupted meanwhile
void wait_for_link(const Client& client, double patience);

void show_state(const Client& client);
void show_alarms(const Client& client);

/// Each waits for the motion's end; an interrupt (scan_cell_common::CatchInterrupts) stops the
/// robot first.
/// @param pose [mm, deg]
/// @param camera_rate [Hz]
void move_to_pose(Client& client, const WireSix& pose, double camera_rate);
/// @param via, pose [mm, deg]
void move_along_arc(Client& client, const WireSix& via, const WireSix& pose, double camera_rate);
/// @param joints [deg]
void move_to_joints(Client& client, const WireSix& joints, double camera_rate);

/// Returns when the robot stands.
void stop(Client& client);

void show_parameter(Client& client, const std::string& name);
/// @param value JSON, or a word, which is taken as a string
void write_parameter(Client& client, const std::string& name, const std::string& value);

}  // namespace c4g_driver
