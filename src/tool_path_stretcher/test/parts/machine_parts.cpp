// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "parts/shapes.h"

namespace cases {
namespace {

using Eigen::Vector3d;

/// A ring about the x axis between two places given as (x, radius). The outside is left of the
/// direction from the first to the second, seen with x to the right and the radius upwards.
std::vector<Facet> ring(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int columns,
                        int rows, const Kept& kept = {}) {
  return patches(
      [=](double u, double v) {
        const Eigen::Vector2d at = from + u * (to - from);
        const double angle = 2 * M_PI * v;
        return Vector3d(at.x(), at.y() * std::sin(angle), at.y() * std::cos(angle));
      },
      columns, rows, kept);
}

constexpr double kLegLong = 0.120;
constexpr double kLegShort = 0.080;
constexpr double kLegWidth = 0.060;
constexpr double kLegThick = 0.008;

SurfacePoint on_bracket(double a) {
  const double y = 0.018 * std::sin(20 * a);
  if (a < 0.6) return {{0.105 - 0.085 * a / 0.6, y, kLegThick}, Vector3d::UnitZ()};
  return {{kLegThick, y, 0.020 + 0.050 * (a - 0.6) / 0.4}, Vector3d::UnitX()};
}

constexpr double kShaftEnd = 0.160;
constexpr double kShaftRadius = 0.025;
constexpr double kKeyHalfWidth = 0.004;
constexpr double kKeyFloor = 0.021;
constexpr double kKeyFrom = 0.105;
constexpr double kKeyTo = 0.145;

bool in_keyway(const Vector3d& at) {
  return at.z() > 0 && std::abs(at.y()) < kKeyHalfWidth && at.x() > kKeyFrom && at.x() < kKeyTo;
}

void add_keyway(std::vector<Facet>& facets) {
  const double length = kKeyTo - kKeyFrom;
  const double high = std::sqrt(kShaftRadius * kShaftRadius - kKeyHalfWidth * kKeyHalfWidth);
  const Vector3d along(length, 0, 0);
  const Vector3d across(0, 2 * kKeyHalfWidth, 0);
  const Vector3d up(0, 0, high - kKeyFloor);
  const Vector3d corner(kKeyFrom, -kKeyHalfWidth, kKeyFloor);
  facets.push_back(rectangle(corner, along, across));
  facets.push_back(rectangle(corner, up, along));
  facets.push_back(rectangle(corner + across, along, up));
  facets.push_back(rectangle(corner, across, up));
  facets.push_back(rectangle(corner + along, up, across));
}

/// A stepped shaft about x: 160 mm long, 30, 50 and 36 mm thick.
std::vector<Facet> shaft_facets(bool keyway) {
  const std::vector<Eigen::Vector2d> profile = {{0, 0},         {0, 0.015},     {0.040, 0.015},
                                                {0.040, 0.018}, {0.090, 0.018}, {0.090, 0.025},
                                                {0.160, 0.025}, {0.160, 0}};
  std::vector<Facet> facets;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const bool thickest = i == 6;
    append(ring(profile[i - 1], profile[i], 140, 320,
                [&](const Vector3d& at) { return !(keyway && thickest && in_keyway(at)); }),
           facets);
  }
  if (keyway) add_keyway(facets);
  return facets;
}

SurfacePoint on_cylinder(double x, double radius, double angle) {
  const Vector3d out(0, std::sin(angle), std::cos(angle));
  return {Vector3d(x, 0, 0) + radius * out, out};
}

/// A step with a smooth flank, from 0 to 1 around zero.
double step(double at) {
  constexpr double kFlank = 0.001;
  return 0.5 * (1 + std::tanh(at / kFlank));
}

constexpr double kBendRadius = 0.080;
constexpr double kPipeRadius = 0.025;

/// A point on the pipe, from a straight end of 40 mm at z = -0.04 through a quarter turn to the
/// flange at x = 0.08.
Vector3d on_pipe(double along, double angle) {
  const Vector3d flat(std::cos(angle), std::sin(angle), 0);  // of the pipe's section at its start
  if (along < 0) return kPipeRadius * flat + Vector3d(0, 0, along);
  const double turn = along / kBendRadius;
  const Vector3d centre(kBendRadius, 0, 0);
  return centre + Eigen::AngleAxisd(turn, Vector3d::UnitY()) * (kPipeRadius * flat - centre);
}

constexpr double kPipeStart = -0.040;
constexpr double kPipeEnd = kBendRadius * M_PI / 2;

std::vector<Facet> elbow_facets() {
  constexpr double kThick = 0.010;
  constexpr double kFlange = 0.048;
  std::vector<Facet> facets;
  for (const auto& [from, to] :
       {std::pair<double, double>(kPipeStart, 0), std::pair<double, double>(0, kPipeEnd)}) {
    append(
        patches([from = from, to = to](
                    double u, double v) { return on_pipe(from + u * (to - from), -2 * M_PI * v); },
                60, 60),
        facets);
  }
  const Vector3d middle(kBendRadius, 0, kBendRadius);  // of the pipe's end, its axis along x
  for (const auto& [from, to] :
       {std::pair<Eigen::Vector2d, Eigen::Vector2d>({0, kPipeRadius}, {0, kFlange}),
        {{0, kFlange}, {kThick, kFlange}},
        {{kThick, kFlange}, {kThick, 0}}}) {
    for (Facet facet : ring(from, to, 20, 60)) {
      facet.at = [at = facet.at, middle](double u, double v) {
        SurfacePoint point = at(u, v);
        point.position += middle;
        return point;
      };
      facets.push_back(facet);
    }
  }
  return facets;
}

}  // namespace

Part bracket() {
  const Vector3d across(0, kLegWidth, 0);
  const Vector3d corner(0, -kLegWidth / 2, 0);
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  const Vector3d inner = corner + kLegThick * (x + z);
  const double rest_long = kLegLong - kLegThick;
  const double rest_short = kLegShort - kLegThick;
  Part part;
  part.size = std::hypot(kLegLong, kLegShort) / 2;
  part.facets = {rectangle(corner, across, kLegLong * x),
                 rectangle(inner, rest_long * x, across),
                 rectangle(corner + kLegLong * x, across, kLegThick * z),
                 rectangle(corner, kLegShort * z, across),
                 rectangle(inner, across, rest_short * z),
                 rectangle(corner + kLegShort * z, kLegThick * x, across),
                 rectangle(corner, kLegLong * x, kLegThick * z),
                 rectangle(corner + kLegThick * z, kLegThick * x, rest_short * z),
                 rectangle(corner + across, kLegThick * z, kLegLong * x),
                 rectangle(corner + across + kLegThick * z, rest_short * z, kLegThick * x)};
  part.path = path_along(on_bracket);
  return part;
}

Part shaft(bool keyway) {
  Part part;
  part.size = kShaftEnd / 2;
  part.facets = shaft_facets(keyway);
  part.path =
      path_along([](double a) { return on_cylinder(0.045 + 0.040 * a, 0.018, -1 + 4 * a); });
  return part;
}

Part shaft_with_ring() {
  Part part = shaft(false);
  part.path = path_along([](double a) { return on_cylinder(0.065, 0.018, 2 * M_PI * a); });
  return part;
}

Part ribbed_plate(double moved_rib) {
  constexpr double kWidth = 0.240;
  constexpr double kDepth = 0.160;
  const Height height = [moved_rib](double x, double y) {
    double high = 0.006;
    for (const double rib : {-0.085, -0.030, 0.010 + moved_rib, 0.085})
      high += 0.009 * step(0.004 - std::abs(x - rib)) * step(0.065 - std::abs(y));
    return high + 0.012 * step(0.012 - std::hypot(x - 0.045, y - 0.035));
  };
  Part part;
  part.size = half_diagonal(kWidth, kDepth);
  part.facets = facets_of(
      kWidth, kDepth, [](double, double) { return true; }, height, true);
  part.path = path_along(
      [height](double a) { return top_at(height, -0.020 + 0.020 * a * a, -0.05 + 0.1 * a); });
  return part;
}

Part elbow() {
  Part part;
  part.size = 0.09;
  part.facets = elbow_facets();
  part.path = path_along([](double a) {
    const auto at = [](double b) {
      return on_pipe(-0.03 + 0.14 * b, M_PI + 0.8 * std::sin(7 * b));
    };
    const auto round = [](double b, double angle) { return on_pipe(-0.03 + 0.14 * b, angle); };
    const double angle = M_PI + 0.8 * std::sin(7 * a);
    const Vector3d along = round(a + kStep, angle) - round(a - kStep, angle);
    const Vector3d around_pipe = round(a, angle + kStep) - round(a, angle - kStep);
    return SurfacePoint{at(a), around_pipe.cross(along).normalized()};
  });
  return part;
}

Part with_path_between(Part part, double from, double to) {
  auto& waypoints = part.path.segments.at(0).waypoints;
  const auto at = [&](double share) {
    return waypoints.begin() +
           static_cast<std::ptrdiff_t>(share * static_cast<double>(waypoints.size()));
  };
  waypoints = {at(from), at(to)};
  return part;
}

}  // namespace cases
