// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/part_list.h"
#include "scanner_views/parts/terrace.h"

namespace scanner_views {
namespace {

using cases::circle;
using cases::rectangle_loop;
using Eigen::Vector2d;

/// Scales the listed lengths by the part's random factors.
class Sizes {
 public:
  explicit Sizes(Draws& draws)
      : x_(draws.between(0.85, 1.2)), y_(draws.between(0.85, 1.2)), z_(draws.between(0.85, 1.2)) {}

  Loop box(double width, double depth, double x, double y) const {
    return shifted(rectangle_loop(x_ * width, y_ * depth), at(x, y));
  }
  Loop round(double radius, double x, double y) const {
    constexpr int kCorners = 40;
    return circle(at(x, y), std::min(x_, y_) * radius, kCorners);
  }
  Terrace drilled(double radius, double x, double y) const {
    return hole(at(x, y), std::min(x_, y_) * radius);
  }
  /// A slot with round ends along x.
  Terrace slot(double length, double width, double x, double y) const {
    constexpr int kCorners = 12;
    Terrace result;
    for (int i = 0; i <= 2 * kCorners + 1; ++i) {
      const bool right = i <= kCorners;
      const double angle = -M_PI / 2 + M_PI * (right ? i : i - 1) / kCorners;
      result.outline.push_back(
          at(x, y) + Vector2d((right ? 1 : -1) * x_ * (length - width) / 2, 0) +
          std::min(x_, y_) * width / 2 * Vector2d(std::cos(angle), std::sin(angle)));
    }
    result.through = true;
    return result;
  }
  double high(double height) const { return z_ * height; }

 private:
  Vector2d at(double x, double y) const { return {x_ * x, y_ * y}; }

  double x_, y_, z_;
};

/// @param moved [m] shift of one rib along x
Mesh bracket(Draws& draws, double moved) {
  const Sizes s(draws);
  const Terrace boss{s.round(0.014, 0.085, 0.042), s.high(0.022), {s.drilled(0.006, 0.085, 0.042)}};
  return solid_of(Terrace{s.box(0.22, 0.14, 0, 0),
                          s.high(0.008),
                          {{s.box(0.10, 0.006, -0.03, 0.035), s.high(0.028)},
                           {s.box(0.006, 0.08, 0.045 + moved, -0.012), s.high(0.024)},
                           {s.box(0.006, 0.05, -0.035, -0.03), s.high(0.018)},
                           boss,
                           s.drilled(0.005, -0.095, -0.055),
                           s.drilled(0.005, -0.095, 0.055),
                           s.drilled(0.005, 0.095, -0.055)}});
}

Mesh stepped_block(Draws& draws) {
  const Sizes s(draws);
  const Terrace top{s.box(0.05, 0.055, -0.045, 0.01), s.high(0.065)};
  const Terrace middle{s.box(0.105, 0.085, -0.022, 0), s.high(0.042), {top}};
  return solid_of(Terrace{s.box(0.16, 0.105, 0, 0),
                          s.high(0.022),
                          {middle, {s.round(0.013, 0.058, 0.025), s.high(0.010)}}});
}

Mesh casing(Draws& draws) {
  const Sizes s(draws);
  const auto post = [&](double x, double y) {
    return Terrace{s.round(0.009, x, y), s.high(0.036), {{s.round(0.003, x, y), s.high(0.016)}}};
  };
  const Terrace inside{s.box(0.176, 0.106, 0, 0),
                       s.high(0.008),
                       {post(-0.072, -0.037), post(0.072, -0.037), post(0.072, 0.037),
                        s.drilled(0.015, -0.035, 0.012), s.slot(0.05, 0.012, 0.022, -0.012)}};
  return solid_of(Terrace{s.box(0.2, 0.13, 0, 0), s.high(0.048), {inside}});
}

Mesh frame(Draws& draws) {
  const Sizes s(draws);
  Terrace opening{s.box(0.17, 0.11, 0.008, 0)};
  opening.through = true;
  Terrace base{s.box(0.24, 0.18, 0, 0), s.high(0.02), {opening}};
  base.on_it.push_back({s.box(0.02, 0.014, -0.095, 0.068), s.high(0.026)});
  base.on_it.push_back({s.round(0.005, -0.098, -0.07), s.high(0.012)});
  base.taper = 0.96;
  return solid_of(base);
}

Mesh gear_plate(Draws& draws) {
  constexpr int kTeeth = 17;
  const Sizes s(draws);
  const double radius = draws.between(0.075, 0.1);
  Terrace bore{circle({0, 0}, 0.12 * radius, 32)};
  bore.through = true;
  bore.outline[0] *= 1.6;  // the keyway's corner
  const Terrace hub{circle({0, 0}, 0.32 * radius, 40), s.high(0.028), {bore}};
  std::vector<Terrace> on_it = {hub};
  for (const auto& [angle, size] : {std::pair{0.4, 0.13}, {1.9, 0.15}, {2.9, 0.09}, {4.6, 0.15}})
    on_it.push_back(hole(0.6 * radius * Vector2d(std::cos(angle), std::sin(angle)), size * radius));
  return solid_of(Terrace{cases::star(kTeeth, radius, 0.88 * radius), s.high(0.013), on_it});
}

Mesh slotted_plate(Draws& draws) {
  const Sizes s(draws);
  Terrace base{s.box(0.26, 0.15, 0, 0),
               s.high(0.014),
               {s.slot(0.07, 0.016, -0.06, 0.035), s.slot(0.07, 0.016, 0.065, 0.035),
                s.slot(0.10, 0.012, -0.045, -0.03), s.drilled(0.012, 0.075, -0.03)}};
  base.chamfer = s.high(0.004);
  return solid_of(base);
}

Mesh cast_body(Draws& draws) {
  const Sizes s(draws);
  Terrace base;
  for (int i = 0; i < 72; ++i) {
    const double angle = 2 * M_PI * i / 72;
    const double bulge = 1 + 0.12 * std::cos(2 * angle + 0.5) + 0.05 * std::sin(3 * angle);
    base.outline.push_back(bulge * Vector2d(0.105 * std::cos(angle), 0.08 * std::sin(angle)));
  }
  base.height = s.high(0.035);
  base.taper = 0.93;
  const auto boss = [&](double radius, double x, double y, double height) {
    Terrace result{circle({x, y}, radius, 40), s.high(height)};
    result.taper = 0.88;
    return result;
  };
  base.on_it = {boss(0.026, -0.045, 0.012, 0.060), boss(0.017, 0.042, 0.030, 0.050),
                boss(0.013, 0.035, -0.030, 0.044), boss(0.016, -0.025, -0.042, 0.028)};
  base.on_it[0].on_it = {{circle({-0.045, 0.012}, 0.012, 32), s.high(0.045)}};
  return solid_of(base);
}

Mesh mounting_base(Draws& draws) {
  const Sizes s(draws);
  const double w = s.high(0.05);
  Loop wall = {{-0.06, -0.05},  {0.06, -0.05},    {0.06, 0.03},   {0.048, 0.03},
               {0.048, -0.038}, {-0.048, -0.038}, {-0.048, 0.05}, {-0.06, 0.05}};
  return solid_of(Terrace{s.box(0.19, 0.15, 0, 0),
                          s.high(0.012),
                          {{wall, w},
                           s.drilled(0.02, 0, 0.005),
                           s.drilled(0.006, -0.08, -0.06),
                           s.drilled(0.006, 0.08, -0.06),
                           s.drilled(0.006, 0.08, 0.06)}});
}

}  // namespace

std::vector<ViewPart> plate_parts(Draws& draws) {
  std::vector<ViewPart> parts;
  parts.push_back({"ribbed bracket", bracket(draws, 0)});
  parts.push_back({"stepped block", stepped_block(draws)});
  parts.push_back({"casing", casing(draws)});
  parts.push_back({"frame", frame(draws)});
  parts.push_back({"gear plate", gear_plate(draws)});
  parts.push_back({"slotted plate", slotted_plate(draws)});
  parts.push_back({"cast body", cast_body(draws)});
  parts.push_back({"mounting base", mounting_base(draws)});
  return parts;
}

std::vector<ViewPart> symmetric_parts(Draws& draws) {
  const Sizes s(draws);
  const double radius = draws.between(0.06, 0.09);
  std::vector<Terrace> on_it = {{circle({0, 0}, 0.4 * radius, 48), s.high(0.03)}};
  for (int i = 0; i < 6; ++i) {
    const Eigen::Rotation2Dd turn(M_PI * i / 3);
    on_it.push_back(hole(turn * Vector2d(0.75 * radius, 0), 0.09 * radius));
  }
  std::vector<ViewPart> parts;
  parts.push_back(
      {"flange", solid_of(Terrace{circle({0, 0}, radius, 48), s.high(0.014), on_it}), true});
  parts.push_back({"box", solid_of(Terrace{s.box(0.16, 0.1, 0, 0), s.high(0.05)}), true});
  parts.push_back({"disc", solid_of(Terrace{circle({0, 0}, radius, 90), s.high(0.02)}), true});
  return parts;
}

ViewPart bracket_variant(Draws& draws) {
  constexpr double kMoved = -0.03;  // [m] of the rib
  return {"ribbed bracket with one rib elsewhere", bracket(draws, kMoved)};
}

}  // namespace scanner_views
