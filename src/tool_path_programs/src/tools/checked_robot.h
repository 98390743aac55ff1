// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "c4g_driver/limits.h"
#include "c4g_driver/robot_model.h"
#include "c4g_driver/tool_check.h"
#include "c4g_driver/tool_motion.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "tool_path_programs/export_options.h"

namespace tool_path_programs {

/// Options for the robot that will run the program.
struct RobotOptions {
  std::string urdf;                       //!< empty: no check
  std::string base = "base_link";         //!< link of the URDF
  std::string flange = "flange";          //!< link of the URDF
  std::vector<double> start;              //!< [rad] joints near the first posture; empty: all 0
  std::string shapes;                     //!< YAML of what may collide; empty: nothing
  c4g_driver::RobotLimits limits;         //!< in addition to the URDF's
  c4g_driver::ToolCheckParameters check;  //!< of the path

  /// Declares the options; call it before the command line is parsed.
  void add(CLI::App& app);

  scan_cell_common::ParameterOptions typed;
};

/// A six-axis arm described by a URDF.
class CheckedRobot : public ProgramRobot {
 public:
  /// @throw scan_cell_common::Error if a file is unusable
  explicit CheckedRobot(RobotOptions options);

  std::vector<std::string> check(Program& program) const override;

  const std::array<std::string, 6>& joint_names() const { return model_.joint_names(); }
  double rotational_speed() const { return options_.check.rotational_speed; }  //!< [rad/s]

 private:
  const RobotOptions options_;
  const c4g_driver::RobotModel model_;
};

}  // namespace tool_path_programs
