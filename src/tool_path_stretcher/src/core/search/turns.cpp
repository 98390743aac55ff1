// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/turns.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/robust.h"
#include "search/alignment.h"
#include "search/hypotheses.h"
#include "tool_path_stretcher/residuals.h"

namespace tool_path_stretcher {

std::vector<Similarity> turned_in_itself(const PrincipalFrame& frame, const Similarity& pose) {
  constexpr int kSteps = 24;
  constexpr int kEvenRotations = 400;
  std::vector<Eigen::Matrix3d> turns = cube_turns();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::AngleAxisd over(M_PI, Eigen::Vector3d::Unit((axis + 1) % 3));
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::AngleAxisd turn(2 * M_PI * i / kSteps, Eigen::Vector3d::Unit(axis));
      if (i > 0) turns.push_back(turn.toRotationMatrix());
      turns.push_back((turn * over).toRotationMatrix());
    }
  }
  for (const Eigen::Matrix3d& turn : even_rotations(kEvenRotations))
    turns.push_back(turn);
  const Eigen::Vector3d centre = pose * frame.centroid;
  std::vector<Similarity> turned;
  for (const Eigen::Matrix3d& turn : turns) {
    Similarity guess = pose;
    guess.rotation = pose.rotation * frame.axes * turn * frame.axes.transpose();
    guess.translation = centre - guess.scale * (guess.rotation * frame.centroid);
    turned.push_back(guess);
  }
  return turned;
}

namespace {

Similarity turned_about(const Axis& axis, double angle, const Similarity& pose) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis.along).toRotationMatrix();
  return {pose.scale, turn * pose.rotation, turn * (pose.translation - axis.at) + axis.at};
}

/// A point off a surface, and how far it may be by sampling and grid [m].
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

/// The points of both surfaces that a turn about an axis takes off the other one.
class Marks {
 public:
  Marks(const Surface& reference, const Surface& object, const Similarity& pose, const Axis& axis)
      : reference_(reference), object_(object), pose_(pose), axis_(axis) {
    std::vector<Similarity> turned;
    for (const double angle : {0.31, 1.93, 4.03})
      turned.push_back(turned_about(axis, angle, pose));
    constexpr double kOff = 4;  // times the resolution
    const double least = kOff * resolution(reference, object, pose.scale);
    const auto tells = [&](const std::function<Off(const Similarity&)>& off, double blur) {
      return std::any_of(turned.begin(), turned.end(), [&](const Similarity& each) {
        const Off found = off(each);
        return found.distance > std::max(least, found.blur + blur);
      });
    };
    for (const std::size_t i : object.samples.many) {
      if (tells([&](const Similarity& each) { return forth(each, i); }, object.blur[i]))
        of_object_.push_back(i);
    }
    for (const std::size_t i : reference.samples.many) {
      if (tells([&](const Similarity& each) { return back(each, i); },
                pose.scale * reference.blur[i]))
        of_reference_.push_back(i);
    }
    share_ = static_cast<double>(of_object_.size() + of_reference_.size()) /
             static_cast<double>(object.samples.many.size() + reference.samples.many.size());
    thin(of_object_);
    thin(of_reference_);
  }

  double share() const { return share_; }
  std::size_t count() const { return of_object_.size() + of_reference_.size(); }

  /// [m] farthest of them from the axis
  double radius() const {
    double most = 0;
    for (const std::size_t i : of_object_) {
      const Eigen::Vector3d way = object_.points[i] - axis_.at;
      most = std::max(most, way.cross(axis_.along).norm());
    }
    return most;
  }

  /// Sum of their square distances at an angle, each up to a cap.
  double cost(double angle) const {
    constexpr double kCap = 1.5;
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
  static void thin(std::vector<std::size_t>& points) {
    constexpr std::size_t kMost = 400;
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

/// Whether most of the object stays on the reference when that is turned about an axis.
bool is_nearly_round(const Surface& reference, const Surface& object, const Similarity& pose,
                     const Axis& axis) {
  constexpr double kShare = 0.6;
  const Similarity turned = turned_about(axis, 1, pose);
  const double near = (pose.scale * reference.spacing + object.spacing) / 2;
  const auto on =
      std::count_if(object.samples.few.begin(), object.samples.few.end(), [&](const std::size_t i) {
        return pose.scale * off_of(reference, turned.inverse(object.points[i])).distance < near;
      });
  return static_cast<double>(on) > kShare * static_cast<double>(object.samples.few.size());
}

struct Turn {
  double angle;
  double cost;
};

/// The angles at which the marks fit better than at those beside them, and than at most others.
std::vector<Turn> fitting_turns(const Marks& marks, double spacing) {
  constexpr std::size_t kFewest = 36;
  constexpr std::size_t kMost = 480;
  constexpr std::size_t kWindow = 3;
  constexpr double kClear = 0.8;  // of a middling cost
  const auto steps =
      std::clamp(static_cast<std::size_t>(2 * M_PI * marks.radius() / spacing), kFewest, kMost);
  std::vector<double> costs;
  for (std::size_t i = 0; i < steps; ++i)
    costs.push_back(marks.cost(2 * M_PI * static_cast<double>(i) / static_cast<double>(steps)));
  const double clear = kClear * quantile(costs, 0.5);
  std::vector<Turn> turns;
  for (std::size_t i = kWindow; i < steps; ++i) {  // those about zero are the pose itself
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

std::vector<Similarity> turned_to_marks(const Surface& reference, const Surface& object,
                                        const Similarity& pose) {
  constexpr double kNearlyRound = 0.4;  // share of the points that tell, at most
  constexpr std::size_t kFewest = 8;
  constexpr std::size_t kMost = 16;
  std::vector<Similarity> turned;
  for (const Axis& axis : freest_axes(reference, object, pose)) {
    if (!is_nearly_round(reference, object, pose, axis)) continue;
    const Marks marks(reference, object, pose, axis);
    if (marks.share() > kNearlyRound || marks.count() < kFewest) continue;
    for (const Turn& turn : fitting_turns(marks, object.spacing)) {
      if (turned.size() < kMost) turned.push_back(turned_about(axis, turn.angle, pose));
    }
  }
  return turned;
}

}  // namespace tool_path_stretcher
