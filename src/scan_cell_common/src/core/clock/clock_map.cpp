// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clock/clock_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

constexpr Nanoseconds kCellsInWindow = 4;
constexpr double kStep = 1e6;  // [ns] a clock that is off by more than this was set

Nanoseconds floor_of(Nanoseconds time, Nanoseconds width) {
  return time / width - (time % width < 0 ? 1 : 0);
}

}  // namespace

ClockMap::ClockMap(Nanoseconds window) : window_(window) {
  if (window <= 0) {
    throw InvalidParameter("clock map window", fmt::format("{} ns", window),
                           "give a window above 0");
  }
}

void ClockMap::begin(Nanoseconds device, Nanoseconds host) {
  reference_device_ = device;
  reference_offset_ = host - device;
  first_ = count_ = 0;
  slope_ = height_ = support_ = 0;
}

void ClockMap::add(Nanoseconds device, Nanoseconds host) {
  if (empty() || device < last_device_) begin(device, host);
  last_device_ = device;
  Cell pair;
  pair.number = floor_of(device, std::max<Nanoseconds>(1, window_ / kCellsInWindow));
  pair.device = static_cast<double>(device - reference_device_);
  pair.offset = static_cast<double>(host - device - reference_offset_);
  if (!empty() && above_line(pair) < support_ - kStep) {  // earlier than it could be
    begin(device, host);
    pair.device = pair.offset = 0;
    ++steps_;
  }
  const bool changed = keep(pair);
  const double recent = pair.device - static_cast<double>(window_);
  if (changed) fit();
  height_ = least_since(recent);
  if (height_ <= support_ + kStep) return;
  drop_before(recent);  // later than it was for a whole window
  ++steps_;
  fit();
  height_ = least_since(recent);
}

/// @return true if the cells have changed
bool ClockMap::keep(const Cell& pair) {
  const std::size_t before = count_;
  const auto forgotten = static_cast<Nanoseconds>(kCells);
  while (count_ > 0 && cell(0).number <= pair.number - forgotten) {
    first_ = (first_ + 1) % kCells;
    --count_;
  }
  if (count_ > 0 && cell(count_ - 1).number == pair.number) {
    if (above_line(pair) >= above_line(cell(count_ - 1))) return count_ != before;
    cell(count_ - 1) = pair;
    return true;
  }
  cell(count_++) = pair;
  return true;
}

void ClockMap::drop_before(double device) {
  while (count_ > 1 && cell(0).device < device) {
    first_ = (first_ + 1) % kCells;
    --count_;
  }
}

/// Weights the slope of the hull by its certainty against the prior that clocks have no drift.
void ClockMap::fit() {
  constexpr double kPrior = 100e-6;  // usual drift of clocks
  constexpr double kEdge = 3;        // two pairs of the hull's edge, less than the history apart
  constexpr double kMost = 1e-3;     // no clock drifts more
  constexpr std::size_t kLeast = 6;  // cells: the hull's edge takes two, the rest show the jitter
  slope_ = 0;
  if (count_ >= kLeast) {
    slope_ = std::clamp(hull_slope(), -kMost, kMost);
    const double history = cell(count_ - 1).device - cell(0).device;
    const double uncertain = kEdge * median_residual() / history;
    slope_ /= 1 + std::pow(uncertain / kPrior, 2);
  }
  support_ = least_since(std::numeric_limits<double>::lowest());
}

/// The slope of the lower hull's edge over the middle of the history: of all lines below the pairs,
/// this one has the least sum of distances to them.
double ClockMap::hull_slope() const {
  std::array<std::size_t, kCells> hull{};
  std::size_t corners = 0;
  double middle = 0;
  const auto slope = [this](std::size_t from, std::size_t to) {
    return (cell(to).offset - cell(from).offset) / (cell(to).device - cell(from).device);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    middle += cell(i).device / static_cast<double>(count_);
    while (corners > 1 &&
           slope(hull[corners - 2], i) <= slope(hull[corners - 2], hull[corners - 1]))
      --corners;
    hull[corners++] = i;
  }
  std::size_t edge = 1;
  while (edge + 1 < corners && cell(hull[edge]).device < middle)
    ++edge;
  return slope(hull[edge - 1], hull[edge]);
}

double ClockMap::least_since(double device) const {
  double least = above_line(cell(count_ - 1));
  for (std::size_t i = count_ - 1; i-- > 0 && cell(i).device >= device;)
    least = std::min(least, above_line(cell(i)));
  return least;
}

double ClockMap::median_residual() const {
  std::array<double, kCells> residuals{};
  for (std::size_t i = 0; i < count_; ++i)
    residuals[i] = above_line(cell(i));
  const auto end = residuals.begin() + static_cast<std::ptrdiff_t>(count_);
  const double least = *std::min_element(residuals.begin(), end);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
  std::nth_element(residuals.begin(), middle, end);
  return *middle - least;
}

Nanoseconds ClockMap::to_host(Nanoseconds device) const {
  if (empty()) {
    throw Refused("device clock", "no message received yet", "wait for the device's first message");
  }
  const auto passed = static_cast<double>(device - reference_device_);
  return device + reference_offset_ + std::llround(height_ + slope_ * passed);
}

ClockMap::Figures ClockMap::figures() const {
  Figures figures;
  if (empty()) return figures;
  figures.drift = -slope_ / (1 + slope_);
  figures.residual = std::llround(median_residual());
  figures.history = std::llround(cell(count_ - 1).device - cell(0).device);
  figures.steps = steps_;
  return figures;
}

}  // namespace scan_cell_common
