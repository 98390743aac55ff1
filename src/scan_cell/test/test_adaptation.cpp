// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "client/adaptation.h"
#include "scan_cell/ros/adaptation_report.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;

namespace {

class Adaptation : public testing::Test {
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

TEST_F(Adaptation, LeavesNothingOfAnEarlierRun) {
  for (const char* name : {"object.ply", "adapted_path.csv", "report.json", "notes.txt"})
    write(name);
  scan_cell::clear_results({"reference.ply", "path.csv", folder_.string()});
  EXPECT_FALSE(fs::exists(folder_ / "object.ply"));
  EXPECT_FALSE(fs::exists(folder_ / "adapted_path.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "report.json"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt")) << "it belongs to somebody else";
}

TEST_F(Adaptation, NeverTakesAnInputForAResult) {
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

TEST_F(Adaptation, SaysWhereAnOldResultCannotBeRemoved) {
  fs::create_directories(folder_ / "adapted_path.csv" / "something");
  EXPECT_THROW(scan_cell::clear_results({"reference.ply", "path.csv", folder_.string()}),
               scan_cell_common::FileError);
}

TEST_F(Adaptation, ReportSaysWhatBelongsTogether) {
  scan_cell::AdaptationRecord record;
  record.reference = write("reference.ply");
  record.path = write("path.csv");
  record.path_units = "mm";
  record.adapted = write("adapted_path.csv");
  record.object = write("object.ply");
  record.scanned = 12.5;
  record.calibration = {write("scanner.yaml"), "/on/another/machine.yaml"};
  const auto report = nlohmann::json::parse(
      scan_cell::completed(R"({"verdict": "accepted", "files": {"output": null}})", record, {}));
  EXPECT_EQ(report["verdict"], "accepted");
  // sha256sum of the file's bytes, which are the file's name
  EXPECT_EQ(report["files"]["path"]["sha256"],
            "d4aad7fb6bea9a8549e25bc0e37cdb47bb5dadd2dcaad355983d73adb24ec696");
  EXPECT_EQ(report["files"]["path"]["units"], "mm");
  EXPECT_EQ(report["files"]["output"]["name"], "adapted_path.csv");
  EXPECT_EQ(report["files"]["output"]["sha256"],
            "c187a55902952f2e29f22a47f8a9d6d64bf6a10887e06994efc9e0b8bd1416b7");
  EXPECT_EQ(report["scanned"], 12.5);
  EXPECT_EQ(report["calibration"]["scanner"]["sha256"],
            "e7467fc73d2ab9895ef1be3a807f9738ea93c9ed926bc4a63e2df74be0d0bf65");
  EXPECT_TRUE(report["calibration"]["cell"]["sha256"].is_null());
  record.adapted.clear();
  EXPECT_TRUE(
      nlohmann::json::parse(scan_cell::completed("{}", record, {}))["files"]["output"].is_null());
}
