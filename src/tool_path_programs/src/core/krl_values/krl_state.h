// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "krl_values/krl_variables.h"
#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Settings that earlier statements made for a motion.
struct KrlSettings {
  Frames frames;
  std::optional<double> speed;        // [m/s]
  std::optional<double> joint_speed;  // share
  double zone = 0;                    // [m] used if a motion flies by
  std::string fdat, ldat;             // names that BAS(#CP_PARAMS, ..) takes
};

/// Reads the statements that change the settings: assignments of $TOOL, $BASE, $VEL, $APO; BAS;
/// WITH.
class KrlSetter {
 public:
  KrlSetter(const KrlVariables& variables, const ReadSettings& known)
      : variables_(variables), known_(known) {}

  KrlSettings settings;

  /// Reads from after the variable's name, such as $VEL, to the end of the value.
  void assign(const std::string& variable, TokenReader& reader);

  /// Reads from after BAS to the end of the line.
  void bas(TokenReader& reader);

  /// Reads from after WITH: $VEL=SVEL_CP(0.5, , LCPDAT1), $TOOL=STOOL2(FP1), ...
  void with(TokenReader& reader);

 private:
  void set_frame(TokenReader& reader, bool tool);
  Frame frame(TokenReader& reader, bool tool);
  Frame numbered(const std::string& array, double number) const;
  Frame of_fdat(const std::string& name, bool tool, const Place& place) const;
  Frame unknown(TokenReader& reader, std::size_t begin) const;
  void set_speed(const std::string& field, TokenReader& reader);
  void set_zone(const std::string& field, TokenReader& reader);
  void set_axis_speed(TokenReader& reader);
  void set_speed(const std::optional<double>& speed);
  void set_joint_speed(const std::optional<double>& percent);
  void take_fdat(const Place& place);
  bool with_call(TokenReader& reader);
  std::optional<double> number(TokenReader& reader) const;
  std::optional<double> of_data(const std::string& name, const std::string& field) const;

  const KrlVariables& variables_;
  const ReadSettings& known_;
};

}  // namespace tool_path_programs
