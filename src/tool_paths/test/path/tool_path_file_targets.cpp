// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/tool_path_file_targets.h"

#include <algorithm>

#include "tool_paths/path_edits.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace tool_paths;
using scan_cell_common::FuzzTarget;
using scan_cell_common::promise;

const char* const kCsv =
    "x,y,z,qx,qy,qz,qw,segment,speed,\"force, N\"\n# a comment\n"
    "0.1,0.2,0.3,0,0,0,1,outer,0.05,12\n0.11,0.2,-3e-1,0.5,0.5,0.5,0.5,outer,0.05,12\n"
    "0.12,0.21,0.3,0,0,1,0,\"in \"\"b\"\"\",0.06,-1\n0.13,0.22,0.3,0.6,0,0,0.8,last,1e-3,2\n";
const char* const kPlainCsv = "x,y,z\r\n0,0,0\r\n0.5,-0.25,1e-3\r\n1,2,3\r\n";
const char* const kNestedYaml =
    "- dwell_time: 0\n  tool_offset:\n    position: {x: 0, y: 0, z: 0}\n"
    "    orientation: {x: 1, y: 0, z: 0, w: 6.1e-17}\n  paths:\n    - poses:\n"
    "        - orientation: {z: 0, w: 1, x: 0, y: 0}\n"
    "          position: {x: 0.5, y: -0.25, z: 0.125}\n        - position: {x: 1, y: 2, z: 3}\n"
    "          orientation: {x: 0, y: 0, z: 1, w: 0}\n      header: {seq: 4}\n"
    "    - header: {seq: 3}\n      poses: &last\n        - position: {x: 7, y: 8, z: 9}\n"
    "          orientation: {x: 0, y: 0, z: 0, w: 1}\n    - poses: *last\n";
const char* const kListYaml = "[[[1, 2, 3], [4, 5, 6]], [[7, 8, 9.5e-3]]]\n";
const char* const kNamedYaml =
    "name: \"rim\"\nprocess_names: [speed, \"force\"]\nsegments:\n  - name: outer\n    poses:\n"
    "      - {position: {x: 0.1, y: 0, z: 0}, process_values: [0.5, 12]}\n"
    "      - {position: {x: 0.2, y: 0, z: 0}, process_values: [0.6, 13]}\n"
    "  - name: 'inner'\n    poses:\n"
    "      - {position: {x: 0.1, y: 1, z: 0}, process_values: [0.5, -12]}\n";

const char* const kRobotCsv =
    "x_mm,y_mm,z_mm,a_deg,e_deg,r_deg,speed\n100,200.5,-300,10,20,30,5\n"
    "110,200.5,-300,-170,90,0,5\n120,200.5,-300,0,180,3.5,6\n";
const char* const kAnglesCsv =
    "segment,rx,ry,rz,x,y,z\na,0.1,0.2,0.3,1,2,3\na,-3,1.5,0,4,5,6\nb,0,0,0,7,8,9\n";
const char* const kVectorsCsv =
    "x,y,z,i,j,k\n0,0,0,0,0,1\n1,0,0,0.6,0,0.8\n2,0,0,-1,0,0\n3,0,0,1,0,0\n";
const char* const kAbbCsv = "q1,q2,q3,q4,x,y,z\n1,0,0,0,0,0,0\n0.6,0,0,0.8,1,2,3\n";
const char* const kEchoedYaml =
    "header: {seq: 1, frame_id: \"world\"}\nposes:\n  -\n    header: {seq: 5}\n    pose:\n"
    "      position: {x: 1.0, y: 2.0, z: 3.0}\n      orientation: {x: 0, y: 0, z: 0, w: 1}\n---\n"
    "header: {seq: 2}\nposes:\n  - pose:\n      position: {x: 4.0, y: 5.0, z: 6.0}\n"
    "      orientation: {x: 0, y: 0, z: 1, w: 0}\n    header: {seq: 6}\n---\n";
const char* const kFlatYaml =
    "- [{x: 1, y: 2, z: 3, qw: 1, qx: 0, qy: 0, qz: 0, speed: 5, note: 'slow'},\n"
    "   {x: 4, y: 5, z: 6, qw: 0, qx: 1, qy: 0, qz: 0, speed: 7, note: \"fast\"}]\n";
const char* const kRpyYaml =
    "- {position: [1, 2, 3], rpy: [0.1, 0.2, 0.3]}\n- {position: [4, 5, 6], rpy: [0, -1, 3]}\n";

const char* const kEdits =
    "edits:\n  - move: {waypoints: [1, 3], by: [0, 0, -2e-3]}\n"
    "  - turn: {waypoints: 0, about: [0, 0, 2], angle: 0.1, frame: path}\n"
    "  - delete: {waypoints: [2, 2]}\n  - add: {after: 1, share: 0.25}\n"
    "  - set: {waypoints: [0, 3], values: {speed: 0.02, \"air\": 1}}\n";

/// As CSV holds them.
std::vector<std::string> in_one_line(std::vector<std::string> names) {
  for (std::string& name : names) {
    std::replace(name.begin(), name.end(), '\r', ' ');
    std::replace(name.begin(), name.end(), '\n', ' ');
  }
  return names;
}

/// @param layout of the written file
void check_same(const ToolPath& path, const ToolPath& again, const PathLayout& layout) {
  const bool to_the_last_digit = layout.pose.units == "m";
  const bool axis_alone = layout.pose.orientation == OrientationKind::kToolVector;
  constexpr double kRounding = 1e-9;
  promise(in_one_line(again.process_names) == in_one_line(path.process_names), "names come back");
  promise(again.segments.size() == path.segments.size(), "as many segments come back");
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const auto& before = path.segments[s].waypoints;
    const auto& after = again.segments[s].waypoints;
    promise(before.size() == after.size(), "as many waypoints come back");
    for (std::size_t w = 0; w < before.size(); ++w) {
      const Eigen::Vector3d from = before[w].pose.translation();
      const Eigen::Vector3d to = after[w].pose.translation();
      promise(to_the_last_digit ? from == to
                                : (from - to).norm() <= kRounding * std::max(1.0, from.norm()),
              "positions come back");
      const Eigen::Matrix3d turn = before[w].pose.linear();
      const Eigen::Matrix3d turn_again = after[w].pose.linear();
      promise(axis_alone ? turn.col(2).isApprox(turn_again.col(2), 1e-9)
                         : turn.isApprox(turn_again, 1e-7),
              "turns come back");
      promise(before[w].process_values == after[w].process_values, "values come back");
    }
  }
}

/// A path that was read can be used and written, and reads back: in its own layout and in that of a
/// new file.
template <class Write, class Read>
void check_path(const std::string& bytes, Read read, Write write,
                const PathConventions& conventions) {
  const ToolPathFile file = read(bytes, "f", conventions);
  check(file.path);
  promise(!to_string(contents_of(file.path, file.layout)).empty(), "it says what is in it");
  constexpr std::size_t kAliases = 100000;  // a small text can expand to a long path
  if (waypoint_count(file.path) > kAliases) return;
  check_same(file.path, read(write(file.path, file.layout), "written", conventions).path,
             file.layout);
  check_same(file.path, read(write(file.path, PathLayout{}), "new", PathConventions{}).path,
             PathLayout{});
}

/// Edits that were read read back, and are applied to a path completely or refused.
void check_edits(const std::string& bytes) {
  const std::vector<PathEdit> edits = parse_path_edits(bytes, "f");
  const std::vector<PathEdit> back = parse_path_edits(to_yaml(edits), "written");
  promise(back.size() == edits.size(), "all edits come back");
  for (std::size_t i = 0; i < edits.size(); ++i)
    promise(to_string(back[i]) == to_string(edits[i]), "each edit comes back");
  const EditedPath result = edited(parse_tool_path_csv(kCsv, "path").path, edits);
  promise(result.origins.size() == waypoint_count(result.path), "each waypoint has an origin");
  check(marked(result));
}

PathConventions in_radians() {
  PathConventions conventions;
  conventions.euler = "zyx";
  conventions.angles = AngleUnit::kRadians;
  return conventions;
}

}  // namespace

std::vector<FuzzTarget> tool_path_file_targets() {
  const std::vector<std::string> csv_words = {
      "x",     "y",  "z",    "qx",   "qy", "qz", "qw", ",",    "\"", "#",   "segment",
      "speed", "\n", "\r\n", "\r",   ";",  "\t", " ",  "\"\"", "rx", "_mm", "a",
      "e",     "r",  "_deg", "_rad", "i",  "j",  "k",  "q1",   "q4", "X"};
  const std::vector<std::string> yaml_words = {"position",
                                               "orientation",
                                               "name",
                                               "process_names",
                                               "process_values",
                                               "poses",
                                               "- ",
                                               ": ",
                                               "[",
                                               "]",
                                               "{",
                                               "}",
                                               ", ",
                                               "&a ",
                                               "*a",
                                               "\n",
                                               "\r\n",
                                               "\t",
                                               "| ",
                                               "> ",
                                               "!!map ",
                                               "? ",
                                               "'",
                                               "\"",
                                               "<<: ",
                                               "---\n",
                                               "...\n",
                                               "%YAML 1.2\n",
                                               "x: 1",
                                               "rpy",
                                               "pose",
                                               "header",
                                               "qx",
                                               "rx",
                                               "~",
                                               "  ",
                                               "&last ",
                                               "*last",
                                               "\xe6"};
  return {
      {"csv",
       {kCsv, kPlainCsv, kRobotCsv, kVectorsCsv, kAbbCsv},
       csv_words,
       [](const std::string& bytes) {
         check_path(bytes, parse_tool_path_csv, tool_path_to_csv, PathConventions{});
       }},
      {"csv_angles",
       {kAnglesCsv},
       csv_words,
       [](const std::string& bytes) {
         check_path(bytes, parse_tool_path_csv, tool_path_to_csv, in_radians());
       }},
      {"yaml",
       {kNestedYaml, kListYaml, kNamedYaml, kEchoedYaml, kFlatYaml},
       yaml_words,
       [](const std::string& bytes) {
         check_path(bytes, parse_tool_path_yaml, tool_path_to_yaml, PathConventions{});
       }},
      {"yaml_angles",
       {kRpyYaml},
       yaml_words,
       [](const std::string& bytes) {
         check_path(bytes, parse_tool_path_yaml, tool_path_to_yaml, in_radians());
       }},
      {"edits",
       {kEdits},
       {"move",  "turn",  "delete", "add",  "set", "waypoints", "values", "frame: tool", "share",
        "after", "about", "angle",  "- ",   ": ",  "[",         "]",      "{",           "}",
        ", ",    "\n",    ".nan",   ".inf", "-1",  "1e309",     "&a ",    "*a"},
       check_edits}};
}
