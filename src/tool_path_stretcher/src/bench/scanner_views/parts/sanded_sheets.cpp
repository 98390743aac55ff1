// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>

#include "parts/shapes.h"
#include "scanner_views/parts/part_list.h"

namespace scanner_views {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tool_path_stretcher::ToolPath;

/// A crowned sheet over x and y [m], with openings.
struct Sheet {
  double width, depth;
  std::function<double(const Vector2d&)> height;
  std::function<bool(const Vector2d&)> is_open;

  Vector3d at(const Vector2d& place) const { return {place.x(), place.y(), height(place)}; }

  bool has(const Vector2d& place) const {
    return std::abs(place.x()) <= width / 2 && std::abs(place.y()) <= depth / 2 && !is_open(place);
  }

  Vector3d normal(const Vector2d& place) const {
    constexpr double kStep = 1e-5;  // [m]
    const Vector2d x = kStep * Vector2d::UnitX(), y = kStep * Vector2d::UnitY();
    return (at(place + x) - at(place - x)).cross(at(place + y) - at(place - y)).normalized();
  }
};

Sheet drawn_sheet(Draws& draws) {
  const double width = draws.between(0.8, 1.6), depth = draws.between(0.35, 0.5);
  const double crown = draws.between(0.08, 0.14), across = draws.between(0.2, 0.4);
  const double wave = draws.between(0.003, 0.006), twist = draws.between(0.02, 0.06);
  const double window_at = draws.between(-0.25, -0.18) * width;
  const double window_half = draws.between(0.07, 0.11) * width;
  const double window_high = draws.between(0.2, 0.3) * depth;
  const Vector2d round_at(draws.between(0.12, 0.2) * width, draws.between(-0.1, 0.15) * depth);
  const double round = draws.between(0.16, 0.26) * depth;
  const double notch = draws.between(0.3, 0.4);
  return {width, depth,
          [=](const Vector2d& at) {
            return -crown * at.x() * at.x() - across * at.y() * at.y() + twist * at.x() * at.y() +
                   wave * std::sin(9 * at.x() + 5 * at.y());
          },
          [=](const Vector2d& at) {
            const bool window = std::abs(at.x() - window_at) < window_half &&
                                std::abs(at.y() + 0.05 * depth) < window_high;
            const bool in_corner = at.x() > notch * width && at.y() > notch * depth;
            return window || (at - round_at).norm() < round || in_corner;
          }};
}

/// Meshes the sheet in cells of about 8 mm; closed if it has a wall.
/// @param wall [m] 0: an open sheet
Mesh mesh_of(const Sheet& sheet, double wall) {
  constexpr double kCell = 0.008;  // [m] chosen
  const int columns = static_cast<int>(sheet.width / kCell);
  const int rows = static_cast<int>(sheet.depth / kCell);
  const auto place = [&](double column, double row) {
    return Vector2d((column / columns - 0.5) * sheet.width, (row / rows - 0.5) * sheet.depth);
  };
  const auto corner = [&](int column, int row, double down) -> Vector3d {
    return sheet.at(place(column, row)) - down * Vector3d::UnitZ();
  };
  const auto has = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < columns && row < rows &&
           sheet.has(place(column + 0.5, row + 0.5));
  };
  MeshBuilder builder;
  const auto close = [&](int from_column, int from_row, int to_column, int to_row) {
    builder.quad(corner(from_column, from_row, wall), corner(to_column, to_row, wall),
                 corner(to_column, to_row, 0), corner(from_column, from_row, 0));
  };
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      if (!has(c, r)) continue;
      builder.quad(corner(c, r, 0), corner(c + 1, r, 0), corner(c + 1, r + 1, 0),
                   corner(c, r + 1, 0));
      if (wall == 0) continue;
      builder.quad(corner(c, r + 1, wall), corner(c + 1, r + 1, wall), corner(c + 1, r, wall),
                   corner(c, r, wall));
      if (!has(c, r - 1)) close(c, r, c + 1, r);
      if (!has(c + 1, r)) close(c + 1, r, c + 1, r + 1);
      if (!has(c, r + 1)) close(c + 1, r + 1, c, r + 1);
      if (!has(c - 1, r)) close(c, r + 1, c, r);
    }
  }
  return builder.take();
}

/// Lines over the sheet, across its openings and past its rim, with approach and retract.
ToolPath raster_over(const Sheet& sheet, Draws& draws) {
  ToolPath path;
  path.name = "raster";
  path.has_orientation = true;
  path.process_names = {"speed"};
  const double step = draws.between(0.05, 0.09), past = draws.between(0.05, 0.1);
  const double above = draws.between(0.08, 0.2);
  for (const double y : {-0.38, -0.19, 0.0, 0.19, 0.38}) {
    path.segments.push_back({"line", {}});
    const auto add = [&](const Vector2d& place, double lifted) {
      const Vector3d normal = sheet.normal(place);
      path.segments.back().waypoints.push_back(cases::waypoint_at(
          {sheet.at(place) + lifted * Vector3d::UnitZ(), normal}, Vector3d::UnitX()));
    };
    const double begin = 0.01 - sheet.width / 2, end = sheet.width / 2 + past;
    add({begin, y * sheet.depth}, above);
    for (double x = begin; x < end; x += step)
      add({x, y * sheet.depth}, 0);
    add({end, y * sheet.depth}, above);
  }
  return path;
}

}  // namespace

std::vector<ViewPart> sanded_sheets(Draws& draws) {
  std::vector<ViewPart> parts;
  for (const double wall : {0.0, 0.004}) {
    const Sheet sheet = drawn_sheet(draws);
    const Mesh mesh = mesh_of(sheet, wall);
    const double down = box_of(mesh).min().z();
    ViewPart part{
        wall == 0 ? "sanded sheet" : "sanded shell",
        moved(mesh, [=](const Vector3d& at) -> Vector3d { return at - down * Vector3d::UnitZ(); })};
    part.path = raster_over(sheet, draws);
    for (auto& segment : part.path.segments) {
      for (auto& waypoint : segment.waypoints)
        waypoint.pose.translation().z() -= down;
    }
    parts.push_back(part);
  }
  return parts;
}

}  // namespace scanner_views
