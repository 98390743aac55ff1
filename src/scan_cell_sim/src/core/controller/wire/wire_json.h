// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "controller/arm/wire_pose.h"

namespace scan_cell_sim {

/// The datagram of a packet: its text, with the CRC-32 of everything before it as the last entry.
std::string sealed(const nlohmann::json& packet);

/// The object in a datagram; none if it is not one, or its checksum is wrong.
std::optional<nlohmann::json> unsealed(const std::string& datagram);

// Values from requests. Each throws ControllerRefusal, naming what is missing or invalid.

const nlohmann::json& entry(const nlohmann::json& request, const std::string& name);
double number(const nlohmann::json& value, const std::string& name, double least, double most);
std::string text(const nlohmann::json& value, const std::string& name);
WireSix six(const nlohmann::json& value, const std::string& name);
/// x, y, z, A, E, R in the accepted ranges.
WireSix pose(const nlohmann::json& value, const std::string& name);
bool truth(const nlohmann::json& value, const std::string& name);
std::uint64_t whole(const nlohmann::json& value, const std::string& name);

}  // namespace scan_cell_sim
