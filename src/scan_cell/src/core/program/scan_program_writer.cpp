// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include "program/pass_words.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell {
namespace {

YAML::Node way_of(const ScanPass& pass) {
  YAML::Node way;
  if (pass.kind == PassKind::kPolyline) {
    for (const Eigen::Isometry3d& pose : pass.poses)
      way.push_back(scan_cell_common::yaml_pose(pose));
    return way;
  }
  way["start"] = scan_cell_common::yaml_pose(pass.poses.front());
  if (pass.kind == PassKind::kArc) way["via"] = scan_cell_common::yaml_pose(pass.poses[1]);
  way["end"] = scan_cell_common::yaml_pose(pass.poses.back());
  return way;
}

YAML::Node camera_of(const PassCamera& camera) {
  YAML::Node entry;
  if (camera.exposure) entry["exposure"] = *camera.exposure;
  if (camera.region) {
    entry["region"]["x"] = camera.region->x;
    entry["region"]["y"] = camera.region->y;
    entry["region"]["width"] = camera.region->width;
    entry["region"]["height"] = camera.region->height;
  }
  if (!camera.detector.empty()) entry["detector"] = camera.detector;
  return entry;
}

}  // namespace

void save_scan_program(const std::string& path, const ScanProgram& program) {
  YAML::Node root;
  root["frame"] = program.frame;
  for (const ScanPass& pass : program.passes) {
    YAML::Node entry;
    if (!pass.name.empty()) entry["name"] = pass.name;
    entry[word_of(pass.kind)] = way_of(pass);
    entry["speed"] = pass.speed;
    entry["rate"] = pass.rate;
    entry["laser"] = word_of(pass.lasers);
    if (!pass.camera.empty()) entry["camera"] = camera_of(pass.camera);
    root["passes"].push_back(entry);
  }
  YAML::Emitter text;
  text.SetDoublePrecision(17);
  text << root;
  scan_cell_common::save_text(path, std::string(text.c_str()) + "\n");
}

}  // namespace scan_cell
