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

#include "scan_cell_common/cloud_files.h"

namespace fs = std::filesystem;

namespace {

constexpr int kWordsHigh = 90;  // rows of the picture that hold words

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

  void write_report(const std::string& verdict, const std::vector<int>& waypoints,
                    const nlohmann::json& candidates = nlohmann::json::array()) const {
    const nlohmann::json report = {{"verdict", verdict},
                                   {"reason", verdict == "accepted" ? verdict : "path_not_scanned"},
                                   {"message", "what the stretcher says"},
                                   {"waypoints_concerned", waypoints},
                                   {"candidates", candidates},
                                   {"inlier_ratio", 1},
                                   {"transform", kIdentity}};
    std::ofstream(file("report.json")) << report;
  }

  int run() const {
    const std::string command = std::string(PICTURE_COMMAND) + " --reference " + file("plate.ply") +
                                " --object " + file("plate.ply") + " --path " + file("path.csv") +
                                " --report " + file("report.json") + " --output " +
                                file("picture.png") + " > /dev/null 2> " + file("stderr");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Pixels below the words.
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
