// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "client/bag_replay.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;

using scan_cell_msgs::CellState;

namespace {

class BagReplay : public testing::Test {
 protected:
  void SetUp() override { bag_.open(path_, rosbag::bagmode::Write); }
  void TearDown() override { fs::remove(path_); }

  /// Records a second of a cell with three pulses, ended by this state.
  void record(const std::string& scan_id, std::uint8_t end) {
    write_state(scan_id, CellState::SCANNING);
    for (int i = 0; i < 3; ++i) {
      now_ += ros::Duration(0.2);
      bag_.write("/laser_trigger/events", now_, scan_cell_msgs::TriggerEvent());
      bag_.write("/camera/profiles", now_, scan_cell_msgs::PeakProfile());
      bag_.write("/tf", now_, tf2_msgs::TFMessage());
    }
    now_ += ros::Duration(0.4);
    write_state(scan_id, end);
    now_ += ros::Duration(1);
  }

  scan_cell::RecordedScan chosen(const std::string& scan_id) {
    bag_.close();
    const scan_cell::BagReplay replay(path_, scan_id, {});
    EXPECT_EQ(replay.pulses(), 3U);
    return replay.scan();
  }

  /// Changes a string's length in a message to one that no bag holds.
  void lengthen(const std::string& text) {
    bag_.close();
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t at = bytes.find(std::string{static_cast<char>(text.size()), 0, 0, 0} + text);
    ASSERT_NE(at, std::string::npos);
    file.clear();
    file.seekp(static_cast<std::streamoff>(at));
    file << '\xff' << '\xff' << '\xff' << '\x7f';
  }

  const std::string& path() const { return path_; }

 private:
  void write_state(const std::string& scan_id, std::uint8_t state) {
    CellState message;
    message.scan_id = scan_id;
    message.state = state;
    bag_.write("/scan_cell/state", now_, message);
  }

  std::string path_ =
      (fs::temp_directory_path() / ("replay_" + std::to_string(getpid()) + ".bag")).string();
  rosbag::Bag bag_;
  ros::Time now_{1000};
};

}  // namespace

TEST_F(BagReplay, TakesTheLastWholeScan) {
  record("first", CellState::FINISHED);
  record("second", CellState::FINISHED);
  record("cancelled", CellState::FAILED);
  const scan_cell::RecordedScan scan = chosen("");
  EXPECT_EQ(scan.scan_id, "second");
  EXPECT_TRUE(scan.whole);
  EXPECT_EQ(scan.start, ros::Time(1002));
  EXPECT_EQ(scan.end, ros::Time(1003));
}

TEST_F(BagReplay, TakesAScanThatEndedEarlyOnlyByItsName) {
  record("first", CellState::FINISHED);
  record("cancelled", CellState::FAILED);
  const scan_cell::RecordedScan scan = chosen("cancelled");
  EXPECT_EQ(scan.scan_id, "cancelled");
  EXPECT_FALSE(scan.whole);
}

TEST_F(BagReplay, RefusesABagWithoutAWholeScanAndNamesTheOthers) {
  record("cancelled", CellState::FAILED);
  try {
    chosen("");
    FAIL() << "taken";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(error.value(), "no whole scan");
    EXPECT_EQ(error.cure(), "give a scan_id of 'cancelled' (ended early)");
  }
}

TEST_F(BagReplay, NamesABagThatIsDamaged) {
  record("first", CellState::FINISHED);
  lengthen("first");
  try {
    chosen("");
    FAIL() << "taken";
  } catch (const scan_cell_common::FileError& error) {
    EXPECT_EQ(error.thing(), path());
    EXPECT_EQ(error.value(), "Buffer Overrun");
    EXPECT_NE(error.cure(), "");
  }
}
