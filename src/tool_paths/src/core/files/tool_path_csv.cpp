// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "files/csv_line.h"
#include "path/number_text.h"
#include "path/pose_convention.h"
#include "path/pose_names.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/errors/utf8.h"
#include "tool_paths/tool_path_files.h"

namespace tool_paths {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::parse_number;
using scan_cell_common::UnusableInput;

const std::string kSegment = "segment";

void check_names(const std::vector<std::string>& names, const std::string& where) {
  if (names.size() == 1 && names[0].find(';') != std::string::npos) {
    throw UnusableInput(where, "columns separated by ';'",
                        "separate them by commas, and write 0.5, not 0,5");
  }
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!name.empty() && seen.insert(name).second) continue;
    throw UnusableInput(where, fmt::format("column '{}' is unnamed or occurs twice", excerpt(name)),
                        "give each column a name of its own");
  }
}

/// Reads the lines of a table, the first of which names the columns.
class Reader {
 public:
  Reader(const std::string& source, const PathConventions& conventions)
      : source_(source), conventions_(conventions) {
    file_.path.name = source;
  }

  void read_line(const std::vector<std::string>& fields, const std::string& where) {
    if (names_.empty()) return read_header(fields, where);
    if (fields.size() != names_.size()) {
      throw UnusableInput(
          where, fmt::format("{} values", fields.size()),
          fmt::format("give {}, as in the header, and write 0.5, not 0,5", names_.size()));
    }
    std::vector<Segment>& segments = file_.path.segments;
    const std::string name = segment_ < names_.size() ? fields[segment_] : "";
    if (segments.empty() || segments.back().name != name) segments.push_back({name, {}});
    segments.back().waypoints.push_back(waypoint_of(fields, where));
  }

  ToolPathFile finish() {
    if (names_.empty()) {
      throw UnusableInput(source_, "empty",
                          "begin the file with a header line x,y,z[,qx,qy,qz,qw]");
    }
    if (file_.path.segments.empty()) {
      throw UnusableInput(source_, "no waypoints below the header", "give at least one");
    }
    check_angles(file_.layout.pose, angles_, source_);
    if (file_.layout.pose.orientation == OrientationKind::kToolVector) {
      for (Segment& segment : file_.path.segments)
        carry_spin_along(segment);
    }
    return std::move(file_);
  }

 private:
  void read_header(const std::vector<std::string>& names, const std::string& where) {
    check_names(names, where);
    names_ = names;
    const auto segment = std::find_if(names.begin(), names.end(), [](const std::string& name) {
      return scan_cell_common::lower_case(name) == kSegment;
    });
    segment_ = static_cast<std::size_t>(segment - names.begin());
    std::vector<std::string> others;  // without the segments' names, which are not numbers
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i == segment_) continue;
      others.push_back(names[i]);
      columns.push_back(i);
    }
    const PoseNames found = understand(others, conventions_, where);
    for (const std::size_t i : found.position)
      pose_columns_.push_back(columns[i]);
    for (const std::size_t i : found.orientation)
      pose_columns_.push_back(columns[i]);
    for (const std::size_t i : found.process) {
      process_columns_.push_back(columns[i]);
      file_.path.process_names.push_back(others[i]);
    }
    file_.path.has_orientation = found.convention.orientation != OrientationKind::kNone;
    file_.layout.pose = found.convention;
    file_.layout.columns = names;
    if (segment_ < names.size()) file_.layout.segment_column = names[segment_];
  }

  double number(const std::vector<std::string>& fields, std::size_t column,
                const std::string& where) const {
    const std::optional<double> value = parse_number(fields[column]);
    if (!value || !std::isfinite(*value)) {
      throw UnusableInput(
          where, fmt::format("{} = '{}'", excerpt(names_[column]), excerpt(fields[column])),
          "give a finite number");
    }
    return *value;
  }

  Waypoint waypoint_of(const std::vector<std::string>& fields, const std::string& where) {
    std::vector<double> numbers;
    for (const std::size_t column : pose_columns_)
      numbers.push_back(number(fields, column, where));
    Waypoint waypoint;
    waypoint.pose = pose_from(file_.layout.pose, numbers, where);
    if (file_.layout.pose.degrees)
      angles_.insert(angles_.end(), numbers.begin() + 3, numbers.end());
    for (const std::size_t column : process_columns_)
      waypoint.process_values.push_back(number(fields, column, where));
    return waypoint;
  }

  const std::string& source_;
  const PathConventions& conventions_;
  ToolPathFile file_;
  std::vector<std::string> names_;
  std::size_t segment_ = 0;  // index of its column; number of columns: none
  std::vector<std::size_t> pose_columns_;
  std::vector<std::size_t> process_columns_;
  std::vector<double> angles_;  // [degrees] of all waypoints
};

/// Segments are distinguished by their names, so neighbours with the same name get a number.
std::vector<std::string> distinct_names(const ToolPath& path) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    std::string name =
        path.segments[i].name.empty() ? fmt::to_string(i + 1) : path.segments[i].name;
    if (!names.empty() && names.back() == name) name += fmt::format("_{}", i + 1);
    names.push_back(name);
  }
  return names;
}

/// Adds the columns of a new file if the path did not come from CSV.
PathLayout with_columns(PathLayout layout, const ToolPath& path) {
  if (!layout.columns.empty()) return layout;
  layout.columns.assign(layout.pose.position.begin(), layout.pose.position.end());
  layout.columns.insert(layout.columns.end(), layout.pose.names.begin(), layout.pose.names.end());
  const bool one_unnamed = path.segments.size() == 1 && path.segments[0].name.empty();
  if (!one_unnamed) layout.columns.push_back(layout.segment_column = kSegment);
  layout.columns.insert(layout.columns.end(), path.process_names.begin(), path.process_names.end());
  return layout;
}

/// The index of each column in a waypoint's texts: position, orientation, process values, segment.
std::vector<std::size_t> places_of(const PathLayout& layout, const ToolPath& path) {
  std::vector<std::string> texts(layout.pose.position.begin(), layout.pose.position.end());
  texts.insert(texts.end(), layout.pose.names.begin(), layout.pose.names.end());
  texts.insert(texts.end(), path.process_names.begin(), path.process_names.end());
  texts.push_back(layout.segment_column);
  std::set<std::string> seen;
  std::vector<std::size_t> places;
  for (const std::string& column : layout.columns) {
    if (!seen.insert(column).second) {
      throw UnusableInput(fmt::format("tool path '{}'", path.name),
                          fmt::format("two columns '{}' for CSV", column),
                          "rename the process value, or write YAML");
    }
    const auto at = std::find(texts.begin(), texts.end(), column);
    if (at == texts.end()) {
      throw UnusableInput(fmt::format("tool path '{}'", path.name),
                          fmt::format("no values for '{}'", column),
                          "write it in the layout of its own file, or as a new file");
    }
    places.push_back(static_cast<std::size_t>(at - texts.begin()));
  }
  return places;
}

std::string line_of(const std::vector<std::string>& texts, const std::vector<std::size_t>& places) {
  std::string line;
  for (const std::size_t place : places)
    line += (line.empty() ? "" : ",") + texts[place];
  return line + "\n";
}

}  // namespace

ToolPathFile parse_tool_path_csv(const std::string& text, const std::string& source,
                                 const PathConventions& conventions) {
  Reader reader(source, conventions);
  std::istringstream lines{std::string(scan_cell_common::without_byte_order_mark(text))};
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::string content = trimmed(line);
    if (content.empty() || content[0] == '#') continue;
    scan_cell_common::check_utf8(content, source, number);
    const std::string where = fmt::format("{}, line {}", source, number);
    reader.read_line(split(line, where), where);
  }
  return reader.finish();
}

std::string tool_path_to_csv(const ToolPath& path, const PathLayout& given) {
  PathLayout layout = given;
  layout.pose = convention_for(path, given.pose);
  layout = with_columns(layout, path);
  std::string text;
  for (const std::string& column : layout.columns)
    text += (text.empty() ? "" : ",") + quoted_where_needed(column);
  text += "\n";
  const std::vector<std::size_t> places = places_of(layout, path);
  const std::vector<std::string> names = distinct_names(path);
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(path.segments[s]);
    for (std::size_t w = 0; w < rotations.size(); ++w) {
      const Waypoint& waypoint = path.segments[s].waypoints[w];
      std::vector<std::string> texts;
      for (const double number : numbers_of(layout.pose, waypoint.pose.translation(), rotations[w]))
        texts.push_back(to_text(number));
      for (const double value : waypoint.process_values)
        texts.push_back(to_text(value));
      texts.push_back(quoted_where_needed(names[s]));
      text += line_of(texts, places);
    }
  }
  return text;
}

}  // namespace tool_paths
