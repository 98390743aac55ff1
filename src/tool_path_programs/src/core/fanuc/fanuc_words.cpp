// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc/fanuc_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fanuc_reader/fanuc_angles.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr int kDigits = 3;                 // as controllers write them
constexpr double kFastest = 2;             // [m/s]
constexpr double kMostMillimetres = 1000;  // of a corner region

struct Unit {
  const char* name;
  double metres_per_second;
  int digits;
};

constexpr std::array<Unit, 3> kUnits = {
    {{"mm/sec", 1e-3, 0}, {"cm/min", 1e-2 / 60, 0}, {"inch/min", 0.0254 / 60, 1}}};

std::string waypoint_name(std::size_t waypoint) {
  return "FANUC TP, waypoint " + std::to_string(waypoint);
}

double number_of(const std::string& text) {
  return *scan_cell_common::parse_number(text);
}

bool is_of_names(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || character == '_';
}

bool begins_names(char character) {
  return is_of_names(character) && character != '_' && !(character >= '0' && character <= '9');
}

/// Number of whole turns of an axis, counted from the middle of the first.
int turns(double angle) {
  return static_cast<int>(std::round(angle / (2 * M_PI)));
}

std::string configuration(const std::optional<JointAngles>& joints) {
  if (!joints) return "'N U T, 0, 0, 0'";
  return fmt::format("'N U T, {}, {}, {}'", turns((*joints)[0]), turns((*joints)[3]),
                     turns((*joints)[5]));
}

std::string position(std::size_t index, const std::string& frames, const std::string& numbers) {
  return fmt::format("P[{}]{{\r\n   GP1:\r\n\tUF : {}\r\n{}\r\n}};\r\n", index, frames, numbers);
}

}  // namespace

std::string fanuc_speed(double speed, double max_change, std::size_t waypoint) {
  std::string best;
  double least = INFINITY;
  for (const Unit& unit : kUnits) {
    const std::string text = shortest(speed / unit.metres_per_second, unit.digits);
    const double change = std::abs(number_of(text) * unit.metres_per_second - speed) / speed;
    if (text == "0" || change >= least - 1e-9) continue;
    least = change;
    best = text + (unit.digits > 0 && text.find('.') == std::string::npos ? ".0" : "") + unit.name;
  }
  if (speed > kFastest)
    throw UnusableInput(waypoint_name(waypoint), fmt::format("speed {:g} mm/s", 1e3 * speed),
                        "give at most 2000 mm/s");
  if (best.empty() || least > max_change)
    throw UnusableInput(
        waypoint_name(waypoint),
        fmt::format("speed {:g} mm/s, which would become {}", 1e3 * speed,
                    best.empty() ? "0" : best),
        "whole mm/sec, whole cm/min and tenths of inch/min are possible: give one of these, or a "
        "greater max_speed_change");
  return best;
}

std::string fanuc_share(double share, double max_change, std::size_t waypoint) {
  const std::string text = fixed(100 * share, 0);
  if (text == "0" || std::abs(number_of(text) / 100 - share) > max_change * share)
    throw UnusableInput(
        waypoint_name(waypoint),
        fmt::format("{:g} % of the axes' speed, which would become {} %", 100 * share, text),
        "give a whole number of percent");
  return text + "%";
}

std::string fanuc_zone(double zone, bool corner_regions, std::size_t waypoint) {
  if (zone == 0) return "FINE";
  if (!corner_regions) return "CNT100";
  const double wanted = 1e3 * zone;
  const std::string text = fixed(wanted, 0);
  if (text == "0" || std::abs(number_of(text) - wanted) > 1e-6 || wanted > kMostMillimetres)
    throw UnusableInput(waypoint_name(waypoint), fmt::format("zone {:g} mm", wanted),
                        "a corner region is a whole number of mm to 1000; give one, or 0");
  return "CR" + text;
}

std::string fanuc_position(std::size_t index, const Eigen::Isometry3d& pose,
                           const std::optional<JointAngles>& joints, int user, int tool) {
  const FanucPose numbers = fanuc_pose(pose, {kDigits, kDigits, kDigits});
  std::array<std::string, 6> texts;
  for (std::size_t i = 0; i < texts.size(); ++i)
    texts[i] = fixed(numbers[i], kDigits);
  return position(index,
                  fmt::format("{}, UT : {},\t\tCONFIG : {},", user, tool, configuration(joints)),
                  fmt::format("\tX = {:>9}  mm,\tY = {:>9}  mm,\tZ = {:>9}  mm,\r\n"
                              "\tW = {:>9} deg,\tP = {:>9} deg,\tR = {:>9} deg",
                              texts[0], texts[1], texts[2], texts[3], texts[4], texts[5]));
}

std::string fanuc_joint_position(std::size_t index, const std::vector<double>& joints, int user,
                                 int tool) {
  std::string numbers;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string text = fixed(joints[i], kDigits);
    if (number_of(text) != joints[i])
      throw UnusableInput("FANUC TP, joint move", fmt::format("{} degrees", joints[i]),
                          "give angles with three digits behind the point");
    numbers +=
        fmt::format("{}{}J{}= {:>9} deg", i == 0 ? "" : ",", i == 3 ? "\r\n\t" : "\t", i + 1, text);
  }
  return position(index, fmt::format("{}, UT : {},", user, tool), numbers);
}

void check_fanuc_name(const std::string& name, std::size_t longest) {
  std::string better;
  for (const char character : name)
    better += is_of_names(character) ? character : '_';
  if (better.empty() || !begins_names(better.front())) better = "P" + better;
  better = better.substr(0, longest);
  if (better == name) return;
  throw UnusableInput(
      "program '" + scan_cell_common::excerpt(name) + "'",
      fmt::format("FANUC names begin with a letter and have at most {} ASCII letters, digits "
                  "and _",
                  longest),
      "name it " + better + ", for example");
}

int fanuc_frame_number(const Frame& frame, const std::string& thing, int most) {
  const auto number = scan_cell_common::parse_count(frame.name);
  if (!number || *number > static_cast<std::uint64_t>(most))
    throw UnusableInput(
        "FANUC TP, " + thing,
        frame.name.empty() ? "no number" : "'" + scan_cell_common::excerpt(frame.name) + "'",
        fmt::format("give its number on the controller, 0 to {}; 0 is {}", most,
                    thing == "tool" ? "the flange" : "the world frame"));
  if (*number == 0 && frame.pose && !frame.pose->isApprox(Eigen::Isometry3d::Identity(), 1e-9))
    throw UnusableInput("FANUC TP, " + thing, "0, which is fixed, and not at this pose",
                        "give it another number");
  return static_cast<int>(*number);
}

}  // namespace tool_path_programs
