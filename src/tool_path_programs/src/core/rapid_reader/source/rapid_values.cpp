// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/source/rapid_values.h"

#include <algorithm>
#include <map>

#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

bool read_bool(TokenReader& reader) {
  if (reader.accept("TRUE")) return true;
  reader.expect("FALSE");
  return false;
}

std::optional<double> named(const std::map<std::string, double>& values, const std::string& name) {
  const auto found = values.find(lower_case(name));
  if (found == values.end()) return std::nullopt;
  return found->second;
}

}  // namespace

std::vector<Token> rapid_tokens(const SourceFile& file) {
  std::vector<Token> tokens = tokens_of(file, {{"!"}, "\"", ""});
  tokens.erase(std::remove_if(tokens.begin(), tokens.end(),
                              [](const Token& token) {
                                return token.kind == TokenKind::kComment ||
                                       token.kind == TokenKind::kLineEnd;
                              }),
               tokens.end());
  return tokens;
}

void pass_over_brackets(TokenReader& reader) {
  std::size_t depth = 0;
  do {
    if (reader.at_end()) reader.fail("the file ends within a statement", "give all of it");
    if (reader.at_symbol('[') || reader.at_symbol('(') || reader.at_symbol('{')) ++depth;
    if ((reader.at_symbol(']') || reader.at_symbol(')') || reader.at_symbol('}')) && depth > 0)
      --depth;
    reader.next();
  } while (depth > 0);
}

Eigen::Isometry3d RapidPose::pose() const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = 1e-3 * Eigen::Vector3d(numbers[0].value, numbers[1].value, numbers[2].value);
  const Eigen::Quaterniond turn(numbers[3].value, numbers[4].value, numbers[5].value,
                                numbers[6].value);
  pose.linear() =
      scan_cell_common::rotation_from(turn, where, "give a unit quaternion q1 q2 q3 q4");
  return pose;
}

RapidPose read_rapid_pose(TokenReader& reader) {
  RapidPose pose;
  pose.where = reader.where();
  reader.expect('[');
  for (std::size_t i = 0; i < pose.numbers.size(); ++i) {
    reader.expect(i == 0 || i == 3 ? '[' : ',');
    pose.numbers[i] = reader.number();
    if (i == 2) {
      reader.expect(']');
      reader.expect(',');
    }
  }
  reader.expect(']');
  return pose;
}

std::optional<Eigen::Isometry3d> read_tooldata(TokenReader& reader) {
  reader.expect('[');
  const bool robot_holds_tool = read_bool(reader);
  reader.expect(',');
  const Eigen::Isometry3d tip = read_rapid_pose(reader).pose();
  if (!robot_holds_tool) return std::nullopt;
  return tip;
}

std::optional<Eigen::Isometry3d> read_wobjdata(TokenReader& reader) {
  reader.expect('[');
  const bool robot_holds_part = read_bool(reader);
  reader.expect(',');
  const bool fixed = read_bool(reader);
  reader.expect(',');
  pass_over_brackets(reader);  // the machine that moves the work object
  reader.expect(',');
  const Eigen::Isometry3d user = read_rapid_pose(reader).pose();
  reader.expect(']');
  reader.expect(',');
  const Eigen::Isometry3d object = read_rapid_pose(reader).pose();
  if (robot_holds_part || !fixed) return std::nullopt;
  return user * object;
}

double read_speeddata(TokenReader& reader) {
  reader.expect('[');
  return reader.number().value;
}

double read_zonedata(TokenReader& reader) {
  reader.expect('[');
  if (read_bool(reader)) return 0;
  reader.expect(',');
  return reader.number().value;
}

std::optional<double> predefined_speed(const std::string& name) {
  static const std::map<std::string, double> speeds = [] {
    std::map<std::string, double> values = {{"vmax", 5000}};
    for (const int speed : {5,   10,  20,  30,   40,   50,   60,   80,   100,  150,  200,  300, 400,
                            500, 600, 800, 1000, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7000})
      values["v" + std::to_string(speed)] = speed;
    return values;
  }();
  return named(speeds, name);
}

std::optional<double> predefined_zone(const std::string& name) {
  static const std::map<std::string, double> zones = [] {
    std::map<std::string, double> values = {{"fine", 0}, {"z0", 0.3}};
    for (const int zone : {1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200})
      values["z" + std::to_string(zone)] = zone;
    return values;
  }();
  return named(zones, name);
}

std::vector<double> read_jointtarget(TokenReader& reader) {
  std::vector<double> joints;
  reader.expect('[');
  reader.expect('[');
  do {
    joints.push_back(reader.number().value);
  } while (reader.accept(','));
  reader.expect(']');
  return joints;
}

}  // namespace tool_path_programs
