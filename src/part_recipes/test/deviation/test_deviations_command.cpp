// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drawn_surfaces.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/files/files.h"

using drawn::Points;
using Eigen::Vector3d;

namespace {

class DeviationsCommand : public testing::Test {
 protected:
  DeviationsCommand() {
    folder_.save("reference.ply", drawn::plane());
    Points object;
    for (const Vector3d& point : drawn::plane(0.0015))
      object.push_back(drawn::moved() *
                       (0.95 * point + Vector3d(0, 0, kLift / drawn::moved().scale)));
    object.push_back(drawn::moved() * Vector3d(0, 0, 0.05));  // far off
    folder_.save("object.ply", object);
    points_ = object.size();
    drawn::save_report(folder_ / "report.json", drawn::moved());
    folder_.save("places.yaml", std::string("- {name: middle, position: [0, 0, 0], radius: 0.01}\n"
                                            "- {name: off, position: [0, 1, 0]}\n"));
  }

  int run(const std::string& program, const std::string& options) const {
    const int status =
        std::system((program + " " + options + " >" + (folder_ / "log") + " 2>&1").c_str());
    return WEXITSTATUS(status);
  }

  int measure(const std::string& more = "") const {
    return run(DEVIATIONS, "--reference " + (folder_ / "reference.ply") + " --object " +
                               (folder_ / "object.ply") + " --report " + (folder_ / "report.json") +
                               " --places " + (folder_ / "places.yaml") + " --output " +
                               (folder_ / "deviation.ply") + " --summary " +
                               (folder_ / "deviation.json") + " " + more);
  }

  bool there_are_results() const {
    return std::filesystem::exists(folder_ / "deviation.ply") ||
           std::filesystem::exists(folder_ / "deviation.json");
  }

  std::string log() const { return scan_cell_common::read_file(folder_ / "log"); }

  static constexpr double kLift = 0.0007;  // [m] on the object
  drawn::Folder folder_;
  std::size_t points_ = 0;
};

}  // namespace

TEST_F(DeviationsCommand, WritesEveryPointAndTheSummary) {
  ASSERT_EQ(measure("--tolerance 0.0006"), 0) << log();
  scan_cell_common::FieldedCloud carried;
  scan_cell_common::load_cloud_file(folder_ / "deviation.ply", {}, carried);
  ASSERT_EQ(carried.size(), points_);
  ASSERT_EQ(carried.fields.back().name, "deviation");
  for (std::size_t i = 0; i < points_; ++i) {
    float deviation = 0;
    std::memcpy(&deviation, carried.bytes.data() + i * carried.step + carried.fields.back().offset,
                sizeof(float));
    if (i + 1 == points_)
      EXPECT_TRUE(std::isnan(deviation));
    else
      ASSERT_NEAR(deviation, kLift, 1e-6);
  }
  const auto summary =
      nlohmann::json::parse(scan_cell_common::read_file(folder_ / "deviation.json"));
  EXPECT_EQ(summary["tolerance"], 0.0006);
  EXPECT_EQ(summary["points"], points_);
  EXPECT_EQ(summary["unknown_points"], 1);
  EXPECT_NEAR(summary["rms"].get<double>(), kLift, 1e-6);
  EXPECT_EQ(summary["within_tolerance_share"], 0);
  EXPECT_EQ(summary["places"][0]["name"], "middle");
  EXPECT_NEAR(summary["places"][0]["deviation"].get<double>(), kLift, 1e-6);
  EXPECT_TRUE(summary["places"][1]["deviation"].is_null());
  EXPECT_EQ(summary["places"][1]["points"], 0);
  EXPECT_NEAR(summary["unscanned_share"].get<double>(), 0, 0.02);
}

TEST_F(DeviationsCommand, WithoutAPoseRefusesAndLeavesNothing) {
  ASSERT_EQ(measure(), 0) << log();
  drawn::save_report(folder_ / "report.json", {}, false);
  EXPECT_EQ(measure(), 2);
  EXPECT_NE(log().find("no pose of the part"), std::string::npos) << log();
  EXPECT_FALSE(there_are_results());
}

TEST_F(DeviationsCommand, RefusesFilesOfAnotherRun) {
  auto report = nlohmann::json::parse(scan_cell_common::read_file(folder_ / "report.json"));
  report["files"]["object"] = {{"name", "that.ply"}, {"sha256", "00"}, {"units", "m"}};
  folder_.save("report.json", report.dump());
  EXPECT_EQ(measure(), 1);
  EXPECT_NE(log().find("not the object of the report, which was that.ply"), std::string::npos)
      << log();
  EXPECT_FALSE(there_are_results());
}

TEST_F(DeviationsCommand, RefusesBadInput) {
  EXPECT_EQ(measure("--tolerance 0"), 1);
  EXPECT_EQ(measure("--reference-units furlong"), 1);
  folder_.save("report.json", std::string("{\"verdict\": 1}"));
  EXPECT_EQ(measure(), 1);
  drawn::save_report(folder_ / "report.json", drawn::moved());
  folder_.save("object.ply", std::string("ply\nformat ascii 1.0\nelement vertex 4"));
  EXPECT_EQ(measure(), 1);
  EXPECT_FALSE(there_are_results());
}

TEST_F(DeviationsCommand, ItsSceneHasTheReferenceOnTheObjectAndBothPaths) {
  folder_.save("path.csv", std::string("x,y,z,segment\n10,0,0,a\n20,0,0,a\n30,0,0,b\n"));
  folder_.save("adapted.csv", std::string("x,y,z,segment\n1,2,3,a\n4,5,6,a\n7,8,9,b\n"));
  ASSERT_EQ(
      run(REPORT_SCENE, "paths --path " + (folder_ / "path.csv") + " --path-units mm --adapted " +
                            (folder_ / "adapted.csv") + " --report " + (folder_ / "report.json") +
                            " --output " + (folder_ / "paths.json")),
      0)
      << log();
  const auto paths = nlohmann::json::parse(scan_cell_common::read_file(folder_ / "paths.json"));
  EXPECT_EQ(paths["segment_of"], nlohmann::json({0, 0, 1}));
  EXPECT_NEAR(paths["adapted"][1][2].get<double>(), 0.006, 1e-12);
  const Vector3d mapped = drawn::moved() * Vector3d(0.02, 0, 0);
  EXPECT_NEAR(paths["mapped"][1][0].get<double>(), mapped.x(), 1e-9);
  ASSERT_EQ(
      run(REPORT_SCENE, "surface --reference " + (folder_ / "reference.ply") + " --object " +
                            (folder_ / "object.ply") + " --report " + (folder_ / "report.json") +
                            " --output " + (folder_ / "scene.ply")),
      0)
      << log();
  for (const auto& point : scan_cell_common::load_cloud(folder_ / "scene.ply"))
    ASSERT_NEAR(drawn::moved().inverse(point.getVector3fMap().cast<double>()).z(), 0, 1e-6);
}

TEST_F(DeviationsCommand, ItsSceneReadsPathsThatAreRobotPrograms) {
  folder_.save("part.src", std::string("DEF part ( )\nBAS (#INITMOV,0 )\n$VEL.CP=0.05\n"
                                       "PTP {X 10,Y 0,Z 0,A 0,B 0,C 180}\n"
                                       "LIN {X 10,Y 0,Z 0,A 0,B 0,C 180}\n"
                                       "LIN {X 20,Y 0,Z 0,A 0,B 0,C 180}\n"
                                       "LIN {X 30,Y 10,Z 5,A 0,B 0,C 180}\nEND\n"));
  ASSERT_EQ(run(REPORT_SCENE,
                "paths --path " + (folder_ / "part.src") + " --output " + (folder_ / "paths.json")),
            0)
      << log();
  const auto paths = nlohmann::json::parse(scan_cell_common::read_file(folder_ / "paths.json"));
  const auto& reference = paths["reference"];
  ASSERT_GE(reference.size(), 3U);
  EXPECT_NEAR(reference.front()[0].get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(reference.back()[0].get<double>(), 0.03, 1e-12);
  EXPECT_NEAR(reference.back()[1].get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(reference.back()[2].get<double>(), 0.005, 1e-12);
}
