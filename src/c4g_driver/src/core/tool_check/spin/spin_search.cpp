// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <limits>

#include "tool_check/spin/spin.h"

namespace c4g_driver {
namespace {

constexpr int kCells = 73;  // [-270, 270] degrees; chosen
constexpr int kMiddle = kCells / 2;
constexpr double kStep = 7.5 * M_PI / 180;  // [rad]
constexpr int kFarthest = 3;                // cells from node to node; chosen
constexpr double kNever = std::numeric_limits<double>::infinity();

double turn_of(int cell) {
  return (cell - kMiddle) * kStep;
}

struct Cell {
  bool reached = false;
  Joints joints;         // [rad] if reached
  double cost = kNever;  // of the way up to here
  int before = -1;       // cell of the node before
};

using Row = std::array<Cell, kCells>;

/// Fills the cells not yet reached from their neighbours.
void spread(Row& row, const SpinArm& arm, const SpinNode& node) {
  const auto reach = [&](int cell, int from) {
    Cell& taken = row[static_cast<std::size_t>(cell)];
    const Cell& other = row[static_cast<std::size_t>(from)];
    if (taken.reached || !other.reached) return;
    const auto joints = arm.joints(node, turn_of(cell), other.joints);
    taken.reached = joints.has_value();
    if (joints) taken.joints = *joints;
  };
  for (int cell = 1; cell < kCells; ++cell)
    reach(cell, cell - 1);
  for (int cell = kCells - 2; cell >= 0; --cell)
    reach(cell, cell + 1);
}

/// A small cost, so that the nearest is chosen of turns that are equally good along the whole path.
double approach(const Joints& start, const Joints& joints, const SpinArm& arm) {
  constexpr double kWeight = 0.01;  // [1/s] chosen
  return kWeight * (joints - start).cwiseQuotient(arm.speed()).squaredNorm();
}

Row first_row(const SpinArm& arm, const SpinNode& node, const Joints& start, bool begins_there) {
  Row row;
  row[kMiddle].reached = true;
  row[kMiddle].joints = start;
  spread(row, arm, node);
  for (int i = 0; i < kCells; ++i) {
    Cell& cell = row[static_cast<std::size_t>(i)];
    if (begins_there && i != kMiddle) continue;
    if (cell.reached && arm.possible(cell.joints)) cell.cost = approach(start, cell.joints, arm);
  }
  return row;
}

void take_cheapest(Row& row, int cell, const Row& before, const SpinArm& arm, double seconds) {
  Cell& taken = row[static_cast<std::size_t>(cell)];
  const double strain = arm.strain(taken.joints) * seconds;
  const int last = std::min(kCells - 1, cell + kFarthest);
  for (int other = std::max(0, cell - kFarthest); other <= last; ++other) {
    const Cell& from = before[static_cast<std::size_t>(other)];
    if (!(from.cost < taken.cost)) continue;
    const double cost = from.cost + strain + arm.cost(from.joints, taken.joints, seconds);
    if (!(cost < taken.cost)) continue;
    taken.cost = cost;
    taken.before = other;
  }
}

/// @return whether any turn is possible there
bool next_row(Row& row, const Row& before, const SpinArm& arm, const SpinNode& node) {
  for (int i = 0; i < kCells; ++i) {
    const Cell& from = before[static_cast<std::size_t>(i)];
    if (!from.reached) continue;
    const auto joints = arm.joints(node, turn_of(i), from.joints);
    Cell& cell = row[static_cast<std::size_t>(i)];
    cell.reached = joints.has_value();
    if (joints) cell.joints = *joints;
  }
  spread(row, arm, node);
  bool any = false;
  for (int i = 0; i < kCells; ++i) {
    Cell& cell = row[static_cast<std::size_t>(i)];
    if (!cell.reached) continue;
    take_cheapest(row, i, before, arm, node.seconds);
    if (cell.cost < kNever && !arm.possible(cell.joints)) cell.cost = kNever;
    any = any || cell.cost < kNever;
  }
  return any;
}

Spin way_back(const std::vector<Row>& rows) {
  int cell = 0;
  for (int i = 1; i < kCells; ++i) {
    if (rows.back()[static_cast<std::size_t>(i)].cost <
        rows.back()[static_cast<std::size_t>(cell)].cost)
      cell = i;
  }
  Spin spin;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    const Cell& taken = (*row)[static_cast<std::size_t>(cell)];
    spin.turns.insert(spin.turns.begin(), turn_of(cell));
    spin.joints.insert(spin.joints.begin(), taken.joints);
    cell = taken.before;
  }
  return spin;
}

}  // namespace

std::optional<Spin> search_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes,
                                const Joints& start, bool begins_there) {
  std::vector<Row> rows = {first_row(arm, nodes.front(), start, begins_there)};
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    rows.emplace_back();
    if (!next_row(rows[i], rows[i - 1], arm, nodes[i])) return std::nullopt;
  }
  return way_back(rows);
}

}  // namespace c4g_driver
