// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "pdl2_reader/pdl2_source.h"
#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Values of names while a program runs.
class Pdl2Variables {
 public:
  Pdl2Variables(const Pdl2Source& source, const ReadSettings& known);

  void enter(const Pdl2Body& body) { bodies_.push_back({&body, {}}); }
  void leave() { bodies_.pop_back(); }
  const Pdl2Body& body() const { return *bodies_.back().body; }

  void assign(const std::string& name, const Pdl2Value& value);

  /// null: no value is known from the files.
  const Pdl2Value* find(const std::string& name) const;

  /// "jointpos"; empty: not declared.
  std::string type(const std::string& name) const;

  /// A variable that holds a frame: its name, with the program that holds it, and its place if
  /// known.
  Frame frame(const std::string& name) const;

 private:
  struct Scope {
    const Pdl2Body* body;
    std::map<std::string, Pdl2Value> values;
  };
  std::string key(const std::string& name) const;

  const Pdl2Source& source_;
  const ReadSettings& known_;
  std::map<std::string, Pdl2Value> data_;
  std::vector<Scope> bodies_;
};

/// Settings that earlier statements made for a motion.
struct Pdl2Settings {
  Frame tool, uframe;
  std::optional<Frame> base;
  std::string move_type = "joint";
  std::optional<double> speed;  // [m/s]
  double program_override = 1;
  double arm_override = 1;
  double fly_distance = 0;  // [m]

  Frames frames() const;
};

/// Reads an assignment from after its := or =; false if the variable is not a setting.
bool set(Pdl2Settings& settings, const std::string& variable, TokenReader& reader,
         const Pdl2Variables& variables);

}  // namespace tool_path_programs
