// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/scanner/point_deviations.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell_common {
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

std::optional<LaserPlane> read_laser(const YamlEntry& entry) {
  if (entry.is_null()) return std::nullopt;
  entry.refuse_unknown({"normal", "distance", "origin"});
  LaserPlane laser;
  laser.normal = entry["normal"].vector<3>();
  laser.distance = entry["distance"].as<double>();
  laser.origin = entry["origin"].vector<3>();
  return laser;
}

YAML::Node laser_entry(const std::optional<LaserPlane>& laser) {
  YAML::Node entry;
  if (!laser) return entry;  // ~
  entry["normal"] = yaml_list(laser->normal);
  entry["distance"] = laser->distance;
  entry["origin"] = yaml_list(laser->origin);
  return entry;
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
  camera["distortion"] = yaml_list(model.camera.distortion);
  root["flange_to_camera"] = scan_cell_common::yaml_pose(model.flange_to_camera);
  root["lasers"] = YAML::Node(YAML::NodeType::Sequence);
  for (const std::optional<LaserPlane>& laser : model.lasers)
    root["lasers"].push_back(laser_entry(laser));
  return root;
}

const char* const kUncertainty = "uncertainty";

std::vector<double> read_deviations(const YamlEntry& root) {
  if (!root.has(kUncertainty)) return {};
  const YamlEntry entry = root[kUncertainty];
  entry.refuse_unknown({"points"});
  std::vector<double> deviations;
  for (const YamlEntry& each : entry["points"].elements()) {
    deviations.push_back(each.as<double>());
    if (!(deviations.back() >= 0 && deviations.back() <= kMaxPointDeviation)) {
      each.refuse(fmt::format("{:g} m", deviations.back()),
                  fmt::format("give 0 (not known) to {:g} m", kMaxPointDeviation));
    }
  }
  return deviations;
}

/// @throw UnusableInput if the reader would refuse a deviation; then nothing is written
void save(const std::string& path, const YAML::Node& root) {
  YAML::Emitter out;
  if (root[kUncertainty])
    out << YAML::Comment(
               "uncertainty: [m] of a scanned point in tool0, by laser, due to camera, its pose on "
               "the flange and laser plane; 0: not known")
        << YAML::Newline;
  out << root;
  const std::string text = std::string(out.c_str()) + "\n";
  read_deviations(YamlEntry::parse(text, path));
  scan_cell_common::save_text(path, text);
}

ScannerModel read_model(const YamlEntry& root) {
  root.refuse_unknown({"camera", "flange_to_camera", "lasers", kUncertainty});
  read_deviations(root);
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

std::vector<double> load_point_deviations(const std::string& path) {
  return read_deviations(YamlEntry::load(path));
}

std::vector<double> parse_point_deviations(const std::string& text, const std::string& name) {
  return read_deviations(YamlEntry::parse(text, name));
}

void save_scanner_model(const std::string& path, const ScannerModel& model) {
  save_scanner_model(path, model, "", {});
}

void save_scanner_model(const std::string& path, const ScannerModel& model,
                        const std::string& existing) {
  save_scanner_model(path, model, existing, {});
}

void save_scanner_model(const std::string& path, const ScannerModel& model,
                        const std::string& existing, const std::vector<double>& deviations) {
  check(model);
  YAML::Node root = to_yaml(model);
  if (!existing.empty()) {
    const char* const name = "existing scanner model";
    const ScannerModel other = parse_scanner_model(existing, name);
    // Numbers are restored exactly from text; a quaternion is not restored exactly from a matrix.
    if (model.flange_to_camera.matrix() == other.flange_to_camera.matrix())
      root["flange_to_camera"] = scan_cell_common::parse_yaml(existing, name)["flange_to_camera"];
  }
  if (!deviations.empty()) {
    root[kUncertainty]["points"] = yaml_list(Eigen::Map<const Eigen::VectorXd>(
        deviations.data(), static_cast<Eigen::Index>(deviations.size())));
  }
  save(path, root);
}

}  // namespace scan_cell_common
