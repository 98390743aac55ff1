// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "peaks/stripes.h"

namespace fs = std::filesystem;

namespace {

class ExtractPeaks : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// @return the exit code
  int run(const std::string& options) const {
    const std::string command = std::string(EXTRACT_PEAKS) + " --image " + image_ + " --output " +
                                output_ + " " + options + " > " + (folder_ / "log").string() +
                                " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string log() const {
    std::ifstream file(folder_ / "log");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_ = fs::temp_directory_path() / ("peaks_" + std::to_string(getpid()));
  std::string image_ = (folder_ / "line.png").string();
  std::string output_ = (folder_ / "peaks.csv").string();
};

void save(const std::string& path, stripes::Image& picture) {
  const auto view = picture.view();
  cv::imwrite(path,
              cv::Mat(view.rows, view.columns, CV_8UC1, const_cast<std::uint8_t*>(view.pixels)));
}

}  // namespace

TEST_F(ExtractPeaks, WritesOneLineARowWithAPeak) {
  stripes::Image picture(100, 20, 10);
  for (int row = 5; row < 20; ++row)
    picture.add(row, {40 + 0.3 * row, 1.5, 200});
  save(image_, picture);
  for (const std::string detector : {"center_of_gravity", "fir_derivative", "threshold"}) {
    ASSERT_EQ(run("--detector " + detector), 0) << log();
    std::ifstream file(output_);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "row,position,width,intensity");
    int row = 5;
    while (std::getline(file, line)) {
      double values[4];
      ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &values[0], &values[1], &values[2],
                            &values[3]),
                4);
      EXPECT_EQ(values[0], row);
      EXPECT_NEAR(values[1], 40 + 0.3 * row, 0.02);
      EXPECT_NEAR(values[2], 3.6, 0.4);
      EXPECT_GT(values[3], 180);
      ++row;
    }
    EXPECT_EQ(row, 20);
  }
}

TEST_F(ExtractPeaks, ReadsSixteenBitsAsPngTiffAndPgm) {
  cv::Mat image(3, 100, CV_16UC1, cv::Scalar(600));
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 100; ++column)
      image.at<std::uint16_t>(row, column) +=
          static_cast<std::uint16_t>(std::lround(3000 * stripes::gaussian_pixel(column, 60.3, 2)));
  for (const char* const name : {"line.png", "line.tif", "line.pgm"}) {
    image_ = (folder_ / name).string();
    cv::imwrite(image_, image);
    ASSERT_EQ(run(""), 0) << log();
    std::ifstream file(output_);
    std::string header, line;
    std::getline(file, header);
    std::getline(file, line);
    double row = -1, position = 0, width = 0, intensity = 0;
    std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &row, &position, &width, &intensity);
    EXPECT_EQ(row, 0) << name;
    EXPECT_NEAR(position, 60.3, 0.005) << name;
    EXPECT_EQ(intensity, image.at<std::uint16_t>(0, 60)) << name;
  }
}

TEST_F(ExtractPeaks, TakesGreyThatWasSavedAsColour) {
  stripes::Image picture(100, 4, 10);
  for (int row = 0; row < 4; ++row)
    picture.add(row, {40, 1.5, 200});
  const auto view = picture.view();
  const cv::Mat grey(4, 100, CV_8UC1, const_cast<std::uint8_t*>(view.pixels));
  cv::Mat colour;
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, colour);
  cv::imwrite(image_, colour);
  EXPECT_EQ(run(""), 0) << log();
  EXPECT_NE(log().find("4 peaks in 4 rows"), std::string::npos) << log();
}

TEST_F(ExtractPeaks, TakesTheSpotThatIsChosen) {
  stripes::Image picture(100, 1, 10);
  picture.add(0, {20, 1.5, 100});
  picture.add(0, {70, 1.5, 200});
  save(image_, picture);
  for (const auto& [choice, position] :
       {std::pair{"brightest", "0,70.0"}, {"first", "0,20.0"}, {"last", "0,70.0"}}) {
    ASSERT_EQ(run(std::string("--choice ") + choice), 0) << log();
    std::ifstream file(output_);
    std::string line;
    std::getline(file, line);
    std::getline(file, line);
    EXPECT_EQ(line.substr(0, 6), position) << choice;
  }
}

TEST_F(ExtractPeaks, NamesTheFileOrSettingThatIsUnusable) {
  EXPECT_EQ(run(""), 1);
  EXPECT_NE(log().find(image_), std::string::npos);
  std::ofstream(image_) << "no image";
  EXPECT_EQ(run(""), 1);
  EXPECT_NE(log().find(image_), std::string::npos);
  cv::imwrite(image_, cv::Mat(10, 10, CV_8UC3, cv::Scalar(0, 0, 200)));
  EXPECT_EQ(run(""), 1);
  EXPECT_NE(log().find("8UC3"), std::string::npos);
  cv::imwrite(image_, cv::Mat(10, 10, CV_8UC1, cv::Scalar(0)));
  EXPECT_EQ(run("--detector parabola"), 1);
  EXPECT_NE(log().find("parabola"), std::string::npos);
  EXPECT_EQ(run("--trigger-level 300"), 1);
  EXPECT_NE(log().find("trigger_level"), std::string::npos);
  EXPECT_NE(log().find("255"), std::string::npos);
  EXPECT_EQ(run("--most-width 9"), 1);
  EXPECT_NE(log().find("--most-width: renamed; use --max-width"), std::string::npos);
  EXPECT_EQ(run("--choice darkest"), 1);
  EXPECT_NE(log().find("darkest"), std::string::npos);
  EXPECT_FALSE(fs::exists(output_));
}

TEST_F(ExtractPeaks, LeavesNothingBehindWhereTheOutputCannotBeWritten) {
  cv::imwrite(image_, cv::Mat(10, 10, CV_8UC1, cv::Scalar(0)));
  fs::create_directories(output_);  // a folder in the file's place
  EXPECT_EQ(run(""), 1);
  EXPECT_NE(log().find(output_), std::string::npos);
  EXPECT_FALSE(fs::exists(output_ + ".partial"));
}
