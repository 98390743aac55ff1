// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scan_calibration/calibration_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/scanner/point_deviations.h"

namespace fs = std::filesystem;
using namespace scan_calibration;
using nlohmann::json;

namespace {

/// A run with numbers that can be told apart.
CalibrationRun example_run() {
  CalibrationRun run;
  run.session = "session";
  run.verdict = CalibrationVerdict::kPassed;
  run.taken = 3;
  Observations& seen = run.observations;
  seen.width = 640;
  seen.height = 480;
  seen.board = {4, 3, 0.02};
  seen.lasers = {"laser_0"};
  Calibration calibration;
  calibration.scanner.camera = {640, 480, 500, 501, 320, 240};
  calibration.scanner.camera.distortion << -0.1, 0.05, 1e-4, 2e-4, 0.003;
  calibration.scanner.lasers = {
      scan_cell_common::LaserPlane{Eigen::Vector3d(0.8, 0, -0.6), -0.2, {-0.25, 0, 0}}};
  calibration.base_to_board = Eigen::Translation3d(0, 0, 0.4) * Eigen::Isometry3d::Identity();
  for (const char* name : {"a.png", "b <i>.png"}) {
    ViewObservation view;
    view.name = name;
    view.base_to_flange = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 12; ++i) {
      const Eigen::Vector3d corner(0.02 * (i % 4), 0.02 * (i / 4), 0.4);
      view.corners.push_back({i % 4, i / 4, calibration.scanner.camera.project(corner)});
    }
    view.lines = {{{200, 100}, {201, 150}}};
    view.line_counts = {{9, 3, 2, 2, 2}};
    seen.views.push_back(view);
    ViewFigures figures;
    figures.name = name;
    figures.reprojection_rms_px = 0.25;
    figures.laser_plane_rms_mm = {std::nan("")};
    figures.corner_residuals.assign(12, Eigen::Vector2d(0.1, -0.2));
    figures.left_out_points = {{}};
    calibration.views.push_back(figures);
  }
  calibration.fitted = {0.1, {0.2}, 0.3};
  calibration.held_out = {0.4, {0.5}, 0.6};
  calibration.parameters = {{"camera.fx", "px", 500, 0.5}, {"camera.fy", "px", 501, 0.25}};
  calibration.covariance = Eigen::Matrix2d::Identity() * 0.25;
  calibration.rejected = {{"c.png", "", "the board is not seen"}};
  calibration.uncertainty = {{"laser_0", 0.3, {320, 240}, 0.07}};
  calibration.advice = {{"tilt it", Eigen::Isometry3d::Identity(), 0.05}};
  run.calibration = calibration;
  run.sequential = SequentialCalibration{
      calibration.scanner, calibration.base_to_board, {1.1, {1.2}, 1.3}, {1.4, {1.5}, 1.6}};
  return run;
}

class CalibrationResults : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  CalibrationFiles files() const {
    return {path("scanner.yaml"), camera_info_file(path("scanner.yaml")), path("report.json")};
  }
  std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  int kept() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_))
      count += entry.path().filename().string().find("scanner_2") == 0 ? 1 : 0;
    return count;
  }

  fs::path folder_ = fs::temp_directory_path() / ("results_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(CalibrationResults, StateEveryFigureFittedAndHeldOutAndTheSequentialWayBesideIt) {
  save_calibration(example_run(), files());
  const json report = json::parse(text("report.json"));
  EXPECT_EQ(report["verdict"], "passed");
  EXPECT_EQ(report["reprojection_rms_px"], (json{{"fitted", 0.1}, {"held_out", 0.4}}));
  EXPECT_EQ(report["laser_plane_rms_mm"]["laser_0"], (json{{"fitted", 0.2}, {"held_out", 0.5}}));
  EXPECT_EQ(report["board_scatter_mm"], (json{{"fitted", 0.3}, {"held_out", 0.6}}));
  EXPECT_EQ(report["sequential"]["board_scatter_mm"], (json{{"fitted", 1.3}, {"held_out", 1.6}}));
  EXPECT_EQ(report["parameters"][1]["name"], "camera.fy");
  EXPECT_EQ(report["covariance"][1][1], 0.25);
  EXPECT_EQ(report["rejected"][0]["reason"], "the board is not seen");
  EXPECT_EQ(report["point_uncertainty"][0]["deviation_mm"], 0.07);
  EXPECT_EQ(report["advice"][0]["text"], "tilt it");
  EXPECT_EQ(report["views"][0]["lines"]["laser_0"]["at_edges"], 2);
  EXPECT_TRUE(report["views"][0]["laser_plane_rms_mm"]["laser_0"].is_null()) << "not seen";
  EXPECT_EQ(report["views"][0]["residuals_px"][5].size(), 6U);
  EXPECT_EQ(report["views_taken"], 3);
  EXPECT_EQ(report["views_used"], 2);
}

TEST_F(CalibrationResults, AreTheModelAndTheCameraAsRosReadsIt) {
  save_calibration(example_run(), files());
  const auto model = scan_cell_common::load_scanner_model(path("scanner.yaml"));
  EXPECT_EQ(model.camera.fy, 501);
  EXPECT_EQ(model.lasers.size(), 1U);
  const YAML::Node camera = YAML::LoadFile(path("scanner_camera_info.yaml"));
  EXPECT_EQ(camera["image_width"].as<int>(), 640);
  EXPECT_EQ(camera["distortion_model"].as<std::string>(), "plumb_bob");
  EXPECT_EQ(camera["camera_matrix"]["data"].as<std::vector<double>>(),
            (std::vector<double>{500, 0, 320, 0, 501, 240, 0, 0, 1}));
  EXPECT_EQ(camera["distortion_coefficients"]["data"].as<std::vector<double>>(),
            (std::vector<double>{-0.1, 0.05, 1e-4, 2e-4, 0.003}));
  EXPECT_EQ(camera["projection_matrix"]["data"].as<std::vector<double>>().size(), 12U);
}

TEST_F(CalibrationResults, SayHowWellAPointIsKnownByAllThatItDependsOn) {
  const auto deviations_of = [this](const CalibrationRun& run) {
    save_calibration(run, files());
    return scan_cell_common::load_point_deviations(path("scanner.yaml"));
  };
  CalibrationRun run = example_run();
  run.calibration->uncertainty = {{"laser_0", 0.3, {320, 240}, 0.08}};
  run.calibration->scanner.lasers.push_back(run.calibration->scanner.lasers[0]);
  run.existing = ExistingScanner{"old.yaml", "", run.calibration->scanner, {0.05e-3, 0.06e-3}};
  run.calibration->kept = {"laser_1"};
  EXPECT_EQ(deviations_of(run), (std::vector<double>{0.08e-3, 0}))
      << "nobody knows laser_1 behind another camera";
  run.calibration->kept = {"camera", "flange_to_camera", "laser_1"};
  std::vector<double> found = deviations_of(run);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_DOUBLE_EQ(found[0], 0.1e-3) << "the plane's 0.08, and what camera and hand-eye may add";
  EXPECT_EQ(found[1], 0.06e-3) << "as it was";
  run.existing->deviations.clear();
  EXPECT_TRUE(deviations_of(run).empty()) << "a plane's share alone is no figure of a point";
}

TEST_F(CalibrationResults, DoNotSayHowWellAPointIsKnownWhereItHardlyIs) {
  for (const double deviation : {150., std::nan("")}) {
    CalibrationRun run = example_run();
    run.calibration->uncertainty = {{"laser_0", 0.3, {320, 240}, deviation},
                                    {"laser_0", 0.4, {320, 240}, 0.08}};
    save_calibration(run, files());
    EXPECT_TRUE(scan_cell_common::load_point_deviations(path("scanner.yaml")).empty()) << deviation;
  }
}

TEST_F(CalibrationResults, ArePicturesOnAPage) {
  save_calibration(example_run(), files());
  const std::string page = text("report.html");
  for (const char* name : {"coverage", "space_above", "space_side", "residuals", "plane_laser_0"}) {
    const std::size_t figure = page.find(std::string("<figure id=\"") + name + "\">\n<svg");
    ASSERT_NE(figure, std::string::npos) << name;
    EXPECT_NE(page.substr(figure, page.find("</figure>", figure) - figure).find("<path d=\"M"),
              std::string::npos)
        << name;
  }
  EXPECT_EQ(page.find("src="), std::string::npos) << "one file holds it all";
  EXPECT_NE(page.find("b &lt;i&gt;.png"), std::string::npos) << "names cannot break the page";
  EXPECT_EQ(page.find("<i>"), std::string::npos);
}

TEST_F(CalibrationResults, KeepTheOldModelUnderTheTimeItWasWritten) {
  std::ofstream(path("scanner.yaml")) << "old";
  const WrittenFiles first = save_calibration(example_run(), files());
  EXPECT_EQ(kept(), 1);
  std::ifstream old(first.kept_scanner);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(old), {}), "old");
  save_calibration(example_run(), files());
  save_calibration(example_run(), files());
  EXPECT_EQ(kept(), 3) << "within the same second too";
}

TEST_F(CalibrationResults, AreNotWrittenOverAModelWhereALimitIsMissedOrTheSessionRefused) {
  std::ofstream(path("scanner.yaml")) << "old";
  CalibrationRun run = example_run();
  run.verdict = CalibrationVerdict::kLimitsMissed;
  run.judged = {{"board_scatter_mm", 0.6, 0.5}};
  EXPECT_EQ(save_calibration(run, files()).scanner, "");
  EXPECT_EQ(json::parse(text("report.json"))["limits"][0]["passed"], false);
  EXPECT_NE(text("report.html").find("Not accepted"), std::string::npos);
  run.verdict = CalibrationVerdict::kRefused;
  run.reason = "views of the board: 2; give more";
  run.calibration.reset();
  save_calibration(run, files());
  EXPECT_EQ(json::parse(text("report.json"))["reason"], "views of the board: 2; give more");
  EXPECT_NE(text("report.html").find("views of the board: 2"), std::string::npos);
  EXPECT_EQ(text("scanner.yaml"), "old");
  EXPECT_EQ(kept(), 0);
  EXPECT_FALSE(fs::exists(path("scanner_camera_info.yaml")));
}

TEST_F(CalibrationResults, LeaveTheOldModelInItsPlaceWhereTheNewOneCannotBeWritten) {
  std::ofstream(path("scanner.yaml")) << "old";
  CalibrationFiles wrong = files();
  wrong.camera_info = path("no/folder/camera.yaml");
  EXPECT_THROW(save_calibration(example_run(), wrong), scan_cell_common::FileError);
  EXPECT_EQ(text("scanner.yaml"), "old");
  EXPECT_THROW(check_writable(wrong), scan_cell_common::FileError);
  wrong = files();
  wrong.camera_info = wrong.scanner;
  EXPECT_THROW(check_writable(wrong), scan_cell_common::FileError);
  EXPECT_NO_THROW(check_writable(files()));
}

TEST(CalibrationLimits, AreJudgedOnViewsThatWereNotFitted) {
  const CalibrationRun run = example_run();
  CalibrationLimits limits;
  EXPECT_TRUE(judge(*run.calibration, {"laser_0"}, limits).empty());
  limits.reprojection_rms_px = 0.3;  // between fitted and held out
  limits.laser_plane_rms_mm = 0.55;
  limits.board_scatter_mm = 0.65;
  limits.point_deviation_mm = 0.06;
  const auto judged = judge(*run.calibration, {"laser_0"}, limits);
  ASSERT_EQ(judged.size(), 4U);
  EXPECT_FALSE(judged[0].passed());
  EXPECT_TRUE(judged[1].passed());
  EXPECT_TRUE(judged[2].passed());
  EXPECT_FALSE(judged[3].passed());
  EXPECT_FALSE((JudgedFigure{"x", std::nan(""), 1}).passed());
}
