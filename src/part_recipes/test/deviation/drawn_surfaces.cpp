// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_surfaces.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_stretcher/surface.h"

namespace drawn {
namespace {

using Eigen::Vector3d;

void facet(std::ofstream& file, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  file << "facet normal 0 0 0\nouter loop\n";
  for (const Vector3d& corner : {a, b, c})
    file << "vertex " << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
  file << "endloop\nendfacet\n";
}

}  // namespace

Points plane(double step) {
  Points points;
  for (double x = -0.05; x <= 0.05 + 1e-9; x += step) {
    for (double y = -0.03; y <= 0.03 + 1e-9; y += step)
      points.emplace_back(x, y, 0);
  }
  return points;
}

Points cap(double radius, std::size_t count) {
  const double kGolden = M_PI * (3 - std::sqrt(5.0));
  const double lowest = std::cos(50 * M_PI / 180);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (1 - lowest) * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double turn = kGolden * static_cast<double>(i), width = std::sqrt(1 - z * z);
    points.emplace_back(radius * width * std::cos(turn), radius * width * std::sin(turn),
                        radius * z);
  }
  return points;
}

void save_sphere(const std::string& file, double radius, bool inside_out) {
  constexpr int kRings = 180;
  std::ofstream stl(file);
  stl.precision(9);
  stl << "solid sphere\n";
  const auto at = [radius](int ring, int step) {
    const double down = M_PI * ring / kRings, about = M_PI * (step % (2 * kRings)) / kRings;
    const double width = ring == 0 || ring == kRings ? 0 : std::sin(down);
    return Vector3d(radius * width * std::cos(about), radius * width * std::sin(about),
                    radius * std::cos(down));
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int step = 0; step < 2 * kRings; ++step) {
      const Vector3d a = at(ring, step), b = at(ring + 1, step), c = at(ring + 1, step + 1),
                     d = at(ring, step + 1);
      if (ring + 1 < kRings) inside_out ? facet(stl, a, c, b) : facet(stl, a, b, c);
      if (ring > 0) inside_out ? facet(stl, a, d, c) : facet(stl, a, c, d);
    }
  }
  stl << "endsolid\n";
}

void save_cube(const std::string& file, double side) {
  std::ofstream stl(file);
  stl << "solid cube\n";
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d out = sign * side / 2 * Vector3d::Unit(axis);
      const Vector3d along = side / 2 * Vector3d::Unit((axis + 1) % 3);
      const Vector3d across = sign * side / 2 * Vector3d::Unit((axis + 2) % 3);
      facet(stl, out - along - across, out + along - across, out + along + across);
      facet(stl, out - along - across, out + along + across, out - along + across);
    }
  }
  stl << "endsolid\n";
}

void save_sheet(const std::string& file, double side, int cells, bool downwards) {
  std::ofstream stl(file);
  stl.precision(9);
  stl << "solid sheet\n";
  const auto at = [&](int i, int j) {
    return Vector3d(side * i / cells - side / 2, side * j / cells - side / 2, 0);
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const Vector3d a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      facet(stl, a, downwards ? c : b, downwards ? b : c);
      facet(stl, a, downwards ? d : c, downwards ? c : d);
    }
  }
  stl << "endsolid\n";
}

tool_path_stretcher::Similarity moved() {
  tool_path_stretcher::Similarity similarity;
  similarity.scale = 1.08;
  similarity.rotation =
      Eigen::AngleAxisd(2.1, Vector3d(0.3, -0.7, 0.5).normalized()).toRotationMatrix();
  similarity.translation = {0.4, -0.2, 0.7};
  return similarity;
}

void save_report(const std::string& file, const tool_path_stretcher::Similarity& similarity,
                 bool known) {
  nlohmann::json transform;
  const Eigen::Matrix4d matrix = similarity.matrix();
  for (int r = 0; known && r < 4; ++r)
    transform.push_back({matrix(r, 0), matrix(r, 1), matrix(r, 2), matrix(r, 3)});
  const nlohmann::json none;
  const nlohmann::json report = {
      {"verdict", known ? "accepted" : "refused"},
      {"reason", known ? "accepted" : "too_few_points"},
      {"message", "what the stretcher says"},
      {"waypoints_concerned", nlohmann::json::array()},
      {"candidates", nlohmann::json::array()},
      {"transform", transform},
      {"files", {{"reference", none}, {"object", none}, {"path", none}, {"output", none}}},
      {"reference_points", none},
      {"object_points", none},
      {"path", none},
      {"quality", nlohmann::json::array()}};
  std::ofstream(file) << report;
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "deviation_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) std::abort();
  path_ = name;
}

Folder::~Folder() {
  std::filesystem::remove_all(path_);
}

std::string Folder::save(const std::string& name, const Points& points) const {
  scan_cell_common::save_cloud(*this / name, tool_path_stretcher::to_cloud(points));
  return *this / name;
}

std::string Folder::save(const std::string& name, const std::string& text) const {
  scan_cell_common::save_text(*this / name, text);
  return *this / name;
}

}  // namespace drawn
