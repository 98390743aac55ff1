// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_program.h"

#include <algorithm>
#include <set>

#include "program/pass_words.h"
#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell {
namespace {

using scan_cell_common::YamlEntry;

PassLasers read_lasers(const YamlEntry& entry) {
  const auto word = entry.as<std::string>();
  const auto found = std::find(kLaserWords.begin(), kLaserWords.end(), word);
  if (found == kLaserWords.end()) entry.refuse(word, "give 0, 1, each or alternate");
  return static_cast<PassLasers>(found - kLaserWords.begin());
}

void read_motion(const YamlEntry& entry, ScanPass& pass) {
  pass.speed = entry["speed"].as<double>();
  pass.rate = entry["rate"].as<double>();
  pass.lasers = read_lasers(entry["laser"]);
}

void read_way(const YamlEntry& entry, PassKind kind, ScanPass& pass) {
  pass.kind = kind;
  if (kind == PassKind::kPolyline) {
    for (const YamlEntry& pose : entry.elements())
      pass.poses.push_back(pose.pose());
    return;
  }
  std::vector<std::string> keys = {"start", "end"};
  if (kind == PassKind::kArc) keys.insert(keys.begin() + 1, "via");
  entry.refuse_unknown({keys.begin(), keys.end()});
  for (const std::string& key : keys)
    pass.poses.push_back(entry[key].pose());
}

PassCamera read_camera(const YamlEntry& entry) {
  entry.refuse_unknown({"exposure", "region", "detector"});
  PassCamera camera;
  if (entry.has("detector")) camera.detector = entry["detector"].as<std::string>();
  if (entry.has("exposure")) camera.exposure = entry["exposure"].as<double>();
  if (!entry.has("region")) return camera;
  const YamlEntry region = entry["region"];
  region.refuse_unknown({"x", "y", "width", "height"});
  const auto pixels = [&region](const char* key) { return region[key].as<std::uint32_t>(); };
  camera.region = CameraRegion{pixels("x"), pixels("y"), pixels("width"), pixels("height")};
  return camera;
}

ScanPass read_pass(const YamlEntry& entry) {
  if (entry.has("frame")) {
    entry["frame"].refuse("a pass cannot have its own frame",
                          "give all poses in the program's frame, or make two programs");
  }
  entry.refuse_unknown({"name", "line", "arc", "poses", "speed", "rate", "laser", "camera"});
  ScanPass pass;
  for (const PassKind kind : {PassKind::kLine, PassKind::kArc, PassKind::kPolyline}) {
    if (!entry.has(word_of(kind))) continue;
    if (!pass.poses.empty()) entry.refuse("more than one of line, arc and poses", "give one");
    read_way(entry[word_of(kind)], kind, pass);
  }
  if (pass.poses.empty()) entry.refuse("none of line, arc and poses", "give one");
  if (entry.has("name")) pass.name = entry["name"].as<std::string>();
  if (entry.has("camera")) pass.camera = read_camera(entry["camera"]);
  read_motion(entry, pass);
  return pass;
}

/// Reads the form of programs before there were passes.
ScanPass read_one_line(const YamlEntry& root) {
  root.refuse_unknown({"frame", "start", "end", "speed", "rate", "laser"});
  ScanPass pass;
  pass.poses = {root["start"].pose(), root["end"].pose()};
  read_motion(root, pass);
  return pass;
}

}  // namespace

ScanProgram load_scan_program(const std::string& path) {
  const YamlEntry root = YamlEntry::load(path);
  ScanProgram program;
  if (root.has("passes")) {
    root.refuse_unknown({"frame", "passes"});
    for (const YamlEntry& entry : root["passes"].elements())
      program.passes.push_back(read_pass(entry));
    if (program.passes.empty()) root["passes"].refuse("empty", "give at least one pass");
  } else {
    program.passes.push_back(read_one_line(root));
  }
  program.frame = root["frame"].as<std::string>();
  return program;
}

}  // namespace scan_cell
