// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "controller/motion/motion_control.h"

namespace scan_cell_sim {

/// The controller's parameters by name, in wire units; c4g_protocol.md lists them.
class ControllerParameters {
 public:
  /// @param stream_period [s]
  ControllerParameters(MotionControl& motion, double stream_period);

  /// A value that was set reads back exactly.
  /// @throw ControllerRefusal if there is no such parameter
  const nlohmann::json& get(const std::string& name) const;

  /// @throw ControllerRefusal if there is no such parameter, it is read-only, or the value is
  /// invalid
  void set(const std::string& name, const nlohmann::json& value, scan_cell_common::Nanoseconds now);

  double stream_period() const { return stream_period_; }  //!< [s]

 private:
  void set_motion(const std::string& name, const nlohmann::json& value,
                  scan_cell_common::Nanoseconds now);

  MotionControl& motion_;
  double stream_period_;
  std::map<std::string, nlohmann::json> values_;
};

}  // namespace scan_cell_sim
