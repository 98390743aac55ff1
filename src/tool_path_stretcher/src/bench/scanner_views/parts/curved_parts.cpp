// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "scanner_views/parts/extrusion.h"
#include "scanner_views/parts/part_list.h"

namespace scanner_views {
namespace {

using Eigen::Vector3d;

/// A bent pipe with a flange that has one flat side, lying in the plane of its bend.
Mesh pipe_elbow(Draws& draws) {
  constexpr int kRound = 64, kAlong = 60;
  const double bend = draws.between(0.07, 0.1), radius = draws.between(0.022, 0.03);
  const double flange = 1.6 * radius, leg = draws.between(0.03, 0.05), thick = 0.01, wall = 0.004;
  const double whole = leg + bend * M_PI / 2;
  /// @param flat [m] where the flange is cut off
  const auto line = [&](double along, double r, double flat) {
    const double turn = std::max(0.0, along - leg) / bend;
    const Vector3d middle = turn > 0
                                ? Vector3d(bend * (1 - std::cos(turn)), bend * std::sin(turn), 0)
                                : Vector3d(0, along - leg, 0);
    const Vector3d out(-std::cos(turn), std::sin(turn), 0);
    Points points;
    for (int i = 0; i < kRound; ++i) {
      const double angle = 2 * M_PI * i / kRound;
      const double up = std::max(r * std::sin(angle), -flat);
      points.push_back(middle + r * std::cos(angle) * out + up * Vector3d::UnitZ());
    }
    return points;
  };
  const double none = 1;  // [m]
  std::vector<Points> lines = {line(0, flange, radius), line(thick, flange, radius)};
  for (int i = 0; i <= kAlong; ++i)
    lines.push_back(line(thick + (whole - thick) * i / kAlong, radius, none));
  for (int i = kAlong; i >= 0; --i)
    lines.push_back(line(whole * i / kAlong, radius - wall, none));
  return standing(ring_of(lines));
}

/// A pressed cover with a hole in its middle, an uneven dish and a rim.
Mesh dished_cover(Draws& draws) {
  constexpr int kRound = 96;
  const double width = draws.between(0.1, 0.13), depth = draws.between(0.075, 0.09);
  const double high = draws.between(0.03, 0.045), thick = 0.003;
  const auto line = [&](double out, double z) {
    Points points;
    for (int i = 0; i < kRound; ++i) {
      const double angle = 2 * M_PI * i / kRound;
      const double x = std::cos(angle), y = std::sin(angle);
      const double uneven = 1 + 0.18 * x * out + 0.1 * std::sin(2 * angle) * out;
      points.emplace_back(width * out * x, depth * out * y, z * uneven);
    }
    return points;
  };
  std::vector<Points> lines;
  constexpr int kSteps = 24;
  const auto dish = [&](double out) { return high * (1 - std::pow(out / 0.85, 2)) + thick; };
  for (int i = 0; i <= kSteps; ++i)
    lines.push_back(line(0.2 + 0.65 * i / kSteps, dish(0.2 + 0.65 * i / kSteps) - thick));
  lines.push_back(line(1, 0));
  lines.push_back(line(1, thick));
  for (int i = kSteps; i >= 0; --i)
    lines.push_back(line(0.2 + 0.65 * i / kSteps, dish(0.2 + 0.65 * i / kSteps)));
  return standing(ring_of(lines));
}

/// A blade with a cambered section, twisted and tapered along its span.
Mesh blade(Draws& draws) {
  constexpr int kChord = 40, kSpan = 60;
  const double chord = draws.between(0.08, 0.11), span = draws.between(0.18, 0.24);
  const double twist = draws.between(0.4, 0.7), camber = draws.between(0.1, 0.16);
  /// @param side 1: back, -1: belly
  const auto at = [&](double along, double across, double side) {
    const double size = chord * (1 - 0.35 * along);
    const double thick = 0.06 * std::sqrt(across) * (1 - across) + 0.008 * across * (1 - across);
    const double x = size * (across - 0.4);
    const double z = size * (camber * std::sin(M_PI * across) + side * thick);
    const double turn = twist * (along - 0.5);
    return Vector3d(x * std::cos(turn) - z * std::sin(turn), span * along,
                    x * std::sin(turn) + z * std::cos(turn));
  };
  MeshBuilder builder;
  for (int k = 0; k < kChord; ++k) {
    const double from = static_cast<double>(k) / kChord, to = (k + 1.0) / kChord;
    for (int s = 0; s < kSpan; ++s) {
      const double low = static_cast<double>(s) / kSpan, high = (s + 1.0) / kSpan;
      builder.quad(at(low, from, 1), at(low, to, 1), at(high, to, 1), at(high, from, 1));
      builder.quad(at(low, to, -1), at(low, from, -1), at(high, from, -1), at(high, to, -1));
    }
    builder.quad(at(0, from, -1), at(0, to, -1), at(0, to, 1), at(0, from, 1));
    builder.quad(at(1, to, -1), at(1, from, -1), at(1, from, 1), at(1, to, 1));
  }
  return standing(builder.take());
}

Mesh wavy_sheet(Draws& draws) {
  const double width = draws.between(0.22, 0.3), depth = draws.between(0.16, 0.2);
  const double wave = draws.between(0.006, 0.01), phase = draws.between(0, 6);
  return standing(sheet_of(
      [=](double u, double v) {
        const double x = width * (u - 0.5), y = depth * (v - 0.5);
        return Vector3d(x, y,
                        wave * std::sin(38 * x + phase) * (1 + 2.5 * y) + 1.1 * y * y -
                            0.3 * x * y + 0.5 * x * x);
      },
      150, 100));
}

/// A doubly curved shell of 3 mm, cut off obliquely at one end.
Mesh saddle_shell(Draws& draws) {
  constexpr double kThick = 0.003;
  constexpr int kColumns = 80, kRows = 60;
  const double width = draws.between(0.2, 0.28), depth = draws.between(0.14, 0.18);
  const double hollow = draws.between(0.9, 1.5), hump = draws.between(0.6, 1.2);
  const auto at = [&](double u, double v, double down) {
    const double y = depth * (v - 0.5);
    const double x = width * (u - 0.5) * (1 - 0.9 * y * u);
    return Vector3d(x, y, hollow * x * x - hump * y * y + 4 * x * x * x + 0.6 * x * y - down);
  };
  MeshBuilder builder;
  const auto corner = [&](int column, int row, double down) {
    return at(static_cast<double>(column) / kColumns, static_cast<double>(row) / kRows, down);
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int c = column + 1, r = row + 1;
      builder.quad(corner(column, row, 0), corner(c, row, 0), corner(c, r, 0),
                   corner(column, r, 0));
      builder.quad(corner(column, r, kThick), corner(c, r, kThick), corner(c, row, kThick),
                   corner(column, row, kThick));
    }
  }
  const auto wall = [&](int c0, int r0, int c1, int r1) {
    builder.quad(corner(c0, r0, kThick), corner(c1, r1, kThick), corner(c1, r1, 0),
                 corner(c0, r0, 0));
  };
  for (int c = 0; c < kColumns; ++c) {
    wall(c, 0, c + 1, 0);
    wall(c + 1, kRows, c, kRows);
  }
  for (int r = 0; r < kRows; ++r) {
    wall(kColumns, r, kColumns, r + 1);
    wall(0, r + 1, 0, r);
  }
  return standing(builder.take());
}

}  // namespace

std::vector<ViewPart> curved_parts(Draws& draws) {
  std::vector<ViewPart> parts;
  parts.push_back({"pipe elbow", pipe_elbow(draws)});
  parts.push_back({"dished cover", dished_cover(draws)});
  parts.push_back({"blade", blade(draws)});
  parts.push_back({"wavy sheet", wavy_sheet(draws)});
  parts.push_back({"saddle shell", saddle_shell(draws)});
  return parts;
}

}  // namespace scanner_views
