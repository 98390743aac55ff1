// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_cell/scan_program.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;

namespace {

const char* const kGood =
    "frame: world\n"
    "start: {translation: [-0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "end: {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
    "speed: 0.05\n"
    "rate: 100\n"
    "laser: 1\n";

class ScanProgram : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  scan_cell::ScanProgram load(const std::string& text) const {
    std::ofstream(path_) << text;
    return scan_cell::load_scan_program(path_);
  }

  /// What is named as wrong after the first `from` in the good program became `to`.
  std::string refused(const std::string& from, const std::string& to) const {
    std::string text = kGood;
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

TEST_F(ScanProgram, GivesTheRequestInItsFrame) {
  const scan_cell::ScanProgram program = load(kGood);
  EXPECT_EQ(program.frame, "world");
  EXPECT_EQ(program.request.start.translation(), Eigen::Vector3d(-0.1, 0, 0.6));
  const Eigen::Vector3d looks = program.request.end.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(looks.isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_EQ(program.request.lasers, 2);
}

TEST_F(ScanProgram, IsRefusedByTheNameOfTheBadEntry) {
  EXPECT_EQ(refused("frame: world\n", ""), "frame");
  EXPECT_EQ(refused("start:", "begin:"), "begin");
  EXPECT_EQ(refused("[-0.1, 0, 0.6]", "[-0.1, 0]"), "start.translation");
  EXPECT_EQ(refused("[1, 0, 0, 0]", "[1, 1, 0, 0]"), "start.rotation");
  EXPECT_EQ(refused("0.05", "slow"), "speed");
  EXPECT_EQ(refused("laser: 1", "laser: 2"), "laser");
}

TEST_F(ScanProgram, IsRefusedWhereMissingOrNotYaml) {
  EXPECT_THROW(scan_cell::load_scan_program("/no/such/program.yaml"), scan_cell_common::FileError);
  EXPECT_THROW(load("frame: [world"), scan_cell_common::FileError);
}
