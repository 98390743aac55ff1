// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "laser_triangulation/scanner_model.h"
#include "scan_cell_common/errors.h"

namespace laser_triangulation {
namespace {

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

/// One entry of the file; errors name it by its whole way, such as camera.fx.
class Entry {
 public:
  Entry(const YAML::Node& node, const std::string& name) : node_(node), name_(name) {}

  Entry operator[](const std::string& key) const {
    const std::string name = name_.empty() ? key : name_ + "." + key;
    if (!node_.IsMap() || !node_[key]) {
      throw UnusableInput("scanner model: " + name, "missing", "see docs/scanner_model.md");
    }
    return {node_[key], name};
  }

  template <class T>
  T as() const {
    try {
      return node_.as<T>();
    } catch (const YAML::Exception&) {
      throw UnusableInput("scanner model: " + name_, "of the wrong type",
                          "see docs/scanner_model.md");
    }
  }

  template <int N>
  Eigen::Matrix<double, N, 1> vector() const {
    const auto values = as<std::vector<double>>();
    if (values.size() != N) {
      throw UnusableInput("scanner model: " + name_, std::to_string(values.size()) + " numbers",
                          "give " + std::to_string(N));
    }
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(values.data());
  }

  std::vector<Entry> elements() const {
    std::vector<Entry> result;
    for (std::size_t i = 0; i < node_.size(); ++i) {
      result.emplace_back(node_[i], name_ + "[" + std::to_string(i) + "]");
    }
    return result;
  }

 private:
  YAML::Node node_;
  std::string name_;
};

Eigen::Isometry3d read_pose(const Entry& entry) {
  const Eigen::Vector4d xyzw = entry["rotation"].vector<4>();
  constexpr double kUnit = 1e-3;
  if (!(std::abs(xyzw.norm() - 1) < kUnit)) {
    throw UnusableInput("scanner model: flange_to_camera.rotation",
                        "length " + std::to_string(xyzw.norm()), "give a unit quaternion x y z w");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = entry["translation"].vector<3>();
  pose.linear() = Eigen::Quaterniond(xyzw).normalized().toRotationMatrix();
  return pose;
}

ScannerModel read_model(const Entry& root) {
  ScannerModel model;
  const Entry camera = root["camera"];
  model.camera.width = camera["width"].as<int>();
  model.camera.height = camera["height"].as<int>();
  model.camera.fx = camera["fx"].as<double>();
  model.camera.fy = camera["fy"].as<double>();
  model.camera.cx = camera["cx"].as<double>();
  model.camera.cy = camera["cy"].as<double>();
  model.camera.distortion = camera["distortion"].vector<5>();
  model.flange_to_camera = read_pose(root["flange_to_camera"]);
  for (const Entry& entry : root["lasers"].elements()) {
    LaserPlane laser;
    laser.normal = entry["normal"].vector<3>();
    laser.distance = entry["distance"].as<double>();
    laser.origin = entry["origin"].vector<3>();
    model.lasers.push_back(laser);
  }
  return model;
}

template <class Vector>
void write(YAML::Emitter& out, const char* key, const Vector& vector) {
  out << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    out << vector[i];
  out << YAML::EndSeq;
}

std::string to_yaml(const ScannerModel& model) {
  const CameraIntrinsics& camera = model.camera;
  YAML::Emitter out;
  out.SetDoublePrecision(std::numeric_limits<double>::max_digits10);
  out << YAML::BeginMap << YAML::Key << "camera" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "width" << YAML::Value << camera.width;
  out << YAML::Key << "height" << YAML::Value << camera.height;
  out << YAML::Key << "fx" << YAML::Value << camera.fx << YAML::Key << "fy" << YAML::Value
      << camera.fy;
  out << YAML::Key << "cx" << YAML::Value << camera.cx << YAML::Key << "cy" << YAML::Value
      << camera.cy;
  write(out, "distortion", camera.distortion);
  out << YAML::EndMap << YAML::Key << "flange_to_camera" << YAML::Value << YAML::BeginMap;
  write(out, "translation", Eigen::Vector3d(model.flange_to_camera.translation()));
  write(out, "rotation", Eigen::Quaterniond(model.flange_to_camera.linear()).coeffs());
  out << YAML::EndMap << YAML::Key << "lasers" << YAML::Value << YAML::BeginSeq;
  for (const LaserPlane& laser : model.lasers) {
    out << YAML::BeginMap;
    write(out, "normal", laser.normal);
    out << YAML::Key << "distance" << YAML::Value << laser.distance;
    write(out, "origin", laser.origin);
    out << YAML::EndMap;
  }
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace

ScannerModel load_scanner_model(const std::string& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::BadFile&) {
    throw FileError(path, "cannot be read", "check the path of the scanner model");
  } catch (const YAML::Exception& error) {
    throw FileError(path, error.what(), "correct the YAML");
  }
  ScannerModel model = read_model(Entry(root, ""));
  check(model);
  return model;
}

void save_scanner_model(const std::string& path, const ScannerModel& model) {
  check(model);
  const std::string partial = path + ".partial";
  std::ofstream file(partial);
  file << to_yaml(model);
  file.close();
  std::error_code failure;
  if (file) std::filesystem::rename(partial, path, failure);
  if (!file || failure) {
    throw FileError(path, "cannot be written", "check the folder and its permissions");
  }
}

}  // namespace laser_triangulation
