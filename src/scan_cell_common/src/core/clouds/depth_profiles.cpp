// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/scalars.h"
#include "files/table_reader.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

/// Whether the first line has only words. One of words and numbers may hold the columns' positions.
bool is_header(const TableReader& table) {
  const auto is_word = [](std::string_view field) {
    return !field.empty() && !parse_number(field);
  };
  const auto& fields = table.fields();
  const auto words = std::count_if(fields.begin(), fields.end(), is_word);
  const auto empty = std::count(fields.begin(), fields.end(), std::string_view{});
  return words > 0 && words + empty == static_cast<std::ptrdiff_t>(fields.size());
}

bool is_invalid(double value, const std::vector<double>& invalid) {
  return !std::isfinite(value) || std::find(invalid.begin(), invalid.end(), value) != invalid.end();
}

}  // namespace

LoadedCloud parse_depth_profiles(std::string_view bytes, const std::string& source,
                                 const CloudFormat& format) {
  TableReader table(bytes, source);
  LoadedCloud loaded;
  if (!table.next()) return loaded;
  const bool header = is_header(table);
  if (header) loaded.notes.push_back("the first line is a header and is left out");
  const std::size_t columns = table.fields().size();
  if (columns < 2) table.refuse("one column", "give a profile in each line, z in each column");
  std::size_t profiles = 0, empty = 0;
  bool has_line = !header || table.next();
  for (; has_line; has_line = table.next(), ++profiles) {
    table.expect_columns();
    const double y = static_cast<double>(profiles) * format.profile_step;
    for (std::size_t column = 0; column < columns; ++column) {
      const double z = table.number(column);
      if (is_invalid(z, format.invalid)) {
        ++empty;
        continue;
      }
      const double x = static_cast<double>(column) * format.column_step;
      loaded.cloud.points.emplace_back(to_float(x), to_float(y), to_float(z));
    }
  }
  loaded.notes.push_back(
      fmt::format("{} profiles of {} columns, {} of their {} values are not measurements", profiles,
                  columns, empty, profiles * columns));
  loaded.cloud.width = static_cast<std::uint32_t>(loaded.cloud.points.size());
  loaded.cloud.height = 1;
  return loaded;
}

}  // namespace scan_cell_common
