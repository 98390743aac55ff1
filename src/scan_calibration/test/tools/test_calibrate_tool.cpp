// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scan_cell_common/scanner/point_deviations.h"
#include "session/rendered_session.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int kViews = 14;

/// The command on a rendered session.
class CalibrateTool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    fs::remove_all(session());
    record(example_session(kViews), session());
  }
  static void TearDownTestSuite() { fs::remove_all(session()); }

  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static fs::path session() {
    return fs::temp_directory_path() / ("calibrate_session_" + std::to_string(getpid()));
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  int run(const fs::path& of, const std::string& more = "") const {
    const std::string command =
        std::string(CALIBRATE) + " --session " + of.string() + " --output " + path("scanner.yaml") +
        " --report " + path("report.json") + " " + more + " > " + path("out.txt") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  fs::path folder_ = fs::temp_directory_path() / ("calibrate_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(CalibrateTool, FindsTheScannerThatTheImagesWereTakenWith) {
  ASSERT_EQ(run(session()), 0) << text("out.txt");
  const auto model = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  const auto deviations = scan_cell_common::load_point_deviations(path("scanner.yaml"));
  EXPECT_EQ(deviations.size(), model.lasers.size());
  for (const double deviation : deviations) {
    EXPECT_GT(deviation, 0);
    EXPECT_LT(deviation, 1e-3) << "of a good session";
  }
  const RenderedSession rendered = example_session(kViews);
  const scan_cell_common::ScannerModel& truth = rendered.truth;
  EXPECT_NEAR(model.camera.fx, truth.camera.fx, 0.5);
  EXPECT_NEAR(model.camera.cx, truth.camera.cx, 0.5);
  EXPECT_LT((model.flange_to_camera.translation() - truth.flange_to_camera.translation()).norm(),
            3e-4);
  // What the numbers mean together: a point on each laser's plane, in tool0.
  ASSERT_EQ(model.lasers.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d ray(0.05, -0.03, 1);
    const auto point = [&](const scan_cell_common::ScannerModel& of) -> Eigen::Vector3d {
      const scan_cell_common::LaserPlane& laser = of.laser(i);
      return of.flange_to_camera * (ray * laser.distance / laser.normal.dot(ray));
    };
    EXPECT_LT((point(model) - point(truth)).norm(), 3e-4) << "laser " << i;
  }
  const json report = json::parse(text("report.json"));
  EXPECT_LT(report["reprojection_rms_px"]["held_out"], 0.05);
  EXPECT_LT(report["laser_plane_rms_mm"]["laser_1"]["held_out"], 0.06);
  EXPECT_TRUE(fs::exists(path("report.html")));
  EXPECT_NE(text("out.txt").find("board: 14 of 14"), std::string::npos) << "progress";
}

TEST_F(CalibrateTool, WritesTheReportAndNoModelWhereALimitIsMissed) {
  EXPECT_EQ(run(session(), "--max-plane-rms 0.0001"), 2) << text("out.txt");
  EXPECT_EQ(json::parse(text("report.json"))["verdict"], "limits_missed");
  EXPECT_NE(text("out.txt").find("laser_plane_rms_mm laser_0"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("scanner.yaml")));
}

TEST_F(CalibrateTool, RefusesASessionThatGivesNoCalibration) {
  const fs::path few = folder_ / "few";
  record(example_session(2), few);
  EXPECT_EQ(run(few), 2);
  const json report = json::parse(text("report.json"));
  EXPECT_EQ(report["verdict"], "refused");
  EXPECT_NE(report["reason"].get<std::string>().find("views"), std::string::npos) << report;
  EXPECT_FALSE(fs::exists(path("scanner.yaml")));
}

TEST_F(CalibrateTool, RefusesALaserThatNeverShows) {
  RenderedSession dark = example_session(8);
  dark.truth.lasers[1]->distance = 5;  // its light is nowhere near the board
  record(dark, folder_ / "dark");
  EXPECT_EQ(run(folder_ / "dark"), 2);
  EXPECT_NE(text("out.txt").find("laser_1"), std::string::npos) << text("out.txt");
  EXPECT_FALSE(fs::exists(path("scanner.yaml")));
}

TEST_F(CalibrateTool, EndsWithOneOnUnusableInput) {
  EXPECT_EQ(run(folder_ / "none"), 1);
  EXPECT_NE(text("out.txt").find("session.yaml: no such file"), std::string::npos)
      << text("out.txt");
  EXPECT_EQ(run(session(), "--detector eye"), 1);
  EXPECT_EQ(run(session(), "--projector 1 2"), 1);
  EXPECT_EQ(run(session(), "--max-plane-rms -1"), 1);
  for (const std::string name : {"reprojection", "plane-rms", "board-scatter", "point-deviation"}) {
    EXPECT_EQ(run(session(), "--most-" + name + " 1"), 1);
    EXPECT_NE(text("out.txt").find("--most-" + name + ": renamed; use --max-" + name),
              std::string::npos)
        << text("out.txt");
  }
  EXPECT_EQ(run(session(), "--camera-info " + path("no/camera.yaml")), 1);
  EXPECT_FALSE(fs::exists(path("report.json")));
}

namespace {

/// The text of a file from one entry of the root to the next.
std::string entry(const std::string& text, const std::string& name, const std::string& next) {
  const std::size_t begin = text.find(name);
  return text.substr(begin, text.find(next, begin) - begin);
}

}  // namespace

TEST_F(CalibrateTool, CalibratesALaserThatWasTiltedAndKeepsTheRestToTheLastDigit) {
  ASSERT_EQ(run(session()), 0) << text("out.txt");
  const std::string before = text("scanner.yaml");
  const auto old = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  const auto known = scan_cell_common::load_point_deviations(path("scanner.yaml"));
  RenderedSession tilted = example_session(8);
  scan_cell_common::LaserPlane& laser = *tilted.truth.lasers[1];
  laser.normal = Eigen::AngleAxisd(0.06, Eigen::Vector3d::UnitY()) * laser.normal;
  laser.distance = laser.normal.dot(Eigen::Vector3d(0, 0, 0.3));
  record(tilted, folder_ / "tilted", false, 3, {"laser_1"});
  // Overwrites the model that it reads: the usual way
  ASSERT_EQ(run(folder_ / "tilted", "--lasers-alone --scanner " + path("scanner.yaml")), 0)
      << text("out.txt");
  const std::string after = text("scanner.yaml");
  EXPECT_EQ(entry(after, "camera:", "lasers:"), entry(before, "camera:", "lasers:"));
  EXPECT_EQ(entry(after, "lasers:", "\n  - normal"), entry(before, "lasers:", "\n  - normal"));
  const auto model = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  EXPECT_EQ(model.laser(0).normal, old.laser(0).normal);
  EXPECT_EQ(model.laser(0).distance, old.laser(0).distance);
  const auto deviations = scan_cell_common::load_point_deviations(path("scanner.yaml"));
  ASSERT_EQ(deviations.size(), 2U);
  EXPECT_EQ(deviations[0], known[0]);
  EXPECT_GT(deviations[1], std::max(known[0], known[1])) << "camera and hand-eye are in it";
  EXPECT_LT(deviations[1], 1e-3);
  // The normal may point to either side of the plane
  EXPECT_LT(model.laser(1).normal.cross(laser.normal).norm(), 2e-3);
  EXPECT_GT(old.laser(1).normal.cross(laser.normal).norm(), 0.05);
  const json report = json::parse(text("report.json"));
  EXPECT_EQ(report["kept"], json({"camera", "flange_to_camera", "laser_0"}));
  EXPECT_EQ(report["existing"], path("scanner.yaml"));
  EXPECT_FALSE(report["laser_plane_rms_mm"].contains("laser_0"));
  EXPECT_NE(text("report.html").find("Not calibrated again"), std::string::npos);
  EXPECT_NE(text("out.txt").find("kept from " + path("scanner.yaml") + ": camera"),
            std::string::npos)
      << text("out.txt");
}

TEST_F(CalibrateTool, CalibratesTheCameraAloneOfASessionWithLasers) {
  ASSERT_EQ(run(session()), 0) << text("out.txt");
  const auto old = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  ASSERT_EQ(
      run(session(), "--camera-alone --max-point-deviation 1 --scanner " + path("scanner.yaml")), 0)
      << text("out.txt");
  const auto model = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  EXPECT_NEAR(model.camera.fx, example_session(1).truth.camera.fx, 0.5);
  for (std::size_t laser = 0; laser < 2; ++laser)
    EXPECT_EQ(model.laser(laser).normal, old.laser(laser).normal);
  EXPECT_EQ(json::parse(text("report.json"))["kept"], json({"laser_0", "laser_1"}));
}

TEST_F(CalibrateTool, LeavesALaserOutThatWasNotCalibrated) {
  ASSERT_EQ(run(session(), "--lasers 1"), 0) << text("out.txt");
  const auto model = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  EXPECT_FALSE(model.has_laser(0));
  EXPECT_TRUE(model.has_laser(1));
}

TEST_F(CalibrateTool, RefusesPartsThatDoNotGoTogether) {
  EXPECT_EQ(run(session(), "--lasers-alone"), 1);
  EXPECT_NE(text("out.txt").find("no existing scanner model"), std::string::npos)
      << text("out.txt");
  EXPECT_EQ(run(session(), "--lasers-alone --camera-alone"), 1);
  EXPECT_EQ(run(session(), "--lasers 5"), 1);
  EXPECT_NE(text("out.txt").find("laser_5: not in the session"), std::string::npos)
      << text("out.txt");
}
