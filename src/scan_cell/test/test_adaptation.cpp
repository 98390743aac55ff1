// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "client/adaptation.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;

namespace {

class ClearResults : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name) const {
    std::ofstream(folder_ / name) << name;
    return (folder_ / name).string();
  }

  fs::path folder_ = fs::temp_directory_path() / ("adaptation_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(ClearResults, LeavesNothingOfAnEarlierRun) {
  for (const char* name : {"object.ply", "adapted_path.csv", "report.json", "notes.txt"})
    write(name);
  scan_cell::clear_results({"reference.ply", "path.csv", folder_.string()});
  EXPECT_FALSE(fs::exists(folder_ / "object.ply"));
  EXPECT_FALSE(fs::exists(folder_ / "adapted_path.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "report.json"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt")) << "it belongs to somebody else";
}

TEST_F(ClearResults, NeverTakesAnInputForAResult) {
  const std::string path = write("adapted_path.csv");
  const std::string reference = write("object.ply");
  write("report.json");
  const std::string folder = folder_.string() + "/../" + folder_.filename().string();
  EXPECT_THROW(scan_cell::clear_results({"reference.ply", path, folder}),
               scan_cell_common::FileError);
  EXPECT_THROW(scan_cell::clear_results({reference, "path.csv", folder}),
               scan_cell_common::FileError);
  for (const char* name : {"object.ply", "adapted_path.csv", "report.json"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
}

TEST_F(ClearResults, SaysWhereAnOldResultCannotBeRemoved) {
  fs::create_directories(folder_ / "adapted_path.csv" / "something");
  EXPECT_THROW(scan_cell::clear_results({"reference.ply", "path.csv", folder_.string()}),
               scan_cell_common::FileError);
}
