// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scan_calibration/observations.h"
#include "scan_cell_common/errors/errors.h"
#include "session/rendered_session.h"
#include "tecnogamma_camera/grey_image_file.h"
#include "tecnogamma_camera/peak_detector.h"
#include "tecnogamma_camera/peak_file.h"

namespace fs = std::filesystem;
using namespace scan_calibration;

namespace {

/// A rendered session of eight views in a folder, spoilt by each test in its way.
class ReadSession : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    fs::remove_all(original());
    record(example_session(8), original());
  }
  static void TearDownTestSuite() { fs::remove_all(original()); }

  void SetUp() override { fs::copy(original(), folder_, fs::copy_options::recursive); }
  void TearDown() override { fs::remove_all(folder_); }

  static fs::path original() {
    return fs::temp_directory_path() / ("observe_original_" + std::to_string(getpid()));
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::ifstream in(path(file));
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(path(file)) << text.replace(at, from.size(), to);
  }

  Observations read() const { return observe(load_session(folder_)); }

  std::string complaint() const {
    try {
      read();
    } catch (const scan_cell_common::Error& error) {
      return error.what();
    }
    return "nothing";
  }

  static std::string reason(const Observations& seen, const std::string& view,
                            const std::string& laser) {
    for (const RejectedView& rejected : seen.rejected)
      if (rejected.name == view && rejected.laser == laser) return rejected.reason;
    return "nothing";
  }

  const RenderedSession session_ = example_session(8);
  const fs::path folder_ = fs::temp_directory_path() / ("observe_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(ReadSession, ShowsEveryCornerAndBothLines) {
  const Observations seen = read();
  EXPECT_EQ(seen.width, 640);
  EXPECT_EQ(seen.height, 480);
  ASSERT_EQ(seen.views.size(), 8U);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < seen.views.size(); ++i) {
    const ViewObservation& view = seen.views[i];
    EXPECT_EQ(view.corners.size(), 54U) << view.name;
    for (const SeenCorner& corner : view.corners) {
      sum += (corner.pixel - true_corner(session_.truth.camera, session_.boards_in_camera[i],
                                         session_.board, corner.column, corner.row))
                 .squaredNorm();
      count += 2;
    }
    ASSERT_EQ(view.lines.size(), 2U);
    EXPECT_TRUE(view.base_to_flange.isApprox(session_.base_to_flange(i), 1e-12));
  }
  EXPECT_LT(std::sqrt(sum / count), 0.03);
  int lines = 0;
  for (const ViewObservation& view : seen.views)
    for (const auto& line : view.lines)
      lines += line.empty() ? 0 : 1;
  EXPECT_GE(lines, 14);
}

TEST_F(ReadSession, DoesNotDependOnTheNumberOfThreads) {
  ObservationOptions options;
  int told = 0;
  options.progress = [&](const std::string&, int, int) { ++told; };
  options.threads = 1;
  const Observations one = observe(load_session(folder_), options);
  EXPECT_EQ(told, 16);
  options.threads = 3;
  const Observations three = observe(load_session(folder_), options);
  ASSERT_EQ(one.views.size(), three.views.size());
  for (std::size_t i = 0; i < one.views.size(); ++i) {
    EXPECT_EQ(one.views[i].lines, three.views[i].lines);
    for (std::size_t k = 0; k < one.views[i].corners.size(); ++k)
      EXPECT_EQ(one.views[i].corners[k].pixel, three.views[i].corners[k].pixel);
  }
}

TEST_F(ReadSession, TakesPeaksWhereAnImageWasNotKept) {
  const Observations from_images = read();
  const cv::Mat image = tecnogamma_camera::load_grey_image(path("images/laser_0_0001.png"));
  tecnogamma_camera::PeakProfile profile;
  tecnogamma_camera::make_detector("fir_derivative", {})
      ->detect(tecnogamma_camera::grey_view(image), profile);
  tecnogamma_camera::save_peaks(path("images/laser_0_0001.csv"), profile);
  replace("poses.csv", "images/laser_0_0001.png", "images/laser_0_0001.csv");
  const Observations seen = read();
  ASSERT_FALSE(seen.views[0].lines[0].empty());
  EXPECT_NEAR(static_cast<double>(seen.views[0].lines[0].size()),
              static_cast<double>(from_images.views[0].lines[0].size()),
              0.1 * static_cast<double>(from_images.views[0].lines[0].size()));
}

TEST_F(ReadSession, LeavesOutWhatCannotBeReadAndSaysWhy) {
  fs::resize_file(path("images/board_0002.png"), 5000);
  cv::imwrite(path("images/board_0003.png"), cv::Mat(100, 100, CV_8UC1, cv::Scalar(9)));
  cv::imwrite(path("images/board_0004.png"), cv::Mat(480, 640, CV_8UC1, cv::Scalar(9)));
  fs::resize_file(path("images/laser_0_0005.png"), 5000);
  cv::imwrite(path("images/laser_1_0005.png"), cv::Mat(100, 100, CV_8UC1, cv::Scalar(9)));
  const Observations seen = read();
  EXPECT_EQ(seen.views.size(), 5U);
  EXPECT_NE(reason(seen, "images/board_0002.png", "").find("truncated"), std::string::npos);
  EXPECT_EQ(reason(seen, "images/board_0003.png", ""),
            "the image has 100 x 100 pixels, most have 640 x 480");
  EXPECT_EQ(reason(seen, "images/board_0004.png", ""), "the board is not seen");
  EXPECT_NE(reason(seen, "images/board_0005.png", "laser_0").find("truncated"), std::string::npos);
  EXPECT_NE(reason(seen, "images/board_0005.png", "laser_1").find("give the whole sensor"),
            std::string::npos);
}

TEST_F(ReadSession, LeavesOutAViewWhosePoseIsThatOfAnother) {
  std::ifstream in(path("poses.csv"));
  std::string text, line, pose;
  while (std::getline(in, line)) {
    const std::size_t begin = line.find(','), end = line.find(",images/laser");
    if (line.find("board_0003") != std::string::npos) pose = line.substr(begin, end - begin);
    if (line.find("board_0004") != std::string::npos) line.replace(begin, end - begin, pose);
    text += line + "\n";
  }
  std::ofstream(path("poses.csv")) << text;
  const Observations seen = read();
  EXPECT_EQ(seen.views.size(), 7U);
  EXPECT_EQ(reason(seen, "images/board_0004.png", ""), "repeats the pose of images/board_0003.png");
}

TEST_F(ReadSession, SaysWhichBoardIsThereWhereAnotherWasGiven) {
  for (const char* wrong : {"[10, 7]", "[8, 5]"}) {
    fs::remove_all(folder_);
    SetUp();
    replace("session.yaml", "[9, 6]", wrong);
    EXPECT_NE(complaint().find("the images show one of 9 x 6; correct inner_corners"),
              std::string::npos)
        << wrong << ": " << complaint();
  }
}

TEST_F(ReadSession, SaysThatNoImageShowsABoard) {
  for (const auto& entry : fs::directory_iterator(path("images")))
    cv::imwrite(entry.path().string(), cv::Mat(480, 640, CV_8UC1, cv::Scalar(9)));
  EXPECT_EQ(complaint(),
            "board of 9 x 6 inner corners: seen in none of 8 images, the first: the board is not "
            "seen; show the whole board, in focus and well lit");
}

TEST_F(ReadSession, RefusesADetectorThatThereIsNot) {
  ObservationOptions options;
  options.detector = "eye";
  EXPECT_THROW(observe(load_session(folder_), options), scan_cell_common::InvalidParameter);
}

TEST(ReadSessionWithTheLineInTheBoardImage, LeavesOutCornersUnderTheLine) {
  const fs::path folder =
      fs::temp_directory_path() / ("observe_one_image_" + std::to_string(getpid()));
  const RenderedSession session = example_session(8);
  record(session, folder, true);
  const Observations seen = observe(load_session(folder));
  EXPECT_GE(seen.views.size(), 6U);
  int covered = 0;
  for (const ViewObservation& view : seen.views) {
    covered += view.covered_corners;
    const std::size_t index = std::stoul(view.name.substr(view.name.find("board_") + 6)) - 1;
    for (const SeenCorner& corner : view.corners) {
      EXPECT_LT((corner.pixel - true_corner(session.truth.camera, session.boards_in_camera[index],
                                            session.board, corner.column, corner.row))
                    .norm(),
                0.4)
          << view.name << " " << corner.column << " " << corner.row;
    }
  }
  EXPECT_GT(covered, 10);
  fs::remove_all(folder);
}
