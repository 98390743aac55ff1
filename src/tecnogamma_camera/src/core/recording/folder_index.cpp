// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>

#include "recording/folder_recording.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/files/csv_reader.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::CsvReader;
using scan_cell_common::excerpt;

constexpr std::array<const char*, 9> kColumns = {"file",      "frame",          "device_time",
                                                 "time",      "packets_lost",   "first_column",
                                                 "first_row", "sensor_columns", "sensor_rows"};
constexpr std::uint64_t kMaxPixels = 65535;  // [px] as the parameters'

/// Fields of a line by the names of its columns.
class Line {
 public:
  Line(const std::vector<std::string>& columns, const CsvReader& reader)
      : columns_(columns), reader_(reader) {
    reader.expect_fields(columns.size());
  }

  std::string_view text(const char* column) const {
    const auto at = std::find(columns_.begin(), columns_.end(), column);
    return at == columns_.end() ? std::string_view()
                                : reader_.field(static_cast<std::size_t>(at - columns_.begin()));
  }

  /// 0 if it is empty or has no such column.
  std::uint64_t number(const char* column, std::uint64_t most) const {
    const std::string_view field = text(column);
    if (field.empty()) return 0;
    const auto value = scan_cell_common::parse_count(field);
    if (!value || *value > most) {
      refuse(fmt::format("{} '{}'", column, excerpt(field)),
             fmt::format("give a whole number from 0 to {}", most));
    }
    return *value;
  }

  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const {
    reader_.refuse(value, cure);
  }

 private:
  const std::vector<std::string>& columns_;
  const CsvReader& reader_;
};

std::vector<std::string> read_header(const CsvReader& reader) {
  std::vector<std::string> columns;
  for (const std::string_view name : reader.fields()) {
    if (std::find(kColumns.begin(), kColumns.end(), name) == kColumns.end())
      reader.refuse("column '" + excerpt(name) + "'", "remove it: an index has no such column");
    if (std::find(columns.begin(), columns.end(), name) != columns.end())
      reader.refuse("column '" + excerpt(name) + "' twice", "name it once");
    columns.emplace_back(name);
  }
  for (const char* needed : {"file", "frame"}) {
    if (std::find(columns.begin(), columns.end(), needed) == columns.end())
      reader.refuse(std::string("no column '") + needed + "'", "add it");
  }
  return columns;
}

/// A file in the folder or below it.
std::string read_file_name(const Line& line) {
  const std::string name(line.text("file"));
  const std::filesystem::path path(name);
  const bool inside = !name.empty() && path.is_relative() &&
                      std::none_of(path.begin(), path.end(), [](const auto& part) {
                        return part.empty() || part == "." || part == "..";
                      });
  if (!inside || name.find('\0') != std::string::npos) {
    line.refuse("file '" + excerpt(name) + "'", "name a file in the index's folder, or below");
  }
  return name;
}

RecordedFile read_file_of(const Line& line) {
  RecordedFile file;
  file.file = read_file_name(line);
  if (line.text("frame").empty()) line.refuse("no frame number", "give one");
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;  // no sum overflows
  file.frame = line.number("frame", kMost);
  file.device_time = static_cast<Nanoseconds>(line.number("device_time", kMost));
  file.time = static_cast<Nanoseconds>(line.number("time", kMost));
  file.packets_lost = static_cast<std::uint32_t>(
      line.number("packets_lost", std::numeric_limits<std::uint32_t>::max()));
  return file;
}

/// Reads the place of the images on the sensor, which must be the same in all lines.
void read_place(const Line& line, bool first, FolderIndex& index) {
  const auto read = [&](const char* column, int& value) {
    const int number = static_cast<int>(line.number(column, kMaxPixels));
    if (!first && number != value) {
      line.refuse(fmt::format("{} {} after {}", column, number, value),
                  "put images of different regions into different folders");
    }
    value = number;
  };
  read("first_column", index.first_column);
  read("first_row", index.first_row);
  read("sensor_columns", index.sensor_columns);
  read("sensor_rows", index.sensor_rows);
}

}  // namespace

FolderIndex parse_folder_index(const std::string& text, const std::string& source) {
  FolderIndex index;
  CsvReader reader(text, source);
  std::vector<std::string> columns;
  while (reader.next()) {
    if (columns.empty()) {
      columns = read_header(reader);
      continue;
    }
    const Line entry(columns, reader);
    index.files.push_back(read_file_of(entry));
    read_place(entry, index.files.size() == 1, index);
  }
  if (index.files.empty()) {
    throw scan_cell_common::UnusableInput(source, "names no files",
                                          "list them after a line file,frame");
  }
  return index;
}

}  // namespace tecnogamma_camera
