// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <XmlRpcValue.h>
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/BindingAudit.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "recorded_scan.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_demo/comparison.h"
#include "scan_cell_sim/ground_truth.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;

namespace {

std::string config(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

/// The clean cloud's points have the bag's pass, whatever the trigger's armings.
void expect_all_of_pass(int pass, const std::string& file) {
  scan_cell_common::FieldedCloud cloud;
  scan_cell_common::load_cloud_file(file, {}, cloud);
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [](const auto& each) { return each.name == "pass"; });
  ASSERT_NE(field, cloud.fields.end());
  ASSERT_GT(cloud.size(), 1000U);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ(cloud.bytes[i * cloud.step + field->offset], pass) << i;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Replay : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    path_ = scan_cell_demo::proven_path(config("reference_frame.yaml"), "frame");
    tool_paths::save_tool_path(path("path.csv"), path_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// @return exit code of the replay node
  int replay(const std::string& bag, const std::string& reference, const std::string& output,
             const std::string& more = "") const {
    const std::string command = "rosrun scan_cell replay _bag:=" + bag +
                                " _reference:=" + reference + " _path:=" + path("path.csv") +
                                " _output:=" + output + " _speed:=8 _timeout:=90" + more;
    return WEXITSTATUS(std::system(command.c_str()));
  }

  void save_sampled_reference() const {
    scan_cell_common::Cloud sampled;
    const scan_cell_sim::Scene scene(scan_cell_sim::load_world(config("reference_frame.yaml")),
                                     "frame");
    for (const Eigen::Vector3d& point : scan_cell_sim::sample(scene, 60000, 1, 5e-5)) {
      sampled.push_back(pcl::PointXYZ(static_cast<float>(point.x()), static_cast<float>(point.y()),
                                      static_cast<float>(point.z())));
    }
    scan_cell_common::save_cloud(path("sampled.ply"), sampled);
  }

  /// Clean cloud of the reference, scanned like the object: replay leaves it beside its path.
  std::string scan_reference() const {
    scan_cell_demo::record_scan(path("reference.bag"), "reference", config("reference_frame.yaml"),
                                1.7e9);
    save_sampled_reference();
    replay(path("reference.bag"), path("sampled.ply"), path("reference"));
    return path("reference/object.ply");
  }

  fs::path folder_ = fs::temp_directory_path() / ("replay_" + std::to_string(getpid()));
  tool_path_stretcher::ToolPath path_;
};

}  // namespace

TEST_F(Replay, GivesTheTruePath) {
  const std::string reference = scan_reference();
  scan_cell_demo::record_scan(path("scan.bag"), "recorded", config("scaled_frame.yaml"),
                              1.7e9 + 1000);
  ASSERT_EQ(replay(path("scan.bag"), reference, path("first")), 0);
  const auto truth = scan_cell_demo::true_path(path_, config("reference_frame.yaml"),
                                               config("scaled_frame.yaml"), "frame");
  const auto error =
      scan_cell_demo::compare(tool_paths::load_tool_path(path("first/adapted_path.csv")), truth);
  EXPECT_LE(error.rms, 1.0e-3);
  expect_all_of_pass(3, path("first/object.ply"));
}

TEST_F(Replay, TakesNoLatchedCloudOfAnEarlierReplayForItsOwn) {
  scan_cell_demo::record_scan(path("scan.bag"), "again", config("scaled_frame.yaml"), 1.7e9 + 2000);
  scan_cell_demo::record_scan(path("other.bag"), "again", config("reference_frame.yaml"),
                              1.7e9 + 2000);
  save_sampled_reference();
  replay(path("other.bag"), path("sampled.ply"), path("other"));
  replay(path("scan.bag"), path("sampled.ply"), path("scan"));
  const std::string other = bytes_of(folder_ / "other/object.ply");
  const std::string scan = bytes_of(folder_ / "scan/object.ply");
  ASSERT_FALSE(other.empty());
  ASSERT_FALSE(scan.empty());
  EXPECT_FALSE(scan == other) << "two parts, scanned at the same time by the bags' clock";
}

TEST_F(Replay, EndsWithAnErrorWhereTheBagHoldsNoScan) {
  std::ofstream(path("text.bag")) << "no bag";
  rosbag::Bag(path("empty.bag"), rosbag::bagmode::Write).close();
  const auto complaint = [this](const std::string& bag) {
    EXPECT_EQ(replay(path(bag), path("reference.ply"), path("out"), " 2> " + path("stderr")), 1);
    return bytes_of(path("stderr"));
  };
  EXPECT_NE(complaint("text.bag").find("text.bag"), std::string::npos);
  EXPECT_NE(complaint("missing.bag").find("missing.bag"), std::string::npos);
  EXPECT_NE(complaint("empty.bag").find("empty.bag: no whole scan"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out/adapted_path.csv")));
}

TEST_F(Replay, PlaysNothingBeforeAllWhoSubscribedAreConnected) {
  scan_cell_demo::record_scan(path("scan.bag"), "late", config("reference_frame.yaml"),
                              1.7e9 + 3000);
  save_sampled_reference();
  // A subscriber to the pulses that cannot be reached.
  XmlRpc::XmlRpcValue late, answer, payload;
  late[0] = "/late";
  late[1] = "/laser_trigger/events";
  late[2] = "scan_cell_msgs/TriggerEvent";
  late[3] = "http://localhost:9/";
  ASSERT_TRUE(ros::master::execute("registerSubscriber", late, answer, payload, false));
  const auto try_it = [this] {
    return replay(path("scan.bag"), path("sampled.ply"), path("out"),
                  " _timeout:=3 2> " + path("stderr"));
  };
  EXPECT_EQ(try_it(), 1);
  const std::string complaint = bytes_of(path("stderr"));
  EXPECT_NE(complaint.find("/laser_trigger/events: 2 of 3 subscribers connected"),
            std::string::npos)
      << complaint;
  XmlRpc::XmlRpcValue unregister;
  unregister[0] = late[0];
  unregister[1] = late[1];
  unregister[2] = late[3];
  ASSERT_TRUE(ros::master::execute("unregisterSubscriber", unregister, answer, payload, false));
  EXPECT_EQ(try_it(), 0) << bytes_of(path("stderr"));
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_replay");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
