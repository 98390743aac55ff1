// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <regex>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/scanner/point_deviations.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace fs = std::filesystem;
using scan_cell_common::ScannerModel;

namespace {

ScannerModel example() {
  ScannerModel model;
  model.camera.width = 1696;
  model.camera.height = 1710;
  model.camera.fx = 801.5;
  model.camera.fy = 800.25;
  model.camera.cx = 851;
  model.camera.cy = 853;
  model.camera.distortion << -0.08, 0.05, 5e-4, -3e-4, 0.01;
  model.flange_to_camera = Eigen::Translation3d(0.01, -0.02, 0.08) *
                           Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 2, 3).normalized());
  scan_cell_common::LaserPlane laser;
  laser.normal = Eigen::Vector3d(2, 0, -1).normalized();
  laser.origin << -0.25, 0, 0;
  laser.distance = laser.normal.dot(laser.origin);
  model.lasers.push_back(laser);
  return model;
}

class ScannerModelFile : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  /// The error of loading after the text that matches `pattern` was replaced.
  std::string complaint(const std::string& pattern, const std::string& replacement) {
    scan_cell_common::save_scanner_model(path_, example());
    std::ifstream in(path_);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    const std::string changed = std::regex_replace(text, std::regex(pattern), replacement);
    EXPECT_NE(text, changed);
    std::ofstream(path_) << changed;
    try {
      scan_cell_common::load_scanner_model(path_);
    } catch (const scan_cell_common::Error& error) {
      return error.what();
    }
    return "";
  }

  std::string path_ =
      (fs::temp_directory_path() / ("scanner_" + std::to_string(getpid()) + ".yaml")).string();
};

}  // namespace

TEST(CameraIntrinsics, ProjectLikeOpenCv) {
  const scan_cell_common::CameraIntrinsics camera = example().camera;
  const std::vector<cv::Point3d> points = {{0, 0, 0.5}, {0.2, -0.1, 0.4}, {-0.15, 0.25, 0.61}};
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrix, distortion, pixels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d pixel = camera.project({points[i].x, points[i].y, points[i].z});
    EXPECT_NEAR(pixel.x(), pixels[i].x, 1e-9);
    EXPECT_NEAR(pixel.y(), pixels[i].y, 1e-9);
  }
}

TEST_F(ScannerModelFile, ComesBackToTheLastDigit) {
  scan_cell_common::save_scanner_model(path_, example());
  const ScannerModel loaded = scan_cell_common::load_scanner_model(path_);
  EXPECT_EQ(loaded.camera.distortion, example().camera.distortion);
  EXPECT_EQ(loaded.camera.fx, example().camera.fx);
  EXPECT_TRUE(loaded.flange_to_camera.isApprox(example().flange_to_camera, 1e-15));
  EXPECT_EQ(loaded.laser(0).normal, example().laser(0).normal);
  EXPECT_EQ(loaded.laser(0).distance, example().laser(0).distance);
}

TEST_F(ScannerModelFile, IsRefusedWithTheNameOfTheBadEntry) {
  EXPECT_NE(complaint("fx: [0-9.]+\\n *", "").find("camera.fx"), std::string::npos);
  EXPECT_NE(complaint("fx:", "focal:").find("camera.focal"), std::string::npos);
  EXPECT_NE(complaint("fx: [0-9.]+", "fx: -3").find("fx"), std::string::npos);
  EXPECT_NE(complaint("fx: [0-9.]+", "fx: wide").find("camera.fx"), std::string::npos);
  EXPECT_NE(complaint("distortion: \\[", "distortion: [1, ").find("camera.distortion"),
            std::string::npos);
  EXPECT_NE(complaint("normal: \\[", "normal: [1, ").find("lasers[0].normal"), std::string::npos);
  EXPECT_NE(complaint("distance: -?[0-9.]+", "distance: 7").find("laser_0"), std::string::npos);
  EXPECT_NE(complaint("rotation: .*", "rotation: [1, 1, 1, 1]").find("rotation"),
            std::string::npos);
}

TEST(ScannerModel, IsRefusedWithASensorThatNoCameraHas) {
  ScannerModel model = example();
  model.camera.width = model.camera.height = 16000;  // its table would take gigabytes
  EXPECT_THROW(check(model), scan_cell_common::UnusableInput);
}

TEST_F(ScannerModelFile, IsRefusedWhereMissingOrNotYaml) {
  EXPECT_THROW(scan_cell_common::load_scanner_model("/no/such/scanner.yaml"),
               scan_cell_common::FileError);
  std::ofstream(path_) << "camera: [1, 2";
  EXPECT_THROW(scan_cell_common::load_scanner_model(path_), scan_cell_common::FileError);
}

TEST_F(ScannerModelFile, HoldsALaserThatWasNotCalibrated) {
  ScannerModel model = example();
  model.lasers.insert(model.lasers.begin(), std::nullopt);
  scan_cell_common::save_scanner_model(path_, model);
  const ScannerModel loaded = scan_cell_common::load_scanner_model(path_);
  ASSERT_EQ(loaded.lasers.size(), 2U);
  EXPECT_FALSE(loaded.has_laser(0));
  EXPECT_EQ(loaded.laser(1).normal, example().laser(0).normal);
  try {
    loaded.laser(0);
    FAIL() << "a plane that was never found";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("laser_0: not calibrated"), std::string::npos)
        << error.what();
  }
}

TEST_F(ScannerModelFile, MayHoldHowWellAPointIsKnown) {
  scan_cell_common::save_scanner_model(path_, example());
  EXPECT_TRUE(scan_cell_common::load_point_deviations(path_).empty()) << "it need not";
  const std::vector<double> deviations = {80e-6, 0};
  scan_cell_common::save_scanner_model(path_, example(), "", deviations);
  EXPECT_EQ(scan_cell_common::load_point_deviations(path_), deviations);
  EXPECT_EQ(scan_cell_common::load_scanner_model(path_).laser(0).distance,
            example().laser(0).distance);
}

TEST_F(ScannerModelFile, IsNotWrittenWithADeviationThatItsReaderRefuses) {
  scan_cell_common::save_scanner_model(path_, example(), "", {80e-6});
  for (const double bad : {-1., 0.2, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(scan_cell_common::save_scanner_model(path_, example(), "", {80e-6, bad}),
                 scan_cell_common::UnusableInput)
        << bad;
    EXPECT_EQ(scan_cell_common::load_point_deviations(path_), std::vector<double>{80e-6})
        << "the file that was there";
  }
}

TEST_F(ScannerModelFile, HoldsACameraAlone) {
  ScannerModel model = example();
  model.lasers.clear();
  scan_cell_common::save_scanner_model(path_, model);
  const ScannerModel loaded = scan_cell_common::load_scanner_model(path_);
  EXPECT_TRUE(loaded.lasers.empty());
  EXPECT_THROW(check_can_scan(loaded), scan_cell_common::UnusableInput);
  EXPECT_NO_THROW(check_can_scan(example()));
}

TEST_F(ScannerModelFile, KeepsWhatIsTakenFromAnotherToTheLastDigit) {
  const std::string rotation = "[0.0123456789012345, -0.2, 0.3000000000000004, 0.9327379053088815]";
  scan_cell_common::save_scanner_model(path_, example());
  std::ifstream in(path_);
  const std::string written((std::istreambuf_iterator<char>(in)), {});
  const std::string existing =
      std::regex_replace(written, std::regex("rotation: .*"), "rotation: " + rotation);
  ScannerModel model = scan_cell_common::parse_scanner_model(existing, "existing");
  model.lasers[0]->distance += 1e-4;
  scan_cell_common::save_scanner_model(path_, model, existing);
  std::ifstream again(path_);
  const std::string text((std::istreambuf_iterator<char>(again)), {});
  EXPECT_NE(text.find("rotation: " + rotation), std::string::npos) << text;
  const ScannerModel loaded = scan_cell_common::load_scanner_model(path_);
  EXPECT_EQ(loaded.flange_to_camera.matrix(), model.flange_to_camera.matrix());
  EXPECT_EQ(loaded.camera.distortion, model.camera.distortion);
  EXPECT_EQ(loaded.laser(0).distance, model.laser(0).distance);
}
