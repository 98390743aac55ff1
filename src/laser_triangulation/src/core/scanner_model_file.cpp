// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/scanner_model.h"
#include "scan_cell_common/yaml_file.h"

namespace laser_triangulation {
namespace {

using scan_cell_common::YamlEntry;

CameraIntrinsics read_camera(const YamlEntry& entry) {
  entry.refuse_unknown({"width", "height", "fx", "fy", "cx", "cy", "distortion"});
  CameraIntrinsics camera;
  camera.width = entry["width"].as<int>();
  camera.height = entry["height"].as<int>();
  camera.fx = entry["fx"].as<double>();
  camera.fy = entry["fy"].as<double>();
  camera.cx = entry["cx"].as<double>();
  camera.cy = entry["cy"].as<double>();
  camera.distortion = entry["distortion"].vector<5>();
  return camera;
}

LaserPlane read_laser(const YamlEntry& entry) {
  entry.refuse_unknown({"normal", "distance", "origin"});
  LaserPlane laser;
  laser.normal = entry["normal"].vector<3>();
  laser.distance = entry["distance"].as<double>();
  laser.origin = entry["origin"].vector<3>();
  return laser;
}

template <class Vector>
YAML::Node numbers(const Vector& vector) {
  YAML::Node node;
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    node.push_back(vector[i]);
  node.SetStyle(YAML::EmitterStyle::Flow);
  return node;
}

YAML::Node to_yaml(const ScannerModel& model) {
  YAML::Node root;
  YAML::Node camera = root["camera"];
  camera["width"] = model.camera.width;
  camera["height"] = model.camera.height;
  camera["fx"] = model.camera.fx;
  camera["fy"] = model.camera.fy;
  camera["cx"] = model.camera.cx;
  camera["cy"] = model.camera.cy;
  camera["distortion"] = numbers(model.camera.distortion);
  root["flange_to_camera"] = scan_cell_common::yaml_pose(model.flange_to_camera);
  for (const LaserPlane& laser : model.lasers) {
    YAML::Node entry;
    entry["normal"] = numbers(laser.normal);
    entry["distance"] = laser.distance;
    entry["origin"] = numbers(laser.origin);
    root["lasers"].push_back(entry);
  }
  return root;
}

ScannerModel read_model(const YamlEntry& root) {
  root.refuse_unknown({"camera", "flange_to_camera", "lasers"});
  ScannerModel model;
  model.camera = read_camera(root["camera"]);
  model.flange_to_camera = root["flange_to_camera"].pose();
  for (const YamlEntry& entry : root["lasers"].elements())
    model.lasers.push_back(read_laser(entry));
  check(model);
  return model;
}

}  // namespace

ScannerModel load_scanner_model(const std::string& path) {
  return read_model(YamlEntry::load(path));
}

ScannerModel parse_scanner_model(const std::string& text, const std::string& name) {
  return read_model(YamlEntry::parse(text, name));
}

void save_scanner_model(const std::string& path, const ScannerModel& model) {
  check(model);
  YAML::Emitter out;
  out << to_yaml(model);
  scan_cell_common::save_text(path, std::string(out.c_str()) + "\n");
}

}  // namespace laser_triangulation
