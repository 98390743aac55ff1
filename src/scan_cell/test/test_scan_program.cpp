// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_cell/scan_program.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;
using scan_cell::PassKind;
using scan_cell::PassLasers;

namespace {

const char* const kGood =
    "frame: world\n"
    "start: {translation: [-0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "end: {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "speed: 0.05\n"
    "rate: 100\n"
    "laser: 1\n";

const char* const kPasses =
    "frame: world\n"
    "passes:\n"
    "  - line:\n"
    "      start: {translation: [-0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "      end: {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "    name: flank\n"
    "    speed: 0.05\n"
    "    rate: 100\n"
    "    laser: each\n"
    "  - arc:\n"
    "      start: {translation: [-0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "      via: {translation: [0, 0.1, 0.6], rotation: [1, 0, 0, 0]}\n"
    "      end: {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "    speed: 0.05\n"
    "    rate: 100\n"
    "    laser: alternate\n"
    "  - poses:\n"
    "      - {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "      - {translation: [0.2, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "      - {translation: [0.2, 0.1, 0.6], rotation: [1, 0, 0, 0]}\n"
    "    speed: 0.05\n"
    "    rate: 100\n"
    "    laser: 0\n";

class ScanProgram : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  scan_cell::ScanProgram load(const std::string& text) const {
    std::ofstream(path_) << text;
    return scan_cell::load_scan_program(path_);
  }

  /// What is named as wrong after the first `from` in the good program is replaced by `to`.
  std::string refused(const std::string& from, const std::string& to,
                      std::string text = kGood) const {
    text.replace(text.find(from), from.size(), to);
    try {
      load(text);
    } catch (const scan_cell_common::UnusableInput& error) {
      return error.thing().substr(path_.size() + 2);  // after "FILE: "
    }
    return "nothing";
  }

  std::string path_ =
      (fs::temp_directory_path() / ("program_" + std::to_string(getpid()) + ".yaml")).string();
};

}  // namespace

TEST_F(ScanProgram, IsReadBackAsItWasWritten) {
  scan_cell::ScanProgram program = load(kPasses);
  program.passes[1].camera = {0.0005, scan_cell::CameraRegion{8, 16, 640, 480}, "threshold"};
  scan_cell::save_scan_program(path_, program);
  const scan_cell::ScanProgram again = scan_cell::load_scan_program(path_);
  EXPECT_EQ(again.frame, program.frame);
  ASSERT_EQ(again.passes.size(), program.passes.size());
  for (std::size_t i = 0; i < program.passes.size(); ++i) {
    const scan_cell::ScanPass &one = program.passes[i], &other = again.passes[i];
    EXPECT_EQ(other.name, one.name);
    EXPECT_EQ(other.kind, one.kind);
    EXPECT_EQ(other.speed, one.speed);
    EXPECT_EQ(other.rate, one.rate);
    EXPECT_EQ(other.lasers, one.lasers);
    EXPECT_EQ(other.camera, one.camera);
    ASSERT_EQ(other.poses.size(), one.poses.size());
    for (std::size_t k = 0; k < one.poses.size(); ++k)
      EXPECT_TRUE(other.poses[k].isApprox(one.poses[k], 1e-15)) << i << " " << k;
  }
}

TEST_F(ScanProgram, GivesItsPassesInTheirFrame) {
  const scan_cell::ScanProgram program = load(kPasses);
  EXPECT_EQ(program.frame, "world");
  ASSERT_EQ(program.passes.size(), 3U);
  EXPECT_EQ(program.passes[0].name, "flank");
  EXPECT_EQ(program.passes[0].kind, PassKind::kLine);
  EXPECT_EQ(program.passes[0].lasers, PassLasers::kEach);
  EXPECT_EQ(program.passes[0].poses[0].translation(), Eigen::Vector3d(-0.1, 0, 0.6));
  EXPECT_EQ(program.passes[1].kind, PassKind::kArc);
  ASSERT_EQ(program.passes[1].poses.size(), 3U);
  EXPECT_EQ(program.passes[1].poses[1].translation(), Eigen::Vector3d(0, 0.1, 0.6));
  EXPECT_EQ(program.passes[1].lasers, PassLasers::kAlternate);
  EXPECT_EQ(program.passes[2].kind, PassKind::kPolyline);
  EXPECT_EQ(program.passes[2].poses.size(), 3U);
  EXPECT_EQ(program.passes[2].speed, 0.05);
  EXPECT_EQ(program.passes[2].rate, 100);
}

TEST_F(ScanProgram, GivesTheSettingsOfTheCameraOfAPass) {
  std::string text = kPasses;
  EXPECT_TRUE(load(text).passes[0].camera.empty());
  const std::string name = "    name: flank\n";
  text.replace(text.find(name), name.size(),
               name +
                   "    camera: {exposure: 0.0005, region: {x: 8, y: 16, width: 640, height: 480}, "
                   "detector: threshold}\n");
  const scan_cell::PassCamera camera = load(text).passes[0].camera;
  EXPECT_EQ(camera.exposure, 0.0005);
  EXPECT_TRUE(camera.region == (scan_cell::CameraRegion{8, 16, 640, 480}));
  EXPECT_EQ(camera.detector, "threshold");
  EXPECT_TRUE(load(text).passes[1].camera.empty());
}

TEST_F(ScanProgram, OfTheTimeBeforePassesIsOneLine) {
  const scan_cell::ScanProgram program = load(kGood);
  EXPECT_EQ(program.frame, "world");
  ASSERT_EQ(program.passes.size(), 1U);
  const scan_cell::ScanPass& pass = program.passes.front();
  EXPECT_EQ(pass.kind, PassKind::kLine);
  EXPECT_EQ(pass.poses[0].translation(), Eigen::Vector3d(-0.1, 0, 0.6));
  const Eigen::Vector3d looks = pass.poses[1].linear() * Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(looks.isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_EQ(pass.lasers, PassLasers::kLaser1);
}

TEST_F(ScanProgram, IsRefusedByTheNameOfTheBadEntry) {
  EXPECT_EQ(refused("frame: world\n", ""), "frame");
  EXPECT_EQ(refused("start:", "begin:"), "begin");
  EXPECT_EQ(refused("[-0.1, 0, 0.6]", "[-0.1, 0]"), "start.translation");
  EXPECT_EQ(refused("[1, 0, 0, 0]", "[1, 1, 0, 0]"), "start.rotation");
  EXPECT_EQ(refused("0.05", "slow"), "speed");
  EXPECT_EQ(refused("laser: 1", "laser: 2"), "laser");
}

TEST_F(ScanProgram, IsRefusedByTheNameOfTheBadEntryOfAPass) {
  const auto of_passes = [this](const std::string& from, const std::string& to) {
    return refused(from, to, kPasses);
  };
  EXPECT_EQ(of_passes("laser: each", "laser: both"), "passes[0].laser");
  EXPECT_EQ(of_passes("via:", "over:"), "passes[1].arc.over");
  EXPECT_EQ(of_passes("arc:", "circle:"), "passes[1].circle");
  EXPECT_EQ(of_passes("    name: flank\n", "    poses: []\n"), "passes[0]") << "two ways";
  EXPECT_EQ(of_passes("{translation: [0.2, 0, 0.6], ", "{"), "passes[2].poses[1].translation");
  EXPECT_EQ(of_passes("frame: world\n", "frame: world\nspeed: 1\n"), "speed");
  EXPECT_EQ(of_passes("    name: flank\n", "    frame: base_link\n"), "passes[0].frame");
  EXPECT_EQ(of_passes("    name: flank\n", "    camera: {gain: 1}\n"), "passes[0].camera.gain");
  EXPECT_EQ(of_passes("    name: flank\n", "    camera: {region: {x: 1}}\n"),
            "passes[0].camera.region.y");
}

TEST_F(ScanProgram, IsRefusedWithoutAPass) {
  EXPECT_THROW(load("frame: world\npasses: []\n"), scan_cell_common::UnusableInput);
}

TEST_F(ScanProgram, IsRefusedWhereMissingOrNotYaml) {
  EXPECT_THROW(scan_cell::load_scan_program("/no/such/program.yaml"), scan_cell_common::FileError);
  EXPECT_THROW(load("frame: [world"), scan_cell_common::FileError);
}
