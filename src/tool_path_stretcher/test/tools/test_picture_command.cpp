// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "report.h"
#include "scan_cell_common/clouds/cloud_files.h"

namespace fs = std::filesystem;

namespace {

constexpr int kWordsHigh = 90;  // rows of the picture with text

const nlohmann::json kIdentity = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
const nlohmann::json kHalfATurn = {
    {-1, 0, 0, 0.295}, {0, -1, 0, 0.195}, {0, 0, 1, 0}, {0, 0, 0, 1}};

class PictureCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("picture_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    scan_cell_common::Cloud plate;
    for (int i = 0; i < 60; ++i) {
      for (int j = 0; j < 40; ++j)
        plate.push_back({0.005F * static_cast<float>(i), 0.005F * static_cast<float>(j), 0});
    }
    scan_cell_common::save_cloud(file("plate.ply"), plate);
    std::ofstream(file("path.csv")) << "x,y,z\n0.1,0.05,0\n0.1,0.1,0\n0.2,0.1,0\n";
  }

  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a report like the action's: without files.
  void write_report(const std::string& verdict, const std::vector<int>& waypoints,
                    const nlohmann::json& candidates = nlohmann::json::array()) const {
    save_report(report_of(verdict, waypoints, candidates));
  }

  nlohmann::json report_of(const std::string& verdict, const std::vector<int>& waypoints,
                           const nlohmann::json& candidates = nlohmann::json::array()) const {
    const nlohmann::json none;
    nlohmann::json report = {{"verdict", verdict},
                             {"reason", verdict == "accepted" ? verdict : "path_not_scanned"},
                             {"message", "what the stretcher says"},
                             {"waypoints_concerned", waypoints},
                             {"candidates", candidates},
                             {"inlier_ratio", 1},
                             {"reference_points", none},
                             {"object_points", none},
                             {"transform", kIdentity}};
    report["files"] = {{"reference", none}, {"object", none}, {"path", none}, {"output", none}};
    report["path"] = {{"waypoints", 3}};
    report["quality"] = nlohmann::json::array();
    for (int i = 0; i < 3; ++i)
      report["quality"].push_back({{"displacement", 0}});
    return report;
  }

  void save_report(const nlohmann::json& report) const {
    std::ofstream(file("report.json")) << report;
  }

  int run(const std::string& more = "") const {
    fs::remove(file("picture.png"));
    const std::string command =
        std::string(PICTURE_COMMAND) + " --reference " + file("plate.ply") + " --object " +
        file("plate.ply") + " --path " + file("path.csv") + " --report " + file("report.json") +
        " --output " + file("picture.png") + " " + more + " > /dev/null 2> " + file("stderr");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string complaint() const {
    std::ifstream in(file("stderr"));
    return std::string((std::istreambuf_iterator<char>(in)), {});
  }

  nlohmann::json record_of(const std::string& name) const {
    const auto record = tool_path_stretcher::record_of(file(name), "m");
    return {{"name", record.name}, {"sha256", record.sha256}, {"units", record.units}};
  }

  /// Counts pixels below the text.
  /// @param is_so of blue, green, red
  template <class Is>
  int count_pixels(const Is& is_so) const {
    const cv::Mat picture = cv::imread(file("picture.png"));
    int count = 0;
    for (int row = kWordsHigh; row < picture.rows; ++row) {
      for (int column = 0; column < picture.cols; ++column) {
        const auto& pixel = picture.at<cv::Vec3b>(row, column);
        count += is_so(pixel[0], pixel[1], pixel[2]);
      }
    }
    return count;
  }

  int count_red() const {
    return count_pixels([](int b, int g, int r) { return r > 200 && g < 80 && b < 80; });
  }

  /// [px] from the leftmost to the rightmost red pixel.
  int breadth_of_red() const {
    const cv::Mat picture = cv::imread(file("picture.png"));
    cv::Mat red;
    cv::inRange(picture.rowRange(kWordsHigh, picture.rows), cv::Scalar(0, 0, 201),
                cv::Scalar(79, 79, 255), red);
    return cv::boundingRect(red).width;
  }

  int count_orange() const {
    return count_pixels(
        [](int b, int g, int r) { return r > 200 && g > 100 && g < 180 && b < 80; });
  }

  fs::path folder_;
};

}  // namespace

TEST_F(PictureCommand, ShowsTheWaypointsThatTheVerdictNamesOnBothParts) {
  write_report("accepted", {});
  ASSERT_EQ(run(), 0);
  EXPECT_EQ(count_red(), 0);
  write_report("refused", {1});
  ASSERT_EQ(run(), 0);
  const int one = count_red();
  EXPECT_GT(one, 20);
  write_report("refused", {0, 1, 2});
  ASSERT_EQ(run(), 0);
  EXPECT_NEAR(count_red(), 3 * one, one);
}

TEST_F(PictureCommand, LaysTheReferenceOverTheObject) {
  nlohmann::json report = report_of("refused", {1});
  save_report(report);
  ASSERT_EQ(run(), 0);
  EXPECT_GT(breadth_of_red(), 200);  // one waypoint on each part
  ASSERT_EQ(run("--overlay"), 0) << complaint();
  EXPECT_GT(breadth_of_red(), 3);
  EXPECT_LT(breadth_of_red(), 20);  // at one place
  report["transform"] = nullptr;
  save_report(report);
  EXPECT_EQ(run("--overlay"), 1);
  EXPECT_NE(complaint().find("no pose was found"), std::string::npos) << complaint();
}

TEST_F(PictureCommand, ShowsThePathsOfBothPosesOfAnAmbiguousVerdict) {
  const nlohmann::json as_it_is = nlohmann::json::object({{"transform", kIdentity}});
  const nlohmann::json turned = nlohmann::json::object({{"transform", kHalfATurn}});
  write_report("refused", {}, nlohmann::json::array({as_it_is}));
  ASSERT_EQ(run(), 0);
  EXPECT_EQ(count_orange(), 0);
  write_report("refused", {}, nlohmann::json::array({as_it_is, turned}));
  ASSERT_EQ(run(), 0);
  EXPECT_GT(count_orange(), 20);
}

TEST_F(PictureCommand, RefusesWhatIsNoReport) {
  std::ofstream(file("report.json")) << "x,y,z\n";
  EXPECT_EQ(run(), 1);
  std::ofstream(file("report.json")) << R"({"verdict": "accepted"})";
  EXPECT_EQ(run(), 1);
  EXPECT_FALSE(fs::exists(file("picture.png")));
}

TEST_F(PictureCommand, ShowsTheFilesOfTheRunThatWroteTheReport) {
  fs::copy_file(file("path.csv"), file("adapted.csv"));
  nlohmann::json report = report_of("accepted", {});
  report["files"] = {{"reference", record_of("plate.ply")},
                     {"object", record_of("plate.ply")},
                     {"path", record_of("path.csv")},
                     {"output", record_of("adapted.csv")}};
  save_report(report);
  EXPECT_EQ(run("--adapted " + file("adapted.csv")), 0) << complaint();
  std::ofstream(file("other.csv")) << "x,y,z\n0.1,0.05,0\n0.1,0.1,0\n0.2,0.11,0\n";
  EXPECT_EQ(run("--adapted " + file("other.csv")), 1);
  EXPECT_NE(complaint().find("other.csv: not the adapted path of the report"), std::string::npos)
      << complaint();
  EXPECT_FALSE(fs::exists(file("picture.png")));
  for (const char* const role : {"reference", "object", "path"}) {
    nlohmann::json other = report;
    other["files"][role] = record_of("other.csv");
    save_report(other);
    EXPECT_EQ(run(), 1) << role;
    EXPECT_NE(complaint().find(std::string(role) + " of the report"), std::string::npos) << role;
    EXPECT_FALSE(fs::exists(file("picture.png"))) << role;
  }
}

TEST_F(PictureCommand, RefusesWhatDoesNotFitTheFiguresOfAReportWithoutFiles) {
  const nlohmann::json report = report_of("accepted", {});
  save_report(report);
  EXPECT_EQ(run("--adapted " + file("path.csv")), 0) << complaint();
  std::ofstream(file("moved.csv")) << "x,y,z\n0.1,0.05,0\n0.1,0.105,0\n0.2,0.1,0\n";
  EXPECT_EQ(run("--adapted " + file("moved.csv")), 1);
  EXPECT_NE(complaint().find("waypoint 1 lies 5 mm"), std::string::npos) << complaint();
  std::ofstream(file("short.csv")) << "x,y,z\n0.1,0.05,0\n";
  EXPECT_EQ(run("--adapted " + file("short.csv")), 1);
  for (const char* const figure : {"reference_points", "object_points"}) {
    nlohmann::json other = report;
    other[figure] = 17;
    save_report(other);
    EXPECT_EQ(run(), 1) << figure;
    EXPECT_NE(complaint().find("17 in the report"), std::string::npos) << complaint();
  }
  nlohmann::json longer = report;
  longer["path"]["waypoints"] = 4;
  save_report(longer);
  EXPECT_EQ(run(), 1);
}

TEST_F(PictureCommand, RefusesAnAdaptedPathBesideARefusal) {
  write_report("refused", {1});
  EXPECT_EQ(run("--adapted " + file("path.csv")), 1);
  EXPECT_NE(complaint().find("the report is of a refused one"), std::string::npos) << complaint();
}

TEST_F(PictureCommand, RefusesABadEndingBeforeTheWork) {
  const std::string command = std::string(PICTURE_COMMAND) +
                              " --reference no.ply --object no.ply --path no.csv --report no.json"
                              " --output " +
                              file("picture.txt") + " 2> " + file("stderr");
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(complaint().find("extension '.txt'"), std::string::npos) << complaint();
}
