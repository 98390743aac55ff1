// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yardsticks/registration_data.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "parts/scan.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "tool_path_stretcher/surface.h"

namespace cases {
namespace {

namespace fs = std::filesystem;

Points points_of_csv(const fs::path& file) {
  std::ifstream lines(file);
  if (!lines) throw std::runtime_error(file.string() + ": cannot be read");
  Points points;
  std::string line;
  std::getline(lines, line);  // x,y,z,nx,ny,nz
  while (std::getline(lines, line)) {
    Eigen::Vector3d point;
    if (std::sscanf(line.c_str(), "%lf , %lf , %lf", &point.x(), &point.y(), &point.z()) != 3) {
      throw std::runtime_error(file.string() + ": '" + line + "' is no point");
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

bool has_registration_data(const std::string& data) {
  const fs::path folder = fs::path(data) / "registration";
  return !data.empty() && fs::exists(folder / "car") && fs::exists(folder / "bunny");
}

Pair car_pair(const std::string& data) {
  const fs::path folder = fs::path(data) / "registration" / "car";
  Pair pair{points_of_csv(folder / "car_cloud400.csv"),
            points_of_csv(folder / "car_cloud400_scaled.csv"),
            {}};
  if (pair.reference.size() != pair.object.size()) throw std::runtime_error("the car's two differ");
  pair.truth = tool_path_stretcher::fit_similarity(pair.reference, pair.object);
  return pair;
}

Pair bunny_pair(const std::string& data, std::size_t draws) {
  constexpr double kNoise = 0.0005;
  const fs::path file = fs::path(data) / "registration" / "bunny" / "bun_zipper_res3.ply";
  Pair pair;
  pair.reference = tool_path_stretcher::to_points(scan_cell_common::load_cloud(file.string()));
  pair.truth = {1, random_rotation(77), {-0.116, -0.039, 0.115}};
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> noise(-kNoise, kNoise);
  for (const Eigen::Vector3d& point : pair.reference) {
    const double x = noise(engine), y = noise(engine);
    pair.object.push_back(pair.truth * point + Eigen::Vector3d(x, y, noise(engine)));
  }
  std::uniform_int_distribution<std::size_t> which(0, pair.object.size() - 1);
  std::uniform_int_distribution<int> offset(5, 10);
  for (std::size_t i = 0; i < draws; ++i) {
    Eigen::Vector3d& point = pair.object[which(engine)];
    point += Eigen::Vector3d::Constant(offset(engine));
  }
  return pair;
}

double angle_of(const Eigen::Matrix3d& rotation) {
  return Eigen::AngleAxisd(rotation).angle();
}

}  // namespace cases
