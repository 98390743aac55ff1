// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/figure_text.h"

#include <fmt/format.h>

#include "history/run_columns.h"
#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

std::string text_of(double value, Quantity quantity) {
  switch (quantity) {
    case Quantity::kLength:
      return millimetres_of(value) + " mm";
    case Quantity::kAngle:
      return fmt::format("{:.3f} deg", value * scan_cell_common::kDegrees);
    case Quantity::kRatio:
      break;
  }
  return fmt::format("{:.6f}", value);
}

}  // namespace

std::string millimetres_of(const std::optional<double>& metres) {
  return metres ? fmt::format("{:.4f}", *metres * scan_cell_common::kMillimetres) : "-";
}

std::vector<std::pair<std::string, std::string>> texts_of(const RunFigures& figures) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const FigureColumn& column : kFigureColumns) {
    const std::optional<double>& value = figures.*column.member;
    if (value) texts.emplace_back(column.name, text_of(*value, column.quantity));
  }
  for (const auto& [name, deviation] : figures.places)
    texts.emplace_back("place " + name,
                       deviation ? millimetres_of(deviation) + " mm" : "not known");
  return texts;
}

}  // namespace part_recipes
