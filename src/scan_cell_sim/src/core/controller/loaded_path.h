// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scan_cell_sim/controller/path.h"

namespace scan_cell_sim {

/// The path of the tool that a session loaded, or the part that has arrived.
class LoadedPath {
 public:
  LoadedPath() = default;  // none is loaded

  /// @param request LOAD_PATH
  /// @throw ControllerRefusal
  explicit LoadedPath(const nlohmann::json& request);

  /// @param request PATH_PIECE
  /// @throw ControllerRefusal if it belongs to another path, is out of turn, or a value is out of
  /// range; then nothing has changed
  void add(const nlohmann::json& request);

  /// @param request FOLLOW_PATH
  /// @return the first waypoint
  /// @throw ControllerRefusal unless the whole path has arrived and is the one asked for
  std::size_t check(const nlohmann::json& request) const;

  const Eigen::Isometry3d& flange_to_tip() const { return flange_to_tip_; }
  const std::vector<TipWaypoint>& waypoints() const { return waypoints_; }
  std::uint32_t checksum() const;

 private:
  void require(const nlohmann::json& request) const;
  void seal(const nlohmann::json& request);

  std::uint64_t number_ = 0;  // 0: none
  std::uint64_t size_ = 0;    // waypoints once it is whole
  Eigen::Isometry3d flange_to_tip_ = Eigen::Isometry3d::Identity();
  std::vector<TipWaypoint> waypoints_;
  std::string seals_;  // the checksums of its datagrams, each with a comma
};

}  // namespace scan_cell_sim
