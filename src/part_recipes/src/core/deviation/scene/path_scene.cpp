// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/scene/path_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;
using tool_path_stretcher::Points;
using tool_path_stretcher::Similarity;

std::vector<Eigen::Matrix3d> rotations_of(const tool_paths::ToolPath& path) {
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto& segment : path.segments) {
    for (const auto& waypoint : segment.waypoints)
      rotations.push_back(waypoint.pose.linear());
  }
  return rotations;
}

double angle_between(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

Json json_of(const Points& points) {
  Json all = Json::array();
  for (const Eigen::Vector3d& point : points)
    all.push_back({point.x(), point.y(), point.z()});
  return all;
}

void add_segments(const tool_paths::ToolPath& path, Json& all) {
  all["segments"] = Json::array();
  all["segment_of"] = Json::array();
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    all["segments"].push_back(path.segments[i].name);
    for (std::size_t k = 0; k < path.segments[i].waypoints.size(); ++k)
      all["segment_of"].push_back(i);
  }
}

}  // namespace

std::optional<std::vector<double>> turns_of(const PathPair& paths, const Similarity& similarity) {
  if (!paths.adapted || !paths.reference.path.has_orientation) return {};
  const auto before = rotations_of(paths.reference.path);
  const auto after = rotations_of(paths.adapted->path);
  // An edited path has other waypoints
  const bool edited = paths.adapted->path.process_names != paths.reference.path.process_names;
  if (edited || before.size() != after.size()) return {};
  const bool axis_alone =
      paths.reference.layout.pose.orientation == tool_paths::OrientationKind::kToolVector;
  std::vector<double> turns;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Eigen::Matrix3d carried = similarity.rotation * before[i];
    turns.push_back(
        axis_alone ? angle_between(carried.col(2), after[i].col(2))
                   : Eigen::Quaterniond(carried).angularDistance(Eigen::Quaterniond(after[i])));
  }
  return turns;
}

std::string to_json(const PathPair& paths, const std::optional<Similarity>& similarity) {
  const Points reference = positions_of(paths.reference.path);
  Json all;
  add_segments(paths.adapted ? paths.adapted->path : paths.reference.path, all);
  all["reference"] = json_of(reference);
  all["mapped"] = nullptr;
  all["turns"] = nullptr;
  if (similarity) {
    Points mapped = reference;
    for (Eigen::Vector3d& point : mapped)
      point = *similarity * point;
    all["mapped"] = json_of(mapped);
    if (const auto turns = turns_of(paths, *similarity)) all["turns"] = *turns;
  }
  all["adapted"] = paths.adapted ? json_of(positions_of(paths.adapted->path)) : Json(nullptr);
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace part_recipes
