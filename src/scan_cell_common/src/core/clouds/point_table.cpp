// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/scalars.h"
#include "files/table_reader.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_common {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kMaxUnnamed = 12;  // columns per point: more are a depth profile

struct ColumnName {
  std::string name;  // in lower case, without the unit
  std::string unit;  // m, mm or inch; empty: not named
};

/// "X", "x [mm]", "x(mm)" and "x_mm"
ColumnName name_of(std::string_view word) {
  std::string name = lower_case(word);
  const auto strip = [&name](const std::string& ending) {
    if (name.size() <= ending.size() || name.substr(name.size() - ending.size()) != ending)
      return false;
    name.resize(name.size() - ending.size());
    while (name.size() > 1 && (name.back() == ' ' || name.back() == '_'))
      name.pop_back();
    return true;
  };
  static const std::array<std::pair<const char*, const char*>, 4> kUnits = {
      {{"mm", "mm"}, {"inch", "inch"}, {"in", "inch"}, {"m", "m"}}};
  for (const auto& [written, unit] : kUnits) {
    for (const std::string& form : {"[" + std::string(written) + "]",
                                    "(" + std::string(written) + ")", "_" + std::string(written)}) {
      if (strip(form)) return {name, unit};
    }
  }
  return {name, ""};
}

/// The columns of x, y and z, and the names of the others.
struct Columns {
  std::array<std::size_t, 3> xyz{0, 1, 2};
  bool named = false;  // by a header
  std::string unit;
  std::vector<std::string> others;
};

bool is_number(std::string_view field) {
  return field.empty() || parse_number(field);
}

/// 0 to 2 for x to z, also by ParaView's names; none for others.
std::optional<std::size_t> axis_of(const std::string& name) {
  constexpr std::array<std::array<std::string_view, 3>, 2> kNames = {
      {{"x", "y", "z"}, {"points:0", "points:1", "points:2"}}};
  for (const auto& names : kNames) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  return std::nullopt;
}

/// Columns named by a header; none if x, y and z are not each named once, or have several units.
std::optional<Columns> columns_of(const Words& header) {
  Columns columns;
  columns.named = true;
  std::array<int, 3> times{};
  std::array<std::string, 3> units;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const ColumnName column = name_of(header[i]);
    const std::optional<std::size_t> axis = axis_of(column.name);
    if (axis) {
      columns.xyz[*axis] = i;
      units[*axis] = column.unit;
      ++times[*axis];
    } else if (!header[i].empty()) {
      columns.others.push_back(excerpt(header[i]));
    }
  }
  const bool one_unit = units[0] == units[1] && units[1] == units[2];
  if (times != std::array<int, 3>{1, 1, 1} || !one_unit) return std::nullopt;
  columns.unit = units[0];
  return columns;
}

[[noreturn]] void refuse_profiles(const TableReader& table) {
  table.refuse(fmt::format("{} columns and no header", table.fields().size()),
               "name x, y and z in a header, or give the steps of depth profiles (--column-step, "
               "--profile-step)");
}

/// @param is_header whether the first line, at which the table is, is not a point
Columns find_columns(const TableReader& table, bool& is_header) {
  const Words& first = table.fields();
  is_header = !std::all_of(first.begin(), first.end(), is_number);
  if (is_header) {
    const std::optional<Columns> columns = columns_of(first);
    if (columns) return *columns;
    // A point may be followed by words; a header begins with them.
    if (first.size() < 3 || !std::all_of(first.begin(), first.begin() + 3, is_number)) {
      table.refuse("neither numbers nor a header with one x, one y and one z: '" +
                       excerpt(first[0]) + (first.size() > 1 ? "', '" + excerpt(first[1]) : "") +
                       "'",
                   "name the columns x, y and z, or begin each line with them");
    }
    is_header = false;
  }
  if (table.comment().size() == first.size()) {
    const std::optional<Columns> columns = columns_of(table.comment());
    if (columns) return *columns;
  }
  if (first.size() < 3) {
    table.refuse(fmt::format("{} columns", first.size()), "give x, y and z in each line");
  }
  if (first.size() > kMaxUnnamed) refuse_profiles(table);
  Columns columns;
  for (std::size_t i = 3; i < first.size(); ++i)
    columns.others.push_back(fmt::format("{}", i + 1));
  return columns;
}

void check_unit(const Columns& columns, double metres_per_unit, const std::string& source) {
  if (columns.unit.empty() || metres_per(columns.unit) == metres_per_unit) return;
  throw FileError(source, "its header gives x, y, z in " + columns.unit,
                  "read it with --units " + columns.unit);
}

/// Detects a first column that counts the lines, which would be taken for x.
class LineCount {
 public:
  void see(double value) {
    if (seen_ == 0) first_ = value;
    counts_ = counts_ && value == first_ + static_cast<double>(seen_) && value == std::floor(value);
    ++seen_;
  }
  bool is_count() const { return counts_ && seen_ > 2; }

 private:
  bool counts_ = true;
  double first_ = 0;
  std::size_t seen_ = 0;
};

std::string note_of(const std::vector<std::string>& others) {
  std::string names;
  for (const std::string& other : others)
    names += (names.empty() ? "" : ", ") + other;
  return others.size() == 1 ? "column " + names + " is left out"
                            : "columns " + names + " are left out";
}

}  // namespace

LoadedCloud parse_point_table(std::string_view bytes, const std::string& source,
                              double metres_per_unit) {
  TableReader table(bytes, source);
  LoadedCloud loaded;
  if (!table.next()) return loaded;
  bool is_header = false;
  const Columns columns = find_columns(table, is_header);
  check_unit(columns, metres_per_unit, source);
  if (!columns.others.empty()) loaded.notes.push_back(note_of(columns.others));
  LineCount count;
  bool has_line = !is_header || table.next();
  for (; has_line; has_line = table.next()) {
    table.expect_columns();
    const std::array<double, 3> xyz = {table.number(columns.xyz[0]), table.number(columns.xyz[1]),
                                       table.number(columns.xyz[2])};
    count.see(xyz[0]);
    loaded.cloud.points.emplace_back(to_float(xyz[0]), to_float(xyz[1]), to_float(xyz[2]));
  }
  if (!columns.named && !columns.others.empty() && count.is_count()) {
    throw FileError(source, "its first column counts the lines", "name x, y and z in a header");
  }
  loaded.cloud.width = static_cast<std::uint32_t>(loaded.cloud.points.size());
  loaded.cloud.height = 1;
  return loaded;
}

}  // namespace scan_cell_common
