// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_file_targets.h"

#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace {

using namespace tool_path_stretcher;
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

/// What was read can be used, and written, and comes back.
template <class Write, class Read>
void check_path(const std::string& bytes, Read read, Write write) {
  const ToolPath path = read(bytes, "f");
  check(path);
  constexpr std::size_t kAliases = 100000;  // a small text can stand for a long path
  if (waypoint_count(path) > kAliases) return;
  const ToolPath again = read(write(path), "written");
  promise(again.process_names.size() == path.process_names.size(), "as many names come back");
  promise(again.segments.size() == path.segments.size(), "as many segments come back");
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const auto& before = path.segments[s].waypoints;
    const auto& after = again.segments[s].waypoints;
    promise(before.size() == after.size(), "as many waypoints come back");
    for (std::size_t w = 0; w < before.size(); ++w) {
      promise(before[w].pose.translation() == after[w].pose.translation(), "positions come back");
      promise(before[w].pose.linear().isApprox(after[w].pose.linear(), 1e-9), "turns come back");
      promise(before[w].process_values == after[w].process_values, "values come back");
    }
  }
}

void check_surface(const Surface& surface) {
  promise(!surface.points.empty() && surface.points.size() == surface.normals.size(),
          "a normal for each point");
  promise(std::isfinite(surface.spacing) && surface.size > 0, "a size");
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    promise(surface.points[i].allFinite(), "finite points");
    promise(std::abs(surface.normals[i].norm() - 1) < 1e-6, "unit normals");
  }
}

std::string ascii_cloud() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 60\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  for (int i = 0; i < 60; ++i) {
    const double x = 0.01 * (i % 10);
    const double y = 0.01 * (i / 10);
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(x * y) + "\n";
  }
  return text;
}

const char* const kMesh =
    "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0.1 0.1 0.01\nv 0.05 0.05 0.05\nf 1 2 3\nf 2 4 3\nf 1 2 5\n"
    "f 3 4 5 1\n";

}  // namespace

std::vector<FuzzTarget> tool_path_file_targets() {
  const std::vector<std::string> csv_words = {"x",  "y",  "z",  "qx",      "qy",    "qz", "qw",
                                              ",",  "\"", "#",  "segment", "speed", "\n", "\r\n",
                                              "\r", ";",  "\t", " ",       "\"\""};
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
                                               "~",
                                               "  ",
                                               "&last ",
                                               "*last"};
  const std::vector<std::string> number_words = {"\n",   " ",     "0.05", "0.050000 0.050000",
                                                 "1e20", "1e-20", "3e38", "0.01"};
  const Eigen::Vector3d leaf(0.002, 0.002, 0.0005);
  return {
      {"csv",
       {kCsv, kPlainCsv},
       csv_words,
       [](const std::string& bytes) { check_path(bytes, parse_tool_path_csv, tool_path_to_csv); }},
      {"yaml",
       {kNestedYaml, kListYaml, kNamedYaml},
       yaml_words,
       [](const std::string& bytes) {
         check_path(bytes, parse_tool_path_yaml, tool_path_to_yaml);
       }},
      {"cloud_surface",
       {ascii_cloud()},
       number_words,
       [leaf](const std::string& bytes) {
         check_surface(
             surface_from_cloud(to_points(scan_cell_common::parse_ply(bytes, "f")), leaf, "f"));
       }},
      {"mesh_surface",
       {kMesh},
       number_words,
       [leaf](const std::string& bytes) {
         check_surface(surface_from_mesh(scan_cell_common::parse_obj(bytes, "f"), leaf, "f"));
       },
       1000}};  // 20,000 samples each
}
