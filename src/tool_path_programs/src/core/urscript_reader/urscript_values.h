// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tool_path_programs/program.h"
#include "tool_path_programs/source_text.h"

namespace tool_path_programs {

/// A pose in a script, p[x, y, z, rx, ry, rz], and its place in the text.
struct PoseLiteral {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // [m]
  Place place;
  std::size_t offset = 0;   // of the p
  bool has_numbers = true;  // false: one of the six is computed
};

/// The value of an expression of a script, where the text gives it.
struct ScriptValue {
  enum class Kind {
    kComputed,  // at run time
    kFree,      // a variable that the files never set
    kNumber,
    kTruth,
    kPose,
    kJoints,
  };
  Kind kind = Kind::kComputed;
  std::string name;                         // of the variable that holds it; empty: none
  double number = 0;                        // of kNumber; of kTruth 0 or 1
  PoseLiteral pose;                         // of kPose
  Frame user;                               // of kPose: its frame
  std::optional<PoseLiteral> user_literal;  // where the text has that frame
  std::vector<double> joints;               // of kJoints; empty: some are computed

  bool is(Kind wanted) const { return kind == wanted; }
};

/// The variables of a script while it runs.
class ScriptVariables {
 public:
  /// The variable's value, or kFree.
  ScriptValue value(const std::string& name) const;

  /// Assigns where the variable is known, or else in the running function.
  void assign(const std::string& name, ScriptValue value);
  void assign_globally(const std::string& name, ScriptValue value);
  void assign_locally(const std::string& name, ScriptValue value);

  /// From here on its value is computed.
  void forget(const std::string& name);
  /// Its value is computed at all times: a thread sets it.
  void forget_for_ever(const std::string& name) { changing_.insert(name); }

  using Locals = std::map<std::string, ScriptValue>;
  /// Sets the variables of a function that begins.
  /// @return those of its caller
  std::optional<Locals> begin_function(Locals parameters);
  void end_function(std::optional<Locals> of_caller) { locals_ = std::move(of_caller); }

 private:
  std::map<std::string, ScriptValue> globals_;
  std::optional<Locals> locals_;  // none: the main program runs
  std::set<std::string> changing_;
};

}  // namespace tool_path_programs
