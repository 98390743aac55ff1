// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "made_up_part.h"

#include <fmt/format.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

constexpr double kSpacing = 0.001;  // [m]
constexpr double kLong = 0.12, kWide = 0.08;

/// Height [m] of the part over a place: a step, a cone and a ridge.
double height(double x, double y) {
  const double step = x > 0.075 ? 0.012 : 0;
  const double cone = std::fmax(0, 0.010 - 0.8 * std::hypot(x - 0.03, y - 0.055));
  const double ridge = y < 0.02 && x < 0.06 ? 0.006 * std::sin(M_PI * x / 0.06) : 0;
  return step + cone + ridge;
}

}  // namespace

void MadeUpPart::write_cloud(const std::filesystem::path& file, const Eigen::Isometry3d& moved,
                             double added) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const auto add = [&](double x, double y, double z) {
    const Eigen::Vector3d point = moved * Eigen::Vector3d(x, y, z + (x < kLong / 3 ? added : 0));
    cloud.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                       static_cast<float>(point.z()));
  };
  for (double x = 0; x <= kLong; x += kSpacing) {
    for (double y = 0; y <= kWide; y += kSpacing)
      add(x, y, height(x, y));
  }
  for (double y = 0; y <= kWide; y += kSpacing) {
    for (double z = kSpacing; z < 0.012; z += kSpacing)
      add(0.0755, y, z);  // the step's flank
  }
  scan_cell_common::save_cloud(file.string(), cloud);
}

void MadeUpPart::write_path(const std::filesystem::path& file) {
  std::string text = "x,y,z,qx,qy,qz,qw\n";
  for (double y = 0.01; y < 0.071; y += 0.002)
    text += fmt::format("{},{},{},1,0,0,0\n", 0.09, y, height(0.09, y));
  scan_cell_common::save_text(file.string(), text);
}

Eigen::Isometry3d MadeUpPart::moved() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()));
  pose.pretranslate(Eigen::Vector3d(0.04, -0.025, 0));
  return pose;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace part_recipes
