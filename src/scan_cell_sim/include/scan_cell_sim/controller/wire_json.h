// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scan_cell_sim/controller/wire_pose.h"

/// Values out of requests. Each throws ControllerRefusal, naming what is missing or makes no sense.
namespace scan_cell_sim {

const nlohmann::json& entry(const nlohmann::json& request, const std::string& name);
double number(const nlohmann::json& value, const std::string& name, double least, double most);
std::string text(const nlohmann::json& value, const std::string& name);
WireSix six(const nlohmann::json& value, const std::string& name);
bool truth(const nlohmann::json& value, const std::string& name);
std::uint64_t whole(const nlohmann::json& value, const std::string& name);

}  // namespace scan_cell_sim
