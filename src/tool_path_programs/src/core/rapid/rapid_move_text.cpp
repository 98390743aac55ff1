// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid/rapid_move_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr int kDigits = 4;            // of mm and mm/s
constexpr int kQuaternionDigits = 8;  // more than a controller's number holds
constexpr double kFastest = 7;        // [m/s] of v7000, the fastest predefined speed

constexpr std::array kSpeeds = {"5",    "10",   "20",   "30",   "40",   "50",   "60",
                                "80",   "100",  "150",  "200",  "300",  "400",  "500",
                                "600",  "800",  "1000", "1500", "2000", "2500", "3000",
                                "4000", "5000", "6000", "7000"};
constexpr std::array kZones = {"1",  "5",  "10", "15",  "20",  "30", "40",
                               "50", "60", "80", "100", "150", "200"};

template <class Texts>
bool is_one_of(const std::string& text, const Texts& texts) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::string waypoint_name(std::size_t waypoint) {
  return "RAPID, waypoint " + std::to_string(waypoint);
}

/// The quarter turn that an axis is in.
int quarter(double angle) {
  return static_cast<int>(std::floor(angle / (M_PI / 2)));
}

std::string configuration(const std::optional<JointAngles>& joints) {
  if (!joints) return "[0,0,0,0]";
  return fmt::format("[{},{},{},{}]", quarter((*joints)[0]), quarter((*joints)[3]),
                     quarter((*joints)[5]), (*joints)[4] < 0 ? 1 : 0);
}

}  // namespace

std::string rapid_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d place = 1e3 * pose.translation();
  Eigen::Quaterniond turn(pose.linear());
  turn.normalize();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return fmt::format("[[{},{},{}],[{},{},{},{}]]", fixed(place.x(), kDigits),
                     fixed(place.y(), kDigits), fixed(place.z(), kDigits),
                     fixed(turn.w(), kQuaternionDigits), fixed(turn.x(), kQuaternionDigits),
                     fixed(turn.y(), kQuaternionDigits), fixed(turn.z(), kQuaternionDigits));
}

std::string rapid_robtarget(const Eigen::Isometry3d& pose,
                            const std::optional<JointAngles>& joints) {
  std::string text = rapid_pose(pose);
  text.pop_back();
  return text + "," + configuration(joints) + ",[9E9,9E9,9E9,9E9,9E9,9E9]]";
}

std::string rapid_speed(double speed, double max_change, std::size_t waypoint) {
  const double wanted = 1e3 * speed;
  if (speed > kFastest)
    throw UnusableInput(waypoint_name(waypoint), fmt::format("speed {:g} mm/s", wanted),
                        "give at most 7000 mm/s, the fastest that RAPID has a name for");
  const std::string text = shortest(wanted, kDigits);
  const double said = *scan_cell_common::parse_number(text);
  if (!(said > 0) || std::abs(said - wanted) > max_change * wanted)
    throw UnusableInput(waypoint_name(waypoint),
                        fmt::format("speed {:g} mm/s, which would become {} mm/s", wanted, text),
                        "give a greater speed, or a greater max_speed_change");
  if (is_one_of(text, kSpeeds)) return "v" + text;
  return "[" + text + ",500,5000,1000]";
}

std::string rapid_zone(double radius, std::size_t waypoint) {
  if (radius == 0) return "fine";
  const double wanted = 1e3 * radius;
  const std::string text = shortest(wanted, kDigits);
  if (text == "0")
    throw UnusableInput(waypoint_name(waypoint), fmt::format("zone {:g} mm", wanted),
                        "give 0, where the tool stops, or a greater one");
  if (is_one_of(text, kZones)) return "z" + text;
  if (text == "0.3") return "z0";
  // As in predefined zones, the tool turns within 1.5 times the radius, at a tenth of it in
  // degrees.
  return fmt::format("[FALSE,{0},{1},{1},{2},{1},{2}]", text, shortest(1.5 * wanted, kDigits),
                     shortest(0.15 * wanted, kDigits + 1));
}

}  // namespace tool_path_programs
