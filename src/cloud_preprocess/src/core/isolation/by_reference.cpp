// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/by_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "isolation/plan_view.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

using PointIndices = std::vector<std::uint32_t>;
using scan_cell_common::UnusableInput;

std::vector<PointIndices> points_of(const std::vector<Object>& objects, const GridCells& grid) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> object_of(grid.means.size(), kNone);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (const KdTree::Index cell : objects[i].cells)
      object_of[cell] = i;
  }
  std::vector<PointIndices> result(objects.size());
  for (std::uint32_t i = 0; i < grid.cell_of_point.size(); ++i) {
    const std::size_t object = object_of[grid.cell_of_point[i]];
    if (object != kNone) result[object].push_back(i);
  }
  return result;
}

/// "12345 points about (0.1, 0.2, 0.03) m"
std::string text_of(const Cloud& cloud, const PointIndices& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : points)
    sum += cloud[i].getVector3fMap().cast<double>();
  const Eigen::Vector3d middle = sum / std::max(1.0, static_cast<double>(points.size()));
  return fmt::format("{} points about ({:.3f}, {:.3f}, {:.3f}) m", points.size(), middle.x(),
                     middle.y(), middle.z());
}

[[noreturn]] void refuse_none(const Cloud& cloud, std::vector<PointIndices> objects,
                              const std::string& why, const std::string& file) {
  constexpr std::size_t kMost = 4;  // named; chosen
  std::stable_sort(objects.begin(), objects.end(),
                   [](const auto& one, const auto& other) { return one.size() > other.size(); });
  std::string places;
  for (std::size_t i = 0; i < std::min(kMost, objects.size()); ++i)
    places += (i == 0 ? "" : ", ") + text_of(cloud, objects[i]);
  throw UnusableInput("reference",
                      fmt::format("'{}' explains none of {} objects ({}); for the largest: {}",
                                  file, objects.size(), places, why),
                      "scan the part of this reference, or set isolate/select to largest, nearest "
                      "or index");
}

[[noreturn]] void refuse_several(const Cloud& cloud, const std::vector<FoundReference>& found,
                                 const std::string& file) {
  std::string places;
  for (const FoundReference& each : found)
    places += (places.empty() ? "" : " and ") + text_of(cloud, each.explained);
  throw UnusableInput(
      "reference", fmt::format("'{}' explains {} objects: {}", file, found.size(), places),
      "cut off all but one by limits, or set isolate/select to nearest (with isolate/point) or "
      "index");
}

/// Finds points near a part or over it.
class Beside {
 public:
  /// @param floor may be null
  Beside(Cloud part, const SeenFloor* floor, double gap)
      : gap_(static_cast<float>(gap)), part_(std::move(part)) {
    tree_ = std::make_unique<const KdTree>(part_);
    if (floor == nullptr) return;
    plan_.emplace(floor->up);
    for (const pcl::PointXYZ& point : part_)
      outline_.push_back((*plan_)(point));
    outline_tree_ = std::make_unique<const KdTree>(outline_);
  }

  bool shows(const pcl::PointXYZ& point) const {
    constexpr float kOver = 0.5F;  // gaps beside the outline; chosen
    if (squared(*tree_, point) < gap_ * gap_) return true;
    return plan_ && squared(*outline_tree_, (*plan_)(point)) < kOver * kOver * gap_ * gap_;
  }

 private:
  static float squared(const KdTree& tree, const pcl::PointXYZ& point) {
    KdTree::Index nearest = 0;
    float distance = std::numeric_limits<float>::infinity();
    tree.nearest(point.data, 1, &nearest, &distance);
    return distance;
  }

  float gap_;
  Cloud part_;
  std::unique_ptr<const KdTree> tree_;
  std::optional<PlanView> plan_;
  Cloud outline_;
  std::unique_ptr<const KdTree> outline_tree_;
};

}  // namespace

ChosenPoints choose_by_reference(const TracedCloud& cloud, const GridCells& grid,
                                 const std::vector<Object>& objects,
                                 const IsolationParameters& parameters) {
  const Cloud& points = cloud.cloud();
  const std::vector<PointIndices> in_objects = points_of(objects, grid);
  const ReferenceSearch search = parameters.finder->find(points, in_objects);
  if (search.found.empty()) refuse_none(points, in_objects, search.why_none, parameters.reference);
  if (search.found.size() > 1) refuse_several(points, search.found, parameters.reference);
  const FoundReference& found = search.found.front();
  ChosenPoints chosen{std::vector<bool>(points.size(), false), 0};
  Cloud part = found.laid;
  for (const std::uint32_t i : found.explained) {
    chosen.kept[i] = true;
    part.push_back(points[i]);
  }
  const Beside beside(std::move(part), cloud.floor(), parameters.gap);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (chosen.kept[i] || !beside.shows(points[i])) continue;
    chosen.kept[i] = true;
    ++chosen.beside;
  }
  return chosen;
}

}  // namespace cloud_preprocess
