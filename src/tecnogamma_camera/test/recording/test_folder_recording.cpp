// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "recording/folder_recording.h"

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;
using tecnogamma_camera::open_folder_recording;
using tecnogamma_camera::Region;

namespace {

class FolderRecording : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// An image of 12 x 7 of one grey value.
  void image(const std::string& name, int grey) const {
    cv::imwrite((folder_ / name).string(), cv::Mat(7, 12, CV_8UC1, cv::Scalar(grey)));
  }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  auto open() const { return open_folder_recording(folder_.string()); }

  std::string refusal() const {
    try {
      open();
    } catch (const UnusableInput& error) {
      return error.what();
    } catch (const FileError& error) {
      return error.what();
    }
    return "nothing";
  }

  fs::path folder_ = fs::temp_directory_path() / ("recording_" + std::to_string(getpid()));
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(FolderRecording, WithoutAnIndexComesInTheOrderOfTheNumbersInItsNames) {
  image("scan_10.png", 10);
  image("scan_9.pgm", 9);
  image("scan_0011.tif", 11);
  file("notes.txt", "no image");
  const auto recording = open();
  for (int i = 9; i <= 11; ++i) {
    const auto frame = recording->next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->counter, static_cast<std::uint64_t>(i - 8));
    EXPECT_EQ(frame->image.as<std::uint8_t>().row(6)[11], i);
    EXPECT_EQ(frame->device_time, 0);
  }
  EXPECT_FALSE(recording->next());
  recording->rewind();
  EXPECT_EQ(recording->next()->counter, 1U);
  EXPECT_EQ(recording->describe().sensor_columns, 12);
}

TEST_F(FolderRecording, TakesNumbersTimesAndPlaceFromTheIndex) {
  fs::create_directories(folder_ / "below");
  image("b.png", 20);
  image("below/a.png", 10);
  image("not_named.png", 99);
  file(
      "index.csv",
      "frame,file,device_time,time,packets_lost,first_column,first_row,sensor_columns,sensor_rows\n"
      "65534, below/a.png ,1000,1700000000000000001,0,64,32,2048,1088\r\n"
      "\n"
      "65537,never.png,,,4,64,32,2048,1088\n"
      "65538,b.png,3000,1700000000000002001,,64,32,2048,1088\n");
  const auto recording = open();
  const auto first = recording->next();
  EXPECT_EQ(first->counter, 65534U);
  EXPECT_EQ(first->device_time, 1000);
  EXPECT_EQ(first->time, 1700000000000000001);
  EXPECT_EQ(first->image.first_column, 64);
  EXPECT_EQ(first->image.first_row, 32);
  EXPECT_EQ(first->image.as<std::uint8_t>().row(0)[0], 10);
  const auto torn = recording->next();
  EXPECT_EQ(torn->packets_lost, 4U);
  EXPECT_EQ(torn->image.pixels, nullptr);
  EXPECT_EQ(torn->image.rows, 7);
  EXPECT_EQ(recording->next()->image.as<std::uint8_t>().row(0)[0], 20);
  EXPECT_FALSE(recording->next());
  EXPECT_EQ(recording->describe().region, (Region{64, 32, 12, 7}));
  EXPECT_EQ(recording->describe().sensor_columns, 2048);
}

TEST_F(FolderRecording, NamesTheLineOfTheIndexThatIsBad) {
  image("a.png", 1);
  const auto says = [this](const std::string& index, const std::string& part) {
    file("index.csv", index);
    EXPECT_TRUE(holds(refusal(), part)) << refusal();
  };
  says("", "names no files");
  says("file,frame\n", "names no files");
  says("file,number\na.png,1\n", "index.csv: line 1: column 'number'");
  says("frame,packets_lost\n1,0\n", "no column 'file'");
  says("file,frame,file\na.png,1,a.png\n", "twice");
  says("file,frame\na.png\n", "index.csv: line 2: 1 values");
  says("file,frame\na.png,1\na.png,-2\n", "index.csv: line 3: frame '-2'");
  says("file,frame\na.png,\n", "no frame number");
  says("file,frame,packets_lost\na.png,1,4294967296\n", "packets_lost '4294967296'");
  says("file,frame,time\na.png,1,1e9\n", "time '1e9'");
  says("file,frame\n/etc/passwd,1\n", "folder, or below");
  says("file,frame\n../a.png,1\n", "folder, or below");
  says("file,frame\nb.png,1\n", "b.png: no such file");
  says("file,frame,first_row\na.png,1,10\na.png,2,11\n", "first_row 11 after 10");
  says("file,frame,first_row,sensor_rows\na.png,1,10,16\n", "beyond the sensor");
}

TEST_F(FolderRecording, MakesAFaultOfAnImageThatCannotBeUsedAndGoesOn) {
  image("1.png", 1);
  file("2.png", "no image");
  cv::imwrite((folder_ / "3.png").string(), cv::Mat(7, 12, CV_8UC3, cv::Scalar(0, 0, 9)));
  cv::imwrite((folder_ / "4.png").string(), cv::Mat(7, 13, CV_8UC1, cv::Scalar(9)));
  image("5.png", 5);
  fs::resize_file(folder_ / "5.png", 40);  // cut off
  image("6.png", 6);
  const auto recording = open();
  EXPECT_EQ(recording->next()->fault, "");
  for (const std::string part : {"2.png", "8UC3", "13 x 7", "5.png"}) {
    const auto frame = recording->next();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(holds(frame->fault, part)) << frame->fault;
    EXPECT_EQ(frame->image.pixels, nullptr);
  }
  EXPECT_EQ(recording->next()->image.as<std::uint8_t>().row(3)[3], 6);
}

TEST_F(FolderRecording, KeepsSixteenBitsAsTheyAre) {
  cv::Mat pixels(7, 12, CV_16UC1, cv::Scalar(4095));
  pixels.at<std::uint16_t>(6, 11) = 65535;
  pixels.at<std::uint16_t>(0, 1) = 258;
  for (const std::string extension : {"png", "pgm", "tif"})
    cv::imwrite((folder_ / ("deep." + extension)).string(), pixels);
  image("shallow.png", 1);
  const auto recording = open();
  EXPECT_EQ(recording->describe().grey_bits, 16);
  for (int i = 0; i < 3; ++i) {
    const auto frame = recording->next();
    ASSERT_EQ(frame->fault, "");
    const auto view = frame->image.as<std::uint16_t>();
    EXPECT_EQ(view.row(0)[0], 4095);
    EXPECT_EQ(view.row(0)[1], 258);
    EXPECT_EQ(view.row(6)[11], 65535);
  }
  EXPECT_TRUE(holds(recording->next()->fault, "12 x 7 CV_8UC1"));
}

TEST_F(FolderRecording, RefusesAFolderThatIsNotThereOrHoldsNoImages) {
  EXPECT_TRUE(holds(refusal(), "holds no images"));
  EXPECT_THROW(open_folder_recording((folder_ / "not_there").string()), FileError);
  file("1.png", "no image");
  EXPECT_TRUE(holds(refusal(), "1.png"));
}

TEST_F(FolderRecording, HandsOutTheBytesOfPayloadsAsTheyCame) {
  file("1.bin", std::string("\0\x01\xFF", 3));
  file("2.bin", "");
  file("3.bin", "longer than the first");
  const auto recording = open();
  const auto frame = recording->next();
  EXPECT_EQ(frame->image.columns, 3);
  EXPECT_EQ(frame->image.rows, 1);
  EXPECT_EQ(frame->image.as<std::uint8_t>().row(0)[2], 255);
  EXPECT_EQ(recording->next()->image.columns, 0);
  EXPECT_EQ(recording->next()->image.columns, 21);
}
