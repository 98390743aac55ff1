// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/temporary_folder.h"
#include "scanner_views/methods/methods.h"

namespace scanner_views {
namespace {

constexpr int kMissing = 3;  // exit code of the script

void save(const std::string& file, const Points& points) {
  scan_cell_common::Cloud cloud;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3f at = point.cast<float>();
    cloud.push_back({at.x(), at.y(), at.z()});
  }
  scan_cell_common::save_cloud(file, cloud);
}

/// Runs a command and collects its output.
/// @return its exit code
int output_of(const std::string& command, std::string& text) {
  FILE* const output = popen(command.c_str(), "r");
  if (output == nullptr) throw std::runtime_error(command + " did not start");
  std::array<char, 512> some{};
  while (std::fgets(some.data(), some.size(), output) != nullptr)
    text += some.data();
  const int status = pclose(output);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Moves each waypoint by the transform and rotates it.
void carry_over(const Eigen::Matrix4d& transform, ToolPath& path) {
  const Eigen::Matrix3d scaled = transform.topLeftCorner<3, 3>();
  const Eigen::Matrix3d rotation = tool_path_stretcher::nearest_rotation(scaled);
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) {
      waypoint.pose.translation() =
          scaled * waypoint.pose.translation() + transform.topRightCorner<3, 1>();
      waypoint.pose.linear() = rotation * waypoint.pose.linear();
    }
  }
}

}  // namespace

Answer run_open3d(const View& view) {
  static bool installed = true;  // checked once
  Answer answer;
  answer.verdict = kNotInstalled;
  if (!installed) return answer;
  const Reduced clouds = reduced(view);
  const scan_cell_common::TemporaryFolder folder("scanner_views");
  save(folder.file("reference.ply"), clouds.reference);
  save(folder.file("object.ply"), clouds.object);
  std::string text;
  const int code =
      output_of("/usr/bin/env python3 '" OPEN3D_SCRIPT "' '" + folder.file("reference.ply") +
                    "' '" + folder.file("object.ply") + "'",
                text);
  installed = code != kMissing;
  if (!installed) return answer;
  if (code != 0) throw std::runtime_error("open3d_registration.py failed: " + text);
  std::istringstream numbers(text);
  Eigen::Matrix4d transform;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      numbers >> transform(row, column);
  }
  double fitness = 0;
  numbers >> fitness >> answer.seconds;
  if (!numbers) throw std::runtime_error("open3d_registration.py said: " + text);
  answer.accepted = fitness > 0;
  answer.verdict = answer.accepted ? "fits" : "not";
  answer.path = view.path;
  carry_over(transform, answer.path);
  return answer;
}

}  // namespace scanner_views
