// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/tool_path_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pass_planner {

using tool_path_programs::place_on_path;
namespace {

using c4g_driver::JointMargin;
using c4g_driver::ToolCheck;
using c4g_driver::ToolFault;
using Json = nlohmann::ordered_json;

template <class Vector>
Json list(const Vector& vector) {
  if (!vector.allFinite()) return nullptr;  // JSON knows no NaN
  return std::vector<double>(vector.begin(), vector.end());
}

Json waypoint_of(const PathForRobot& path, std::size_t step) {
  return path.waypoint[step] ? Json(*path.waypoint[step]) : Json(nullptr);
}

Json to_json(const PathForRobot& path, const ToolFault& fault) {
  return {{"waypoint", waypoint_of(path, fault.waypoint)},
          {"step", fault.waypoint},
          {"way", fault.way},
          {"kind", to_string(fault.kind)},
          {"joint", fault.joint ? Json(*fault.joint + 1) : Json(nullptr)},
          {"position", list(Eigen::Vector3d(fault.tip.translation()))},
          {"message", fault_text(path, fault)}};
}

Json slowest_of(const PathForRobot& path, const ToolCheck& check) {
  if (!check.slowest) return nullptr;
  return {{"waypoint", waypoint_of(path, check.slowest->waypoint)},
          {"step", check.slowest->waypoint},
          {"way", check.slowest->way},
          {"speed", check.slowest->speed},
          {"wanted", check.slowest->wanted}};
}

}  // namespace

std::string fault_text(const PathForRobot& path, const ToolFault& fault) {
  return place_on_path(path.waypoint, fault.waypoint, fault.way) +
         (fault.about.empty() ? "" : ", " + fault.about) + ": " + fault.value + "; " + fault.cure;
}

std::string tool_check_to_json(const PathForRobot& path, const ToolCheck& check,
                               const std::string& approach) {
  Json report = {{"possible", check.possible() && approach.empty()}, {"approach", approach}};
  report["faults"] = Json::array();
  for (const ToolFault& fault : check.faults)
    report["faults"].push_back(to_json(path, fault));
  report["slowest"] = slowest_of(path, check);
  report["margins"] = Json::array();
  for (const JointMargin& margin : check.margins)
    report["margins"].push_back(std::isfinite(margin.margin) ? Json(margin.margin) : Json(nullptr));
  report["steps"] = Json::array();
  for (std::size_t i = 0; i < check.joints.size(); ++i)
    report["steps"].push_back(
        {{"waypoint", waypoint_of(path, i)}, {"joints", list(check.joints[i])}});
  return report.dump(1) + "\n";
}

std::string summary_of(const PathForRobot& path, const ToolCheck& check,
                       const std::string& approach) {
  std::string text;
  for (const ToolFault& fault : check.faults)
    text += fault_text(path, fault) + "\n";
  if (!approach.empty()) text += "on the way to the start: " + approach + "\n";
  if (check.slowest) {
    text += fmt::format("slowest place: {:.3g} m/s at {}, where the path asks for {:.3g} m/s\n",
                        check.slowest->speed,
                        place_on_path(path.waypoint, check.slowest->waypoint, check.slowest->way),
                        check.slowest->wanted);
  }
  const auto least = std::min_element(
      check.margins.begin(), check.margins.end(),
      [](const JointMargin& a, const JointMargin& b) { return a.margin < b.margin; });
  if (std::isfinite(least->margin)) {
    text += fmt::format("nearest to a joint limit: J{}, {:.3g} rad from it at {}\n",
                        least - check.margins.begin() + 1, least->margin,
                        place_on_path(path.waypoint, least->waypoint, 1));
  }
  return text;
}

}  // namespace pass_planner
