// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "number_text.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/text.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::parse_number;
using scan_cell_common::UnusableInput;

const std::array<std::string, 3> kPosition = {"x", "y", "z"};
const std::array<std::string, 4> kOrientation = {"qx", "qy", "qz", "qw"};
const std::string kSegment = "segment";

constexpr const char* kBlanks = " \t\r";

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(kBlanks) == std::string::npos;
}

/// The fields of a line; one in double quotes may hold commas, and quotes doubled (RFC 4180).
std::vector<std::string> split(const std::string& line, const std::string& where) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  bool was_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"' && (quoted || is_blank(fields.back()))) {
      if (!quoted) fields.back().clear();
      quoted = !quoted;
      was_quoted = true;
    } else if (c == ',' && !quoted) {
      if (!was_quoted) fields.back() = trimmed(fields.back());
      was_quoted = false;
      fields.emplace_back();
    } else if (!was_quoted || quoted) {
      fields.back() += c;
    }
  }
  if (quoted) throw UnusableInput(where, "a quote is not closed", "close it");
  if (!was_quoted) fields.back() = trimmed(fields.back());
  return fields;
}

/// Which column holds what.
struct Columns {
  std::array<std::size_t, 3> position{};
  std::array<std::size_t, 4> orientation{};
  bool has_orientation = false;
  bool has_segment = false;
  std::size_t segment = 0;
  std::vector<std::size_t> process;
  std::vector<std::string> names;
};

void check_names(const std::vector<std::string>& names, const std::string& where) {
  if (names.size() == 1 && names[0].find(';') != std::string::npos) {
    throw UnusableInput(where, "columns separated by ';'",
                        "separate them by commas, and write 0.5, not 0,5");
  }
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!name.empty() && seen.insert(name).second) continue;
    throw UnusableInput(where, "column '" + excerpt(name) + "' is unnamed or occurs twice",
                        "give each column a name of its own");
  }
}

Columns columns_of(const std::vector<std::string>& names, const std::string& where) {
  check_names(names, where);
  Columns columns;
  columns.names = names;
  const auto find = [&names](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  std::size_t quaternion_columns = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    columns.position[i] = find(kPosition[i]);
    if (columns.position[i] == names.size()) {
      throw UnusableInput(where, "no column '" + kPosition[i] + "'",
                          "start the file with a header line x,y,z[,qx,qy,qz,qw]");
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    columns.orientation[i] = find(kOrientation[i]);
    if (columns.orientation[i] < names.size()) ++quaternion_columns;
  }
  if (quaternion_columns != 0 && quaternion_columns != 4) {
    throw UnusableInput(where, "only some of the columns qx,qy,qz,qw", "give all four or none");
  }
  columns.has_orientation = quaternion_columns == 4;
  columns.segment = find(kSegment);
  columns.has_segment = columns.segment < names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto is_one_of = [&names, i](const auto& known) {
      return std::find(known.begin(), known.end(), names[i]) != known.end();
    };
    if (!is_one_of(kPosition) && !is_one_of(kOrientation) && names[i] != kSegment) {
      columns.process.push_back(i);
    }
  }
  return columns;
}

Waypoint waypoint_of(const std::vector<std::string>& fields, const Columns& columns,
                     const std::string& where) {
  if (fields.size() != columns.names.size()) {
    throw UnusableInput(where, std::to_string(fields.size()) + " values",
                        "give " + std::to_string(columns.names.size()) +
                            ", as in the header, and write 0.5, not 0,5");
  }
  const auto number = [&](std::size_t column) {
    const std::optional<double> value = parse_number(fields[column]);
    if (!value || !std::isfinite(*value)) {
      throw UnusableInput(where,
                          excerpt(columns.names[column]) + " = '" + excerpt(fields[column]) + "'",
                          "give a finite number");
    }
    return *value;
  };
  Waypoint waypoint;
  for (int i = 0; i < 3; ++i) {
    waypoint.pose.translation()[i] = number(columns.position[static_cast<std::size_t>(i)]);
  }
  if (columns.has_orientation) {
    Eigen::Vector4d xyzw;
    for (int i = 0; i < 4; ++i)
      xyzw[i] = number(columns.orientation[static_cast<std::size_t>(i)]);
    waypoint.pose.linear() = rotation_from(xyzw, where);
  }
  for (const std::size_t column : columns.process)
    waypoint.process_values.push_back(number(column));
  return waypoint;
}

std::string quoted_where_needed(const std::string& text) {
  const bool plain = text.find_first_of(",\"\n\r#") == std::string::npos && text == trimmed(text);
  if (plain) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      result += ' ';
    } else {
      result += c == '"' ? "\"\"" : std::string(1, c);
    }
  }
  return result + "\"";
}

/// Segments are told apart by their names: neighbours of the same name get a number.
std::vector<std::string> distinct_names(const ToolPath& path) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    std::string name =
        path.segments[i].name.empty() ? std::to_string(i + 1) : path.segments[i].name;
    if (!names.empty() && names.back() == name) name += "_" + std::to_string(i + 1);
    names.push_back(name);
  }
  return names;
}

}  // namespace

ToolPath parse_tool_path_csv(const std::string& text, const std::string& source) {
  ToolPath path;
  path.name = source;
  Columns columns;
  std::istringstream lines{std::string(scan_cell_common::without_byte_order_mark(text))};
  std::string line;
  std::size_t number = 0;
  while (std::getline(lines, line)) {
    ++number;
    const std::string content = trimmed(line);
    if (content.empty() || content[0] == '#') continue;
    const std::string where = source + ", line " + std::to_string(number);
    const std::vector<std::string> fields = split(line, where);
    if (columns.names.empty()) {
      columns = columns_of(fields, where);
      path.has_orientation = columns.has_orientation;
      for (const std::size_t column : columns.process)
        path.process_names.push_back(columns.names[column]);
      continue;
    }
    Waypoint waypoint = waypoint_of(fields, columns, where);
    const std::string name = columns.has_segment ? fields[columns.segment] : "";
    if (path.segments.empty() || path.segments.back().name != name) {
      path.segments.push_back({name, {}});
    }
    path.segments.back().waypoints.push_back(std::move(waypoint));
  }
  if (columns.names.empty()) {
    throw UnusableInput(source, "empty", "start the file with a header line x,y,z[,qx,qy,qz,qw]");
  }
  if (path.segments.empty()) {
    throw UnusableInput(source, "no waypoints below the header", "give at least one");
  }
  return path;
}

std::string tool_path_to_csv(const ToolPath& path) {
  const bool one_unnamed = path.segments.size() == 1 && path.segments[0].name.empty();
  std::string text = "x,y,z";
  if (path.has_orientation) text += ",qx,qy,qz,qw";
  if (!one_unnamed) text += "," + kSegment;
  for (const std::string& name : path.process_names)
    text += "," + quoted_where_needed(name);
  text += "\n";
  const std::vector<std::string> names = distinct_names(path);
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(path.segments[s]);
    for (std::size_t w = 0; w < rotations.size(); ++w) {
      const Waypoint& waypoint = path.segments[s].waypoints[w];
      const Eigen::Vector3d at = waypoint.pose.translation();
      text += to_text(at.x()) + "," + to_text(at.y()) + "," + to_text(at.z());
      if (path.has_orientation) {
        for (const double q : rotations[w].coeffs())
          text += "," + to_text(q);
      }
      if (!one_unnamed) text += "," + quoted_where_needed(names[s]);
      for (const double value : waypoint.process_values)
        text += "," + to_text(value);
      text += "\n";
    }
  }
  return text;
}

}  // namespace tool_path_stretcher
