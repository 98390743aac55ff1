// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "alignment/refinement.h"
#include "cores/by_index.h"
#include "geometry/kd_tree.h"
#include "geometry/robust.h"
#include "mapping/residuals.h"
#include "search/guesses.h"

namespace tool_path_stretcher {
namespace {

Similarity turned_about(const Axis& axis, double angle, const Similarity& pose) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis.along).toRotationMatrix();
  return {pose.scale, turn * pose.rotation, turn * (pose.translation - axis.at) + axis.at};
}

/// Distance of a point from a surface, and the part of it that sampling and grid may cause [m].
struct Off {
  double distance;
  double blur;
};

Off off_of(const Surface& surface, const Eigen::Vector3d& point) {
  const KdTree::Neighbour nearest = surface.tree->nearest(point);
  const double along = surface.normals[nearest.index].dot(point - surface.points[nearest.index]);
  const double beside = std::sqrt(std::max(0.0, nearest.squared_distance - along * along));
  return {std::hypot(along, std::max(0.0, beside - surface.spacing)), surface.blur[nearest.index]};
}

/// The points of both surfaces that a rotation about an axis takes off the other surface.
class Marks {
 public:
  Marks(const SurfacePair& surfaces, const Similarity& pose, const Axis& axis)
      : reference_(surfaces.reference), object_(surfaces.object), pose_(pose), axis_(axis) {
    constexpr double kOff = 4;  // times the resolution; chosen
    const double least = kOff * resolution(surfaces, pose.scale);
    std::vector<Similarity> turned;
    for (const double angle : {0.31, 1.93, 4.03})  // [rad] not angles of a symmetry; chosen
      turned.push_back(turned_about(axis, angle, pose));
    const auto tells = [&](const auto& off_at, double blur) {
      return std::any_of(turned.begin(), turned.end(), [&](const Similarity& each) {
        const Off found = off_at(each);
        return found.distance > std::max(least, found.blur + blur);
      });
    };
    of_object_ = those_of(object_.samples.many, [&](std::size_t i) {
      return tells([&](const Similarity& each) { return forth(each, i); }, object_.blur[i]);
    });
    of_reference_ = those_of(reference_.samples.many, [&](std::size_t i) {
      return tells([&](const Similarity& each) { return back(each, i); },
                   pose.scale * reference_.blur[i]);
    });
    share_ = static_cast<double>(count()) /
             static_cast<double>(object_.samples.many.size() + reference_.samples.many.size());
    thin(of_object_);
    thin(of_reference_);
  }

  double share() const { return share_; }
  std::size_t count() const { return of_object_.size() + of_reference_.size(); }

  /// [m] greatest distance of these points from the axis
  double radius() const {
    double most = 0;
    for (const std::size_t i : of_object_) {
      const Eigen::Vector3d way = object_.points[i] - axis_.at;
      most = std::max(most, way.cross(axis_.along).norm());
    }
    return most;
  }

  /// Sum of their squared distances at an angle, each capped.
  double cost(double angle) const {
    constexpr double kCap = 1.5;  // mean spacings; chosen
    const Similarity turned = turned_about(axis_, angle, pose_);
    const double cap = kCap * (pose_.scale * reference_.spacing + object_.spacing) / 2;
    double sum = 0;
    for (const std::size_t i : of_object_)
      sum += std::pow(std::min(cap, forth(turned, i).distance), 2);
    for (const std::size_t i : of_reference_)
      sum += std::pow(std::min(cap, back(turned, i).distance), 2);
    return sum;
  }

 private:
  /// The points that satisfy a condition.
  template <class Condition>
  static std::vector<std::size_t> those_of(const std::vector<std::size_t>& points,
                                           const Condition& condition) {
    const auto holds = by_index<char>(points.size(), kHundreds,
                                      [&](std::size_t i) { return condition(points[i]); });
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (holds[i]) result.push_back(points[i]);
    }
    return result;
  }

  static void thin(std::vector<std::size_t>& points) {
    constexpr std::size_t kMost = 400;  // chosen: keeps the sweep short
    if (points.size() <= kMost) return;
    for (std::size_t i = 0; i < kMost; ++i)
      points[i] = points[i * points.size() / kMost];
    points.resize(kMost);
  }

  Off forth(const Similarity& pose, std::size_t i) const {
    const Off off = off_of(reference_, pose.inverse(object_.points[i]));
    return {pose.scale * off.distance, pose.scale * off.blur};
  }

  Off back(const Similarity& pose, std::size_t i) const {
    return off_of(object_, pose * reference_.points[i]);
  }

  const Surface& reference_;
  const Surface& object_;
  const Similarity& pose_;
  const Axis& axis_;
  std::vector<std::size_t> of_object_;
  std::vector<std::size_t> of_reference_;
  double share_ = 0;
};

/// Whether most of the object stays on the reference when the reference is rotated about an axis.
bool is_nearly_round(const SurfacePair& surfaces, const Similarity& pose, const Axis& axis) {
  constexpr double kShare = 0.6;  // of the object's points; chosen
  constexpr double kTurn = 1;     // [rad] chosen
  const auto& [reference, object] = surfaces;
  const Similarity turned = turned_about(axis, kTurn, pose);
  const double near = (pose.scale * reference.spacing + object.spacing) / 2;
  double on = 0;
  for (const std::size_t i : object.samples.few)
    on += pose.scale * off_of(reference, turned.inverse(object.points[i])).distance < near;
  return on > kShare * static_cast<double>(object.samples.few.size());
}

struct Turn {
  double angle;
  double cost;
};

/// The angles at which the marks fit better than at neighbouring angles and at most others.
std::vector<Turn> fitting_turns(const Marks& marks, double spacing) {
  constexpr std::size_t kFewest = 36;  // steps of a turn; chosen
  constexpr std::size_t kMost = 480;   // steps of a turn; chosen
  constexpr std::size_t kWindow = 3;   // steps to either side; chosen
  constexpr double kClear = 0.8;       // of the median cost; chosen
  const auto steps =
      std::clamp(static_cast<std::size_t>(2 * M_PI * marks.radius() / spacing), kFewest, kMost);
  const auto costs = by_index<double>(steps, kSingly, [&](std::size_t i) {
    return marks.cost(2 * M_PI * static_cast<double>(i) / static_cast<double>(steps));
  });
  const double clear = kClear * quantile(costs, 0.5);
  std::vector<Turn> turns;
  for (std::size_t i = kWindow; i < steps; ++i) {  // angles near zero are the pose itself
    bool least = costs[i] < clear;
    for (std::size_t k = 1; k <= kWindow && least; ++k)
      least = costs[i] <= costs[(i + k) % steps] && costs[i] <= costs[(i + steps - k) % steps];
    if (least)
      turns.push_back({2 * M_PI * static_cast<double>(i) / static_cast<double>(steps), costs[i]});
  }
  std::stable_sort(turns.begin(), turns.end(),
                   [](const Turn& a, const Turn& b) { return a.cost < b.cost; });
  return turns;
}

}  // namespace

std::vector<Similarity> turned_to_marks(const SurfacePair& surfaces, const Similarity& pose) {
  constexpr double kNearlyRound = 0.4;  // greatest share of telling points; chosen
  constexpr std::size_t kFewest = 8;    // points; chosen
  constexpr std::size_t kMost = 16;     // turns; chosen
  std::vector<Similarity> turned;
  for (const Axis& axis : freest_axes(surfaces, pose)) {
    if (!is_nearly_round(surfaces, pose, axis)) continue;
    const Marks marks(surfaces, pose, axis);
    if (marks.share() > kNearlyRound || marks.count() < kFewest) continue;
    for (const Turn& turn : fitting_turns(marks, surfaces.object.spacing)) {
      if (turned.size() < kMost) turned.push_back(turned_about(axis, turn.angle, pose));
    }
  }
  return turned;
}

}  // namespace tool_path_stretcher
