// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/multiplicity.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace scan_calibration {
namespace {

/// Correlation of neighbours, from sums over the pairs and over all values.
class Correlation {
 public:
  void add(double value) {
    squares_ += value * value;
    values_ += 1;
  }
  void add_pair(double one, double other) {
    products_ += one * other;
    pairs_ += 1;
  }

  /// Lower bound: two standard deviations below the estimate, but not below 0.
  double min() const {
    constexpr double kMax = 0.98;      // chosen: keeps the sums finite
    constexpr double kMinRms = 1e-3;   // [px] chosen: less is rounding
    constexpr double kDeviations = 2;  // chosen: chance alone exceeds it in 2 % of cases
    if (!(squares_ > kMinRms * kMinRms * values_) || pairs_ < 1) return 0;
    const double correlation = products_ / pairs_ / (squares_ / values_);
    return std::clamp(correlation - kDeviations / std::sqrt(pairs_), 0., kMax);
  }

 private:
  double squares_ = 0, values_ = 0, products_ = 0, pairs_ = 0;
};

void add_view(const std::vector<Eigen::Vector2d>& residuals, const BoardView& view,
              double square_size, Correlation& correlation) {
  std::map<std::pair<long, long>, Eigen::Vector2d> at;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!(view.weights[i] > 0)) continue;
    const Eigen::Vector2d place = view.places[i] / square_size;
    at[{std::lround(place.x()), std::lround(place.y())}] = residuals[i];
  }
  for (const auto& [place, residual] : at) {
    const auto& [column, row] = place;
    for (int axis = 0; axis < 2; ++axis)
      correlation.add(residual[axis]);
    for (const auto& neighbour :
         {std::make_pair(column + 1, row), std::make_pair(column, row + 1)}) {
      const auto found = at.find(neighbour);
      if (found == at.end()) continue;
      for (int axis = 0; axis < 2; ++axis)
        correlation.add_pair(residual[axis], found->second[axis]);
    }
  }
}

}  // namespace

double corner_multiplicity(const ScannerState& state, const BoardSurface& surface,
                           const Board& board, const BoardViews& views) {
  Correlation correlation;
  double corners = 0;
  for (const BoardView& view : views)
    corners += static_cast<double>(view.places.size()) / static_cast<double>(views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
    add_view(corner_residuals(state, surface, sight_of(state, views[i], i), views[i]), views[i],
             board.square_size, correlation);
  const double least = correlation.min();
  constexpr double kMinResiduals = 24;  // a view must count as: chosen, four times its pose's six
  double sum = 0;
  for (int row = 1 - board.rows; row < board.rows; ++row)
    for (int column = 1 - board.columns; column < board.columns; ++column) {
      const double part = (1 - std::abs(row) / static_cast<double>(board.rows)) *
                          (1 - std::abs(column) / static_cast<double>(board.columns));
      sum += part * std::pow(least, std::hypot(row, column));
    }
  return std::clamp(sum, 1., std::max(1., 2 * corners / kMinResiduals));
}

double line_multiplicity(const ScannerState& state, const BoardSurface& surface,
                         const BoardViews& views, std::size_t laser) {
  Correlation correlation;
  double points = 0, lines = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const LinePoints& line = views[i].lines[laser];
    const std::vector<double> residuals =
        line_residuals(state, surface, sight_of(state, views[i], i), line, laser);
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      if (!(line.weights[k] > 0)) continue;
      correlation.add(residuals[k]);
      if (k > 0 && line.weights[k - 1] > 0) correlation.add_pair(residuals[k - 1], residuals[k]);
    }
    points += static_cast<double>(residuals.size());
    lines += residuals.empty() ? 0 : 1;
  }
  const double least = correlation.min();
  const double length = points / lines;
  double sum = 1;
  for (int lag = 1; lag < length; ++lag)
    sum += 2 * (1 - lag / length) * std::pow(least, lag);
  return sum;
}

}  // namespace scan_calibration
