// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/shadows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "isolation/plan_view.h"

namespace cloud_preprocess {
namespace {

/// Where the floor was seen, in plan view.
class OpenFloor {
 public:
  OpenFloor(const SeenFloor& floor, const PlanView& plan, double gap)
      : gap_(static_cast<float>(gap)) {
    constexpr double kCellsAGap = 8;  // half of the radius within which it is searched; chosen
    points_ = sort_into_grid(floor.points, Eigen::Vector3d::Constant(gap / kCellsAGap)).means;
    for (pcl::PointXYZ& point : points_)
      point = plan(point);
    tree_ = std::make_unique<const KdTree>(points_);
  }

  /// Whether the line shows the floor over a length of the gap between two objects.
  bool parts(const pcl::PointXYZ& from, const pcl::PointXYZ& to) const {
    constexpr float kStepsAGap = 8;  // chosen
    const Eigen::Vector3f way = to.getVector3fMap() - from.getVector3fMap();
    const auto steps = static_cast<int>(std::ceil(way.norm() * kStepsAGap / gap_));
    const float step = way.norm() / static_cast<float>(std::max(steps, 1));
    float open = 0;
    for (int i = 0; i <= steps; ++i) {
      const Eigen::Vector3f at =
          from.getVector3fMap() + way * (static_cast<float>(i) / static_cast<float>(steps));
      open = is_seen(at) ? open + step : 0;
      if (open >= gap_) return true;
    }
    return false;
  }

 private:
  /// Scan lines may be half a gap apart.
  bool is_seen(const Eigen::Vector3f& at) const {
    KdTree::Index nearest = 0;
    float squared = std::numeric_limits<float>::infinity();
    tree_->nearest(at.data(), 1, &nearest, &squared);
    return squared < gap_ * gap_ / 16;
  }

  float gap_;
  Cloud points_;
  std::unique_ptr<const KdTree> tree_;
};

/// The cells of an object in plan view.
Cloud flat(const Object& object, const Cloud& cells, const PlanView& plan) {
  Cloud result;
  for (const KdTree::Index cell : object.cells)
    result.push_back(plan(cells[cell]));
  return result;
}

float height_of(const Object& object, const Cloud& cells, const SeenFloor& floor) {
  float most = 0;
  for (const KdTree::Index cell : object.cells)
    most = std::max(most, floor.up.dot(cells[cell].getVector3fMap() - floor.point));
  return most;
}

bool belong_together(const Cloud& one, const Cloud& other, float reach, float gap,
                     const OpenFloor& floor) {
  const KdTree tree(other);
  struct Across {
    pcl::PointXYZ from, to;
    float length;
  };
  std::vector<Across> ways;
  float shortest = std::numeric_limits<float>::infinity();
  for (const pcl::PointXYZ& from : one) {
    KdTree::Index nearest = 0;
    float squared = 0;
    tree.nearest(from.data, 1, &nearest, &squared);
    ways.push_back({from, other[nearest], std::sqrt(squared)});
    shortest = std::min(shortest, ways.back().length);
  }
  if (shortest > reach) return false;
  std::size_t facing = 0, parted = 0;
  for (const Across& way : ways) {
    if (way.length > shortest + gap) continue;
    ++facing;
    if (floor.parts(way.from, way.to)) ++parted;
  }
  return 2 * parted < facing;
}

/// For each object, the first object of its group.
std::vector<std::size_t> groups_of(const std::vector<Object>& objects, const Cloud& cells,
                                   const SeenFloor& floor, double gap) {
  constexpr float kSteepest = 1.7F;  // tangent of 60 degrees between line of sight and normal
  const PlanView plan(floor.up);
  const OpenFloor open(floor, plan, gap);
  std::vector<Cloud> plans;
  std::vector<float> heights;
  std::vector<std::size_t> group;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    plans.push_back(flat(objects[i], cells, plan));
    heights.push_back(height_of(objects[i], cells, floor));
    group.push_back(i);
    for (std::size_t k = 0; k < i; ++k) {
      if (group[k] == group[i]) continue;
      const bool is_smaller = plans[i].size() < plans[k].size();
      const float reach = kSteepest * std::max(heights[i], heights[k]);
      if (!belong_together(plans[is_smaller ? i : k], plans[is_smaller ? k : i], reach,
                           static_cast<float>(gap), open))
        continue;
      const std::size_t first = std::min(group[i], group[k]);
      std::replace(group.begin(), group.end(), std::max(group[i], group[k]), first);
    }
  }
  return group;
}

}  // namespace

std::size_t join_across_shadows(std::vector<Object>& objects, const Cloud& cells,
                                const SeenFloor& floor, double gap) {
  const std::vector<std::size_t> group = groups_of(objects, cells, floor, gap);
  std::vector<Object> joined;
  std::vector<std::size_t> place(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (group[i] == i) {
      place[i] = joined.size();
      joined.push_back(std::move(objects[i]));
      continue;
    }
    Object& whole = joined[place[group[i]]];
    whole.cells.insert(whole.cells.end(), objects[i].cells.begin(), objects[i].cells.end());
    whole.points += objects[i].points;
  }
  std::swap(objects, joined);
  return joined.size() - objects.size();
}

}  // namespace cloud_preprocess
