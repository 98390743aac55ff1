// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scene.h"

namespace cloud_preprocess {

/// A raw scan: a leaning floor, a frame (the part), a box, outliers.
inline Scene raw_scan() {
  Scene scene;
  scene.add_floor({0, 0, 0.30, 0.25}, {kFrame, kBox});
  scene.add_frame(kFrame);
  scene.add_box(kBox, 0.03, Label::kOtherPart);
  scene.add_outliers({0, 0, 0.30, 0.25}, 0.3, 200);
  scene.add(30, 20, 10, Label::kOutlier);
  scene.move(Eigen::Affine3f(Eigen::AngleAxisf(0.017F, Eigen::Vector3f::UnitX())));
  return scene;
}

/// The command with a raw scan in a temporary folder.
class CleanCloudTool : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    scan_cell_common::save_cloud(path("scan.ply"), raw_scan().cloud());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the command and returns its exit code; its output goes to out.txt.
  int run(const std::string& arguments) const {
    const std::string command =
        std::string(CLEAN_CLOUD) + " " + arguments + " > " + path("out.txt") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  std::string printed() const {
    std::ifstream file(path("out.txt"));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("clean_cloud_" + std::to_string(getpid()));
};

}  // namespace cloud_preprocess
