// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_programs/accepted_report.h"

namespace tool_path_programs {
namespace {

class AcceptedReports : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "accepted_report/";
    std::filesystem::create_directories(folder_);
    scan_cell_common::save_text(path(), "abc");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path() const { return folder_ + "path.csv"; }

  AcceptedReport read(const std::string& verdict, const std::string& output,
                      const std::string& more = "") const {
    const std::string report = folder_ + "report.json";
    scan_cell_common::save_text(
        report, R"({"verdict": ")" + verdict +
                    R"(", "message": "two poses", "files": {"reference": null, "object": {"name": )"
                    R"("scan.ply", "sha256": "0123456789abcdef0123"}, "output": )" +
                    output + R"(}, "quality": [{"in_air": true}, {"in_air": false}])" + more + "}");
    return accepted_report(report, path());
  }

  std::string folder_;
  // FIPS 180, of "abc"
  const std::string its_ =
      R"({"name": "path.csv", "sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"})";
};

TEST_F(AcceptedReports, GiveWaypointsInTheAirAndHashes) {
  const AcceptedReport report = read("accepted", its_);
  EXPECT_EQ(report.in_air, (std::vector<std::size_t>{0}));
  EXPECT_EQ(report.comments[0], "reference: not from a file");
  EXPECT_EQ(report.comments[1], "object: scan.ply sha256 0123456789abcdef");
  EXPECT_EQ(report.comments[2], "path: path.csv sha256 ba7816bf8f01cfea");
}

TEST_F(AcceptedReports, SayWhatTheyDoNotKnow) {
  const AcceptedReport report = read("accepted", its_);
  EXPECT_EQ(report.scanner, "");
  EXPECT_EQ(report.proven_path, "");
  EXPECT_FALSE(report.scanned);
}

TEST_F(AcceptedReports, TellWhatWasEditedByHandAndThatItNeedsADryRunOfItsOwn) {
  const std::string with_path =
      its_ + R"(, "path": {"name": "proven.csv", "sha256": "aa", "units": "m"})";
  const auto edited = [&](const std::string& sha256, const std::string& done) {
    return read("accepted", with_path,
                R"(, "edits": {"sha256": ")" + sha256 + R"(", "done": [)" + done + "]}");
  };
  const AcceptedReport one = edited("01", R"("waypoint 3 deleted", "waypoint 7 moved")");
  EXPECT_EQ(one.comments.at(4), "edited by hand: waypoint 3 deleted");
  EXPECT_EQ(one.comments.at(5), "edited by hand: waypoint 7 moved");
  const std::string proven = read("accepted", with_path).proven_path;
  EXPECT_EQ(proven, "aa");
  EXPECT_NE(one.proven_path, proven);
  EXPECT_NE(one.proven_path, edited("02", R"("waypoint 3 deleted")").proven_path);
  std::string many = R"("edit")";
  for (int i = 1; i < 30; ++i)
    many += R"(, "edit")";
  EXPECT_EQ(edited("01", many).comments.back(), "edited by hand: 10 more, see the report");
}

TEST_F(AcceptedReports, ARefusedPathBecomesNoProgram) {
  EXPECT_THROW(read("refused", its_), scan_cell_common::Refused);
}

TEST_F(AcceptedReports, AnotherPathThanTheAcceptedOneIsRefused) {
  scan_cell_common::save_text(path(), "abd");
  EXPECT_THROW(read("accepted", its_), scan_cell_common::Refused);
  EXPECT_THROW(read("accepted", "null"), scan_cell_common::Refused);
}

TEST_F(AcceptedReports, WhatIsNoReportIsRefused) {
  EXPECT_THROW(accepted_report(path(), path()), scan_cell_common::UnusableInput);
  EXPECT_THROW(accepted_report(folder_ + "none.json", path()), scan_cell_common::FileError);
}

}  // namespace
}  // namespace tool_path_programs
