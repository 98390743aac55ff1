// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/export/history_csv.h"

#include <fmt/format.h>

#include <set>

#include "history/run_columns.h"

namespace part_recipes {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The unit in which people read a quantity.
struct Unit {
  const char* ending;  // of a column's name
  double factor;
};

Unit unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kLength:
      return {"_mm", 1e3};
    case Quantity::kAngle:
      return {"_deg", 180 / kPi};
    case Quantity::kRatio:
      break;
  }
  return {"", 1};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char letter : text)
    result += letter == '"' ? "\"\"" : std::string(1, letter);
  return result + "\"";
}

std::string number(const std::optional<double>& value, double factor) {
  return value ? fmt::format("{:.9g}", *value * factor) : "";
}

std::string head(const std::set<std::string>& places) {
  std::string line = "sequence,state";
  for (const TextColumn& text : kTextColumns)
    line += std::string(",") + text.name;
  line += ",tolerance_mm";
  for (const FigureColumn& figure : kFigureColumns)
    line += std::string(",") + figure.name + unit_of(figure.quantity).ending;
  for (const std::string& place : places)
    line += "," + quoted("place " + place + " [mm]");
  return line + "\r\n";
}

}  // namespace

std::string to_csv(const std::vector<HistoryRun>& runs) {
  std::set<std::string> places;
  for (const HistoryRun& run : runs) {
    for (const auto& [name, deviation] : run.record.figures.places)
      places.insert(name);
  }
  std::string text = head(places);
  const double millimetres = unit_of(Quantity::kLength).factor;
  for (const HistoryRun& run : runs) {
    text += fmt::format("{},{}", run.sequence, to_string(run.record.state));
    for (const TextColumn& column : kTextColumns)
      text += "," + quoted(run.record.*column.member);
    text += "," + number(run.record.tolerance, millimetres);
    const RunFigures& figures = run.record.figures;
    for (const FigureColumn& column : kFigureColumns)
      text += "," + number(figures.*column.member, unit_of(column.quantity).factor);
    for (const std::string& place : places) {
      const auto found = figures.places.find(place);
      text += "," + (found != figures.places.end() ? number(found->second, millimetres) : "");
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace part_recipes
