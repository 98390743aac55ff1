// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/StretchToolPathAction.h>
#include <sys/wait.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/conversions.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "tool_path_stretcher/surface.h"
#include "tool_paths/tool_path_files.h"

using scan_cell_msgs::StretchToolPathGoal;
using scan_cell_msgs::StretchVerdict;
using Client = actionlib::SimpleActionClient<scan_cell_msgs::StretchToolPathAction>;
using State = actionlib::SimpleClientGoalState;

namespace {

constexpr double kLong = 120;  // [s] allows for a busy machine
constexpr std::size_t kWaypoints = 60;

sensor_msgs::PointCloud2 cloud_message(const synthetic::Points& points) {
  scan_cell_common::Cloud cloud;
  for (const Eigen::Vector3d& p : points) {
    cloud.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  }
  std_msgs::Header header;
  header.frame_id = "world";
  return scan_cell_common::to_message(cloud, header);
}

scan_cell_msgs::ToolPath path_message(const synthetic::ToolPath& path) {
  scan_cell_msgs::ToolPath message;
  message.name = path.name;
  message.has_orientation = path.has_orientation;
  message.process_names = path.process_names;
  for (const auto& segment : path.segments) {
    message.segments.emplace_back();
    message.segments.back().name = segment.name;
    for (const auto& waypoint : segment.waypoints) {
      scan_cell_msgs::ToolPathWaypoint to;
      to.pose = scan_cell_common::to_ros_pose(waypoint.pose);
      to.process_values = waypoint.process_values;
      message.segments.back().waypoints.push_back(to);
    }
  }
  return message;
}

/// The latest message of a latched topic.
template <class Message>
boost::shared_ptr<Message const> latched(const std::string& topic) {
  return ros::topic::waitForMessage<Message>(topic, ros::Duration(kLong));
}

class StretchAction : public testing::Test {
 protected:
  StretchAction() {
    EXPECT_TRUE(comes([this] { return client_.isServerConnected(); }));
  }

  /// Serves the client's callbacks in this thread until the condition holds: actionlib's client
  /// does not tolerate an answer from another thread while it sends.
  template <class Condition>
  bool comes(const Condition& condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kLong);
    while (!condition()) {
      if (ros::WallTime::now() > end) return false;
      queue_.callAvailable(ros::WallDuration(0.05));
    }
    return true;
  }
  bool ends() {
    return comes([this] { return client_.getState().isDone(); });
  }

  StretchToolPathGoal goal(const synthetic::Part& scanned) const {
    synthetic::Scan whole;
    whole.seed = 11;
    StretchToolPathGoal goal;
    goal.reference = cloud_message(synthetic::scan(part_, {}, synthetic::no_deformation(), whole));
    goal.object = cloud_message(synthetic::scan(scanned, moved_, synthetic::no_deformation(), {}));
    goal.path = path_message(path_);
    return goal;
  }

  /// Expects each mapped point of the reference, moved back by the truth, to be one of the
  /// reference's points.
  void expect_reference_on_object() const {
    const auto message = latched<sensor_msgs::PointCloud2>("/tool_path_stretcher/mapped_reference");
    ASSERT_TRUE(message);
    EXPECT_EQ(message->header.frame_id, "world");
    const auto mapped = tool_path_stretcher::to_points(scan_cell_common::from_message(*message));
    EXPECT_GT(mapped.size(), 1000u);
    const auto reference =
        tool_path_stretcher::to_points(scan_cell_common::from_message(goal(part_).reference));
    for (const Eigen::Vector3d& point : mapped) {
      const auto nearer = [back = moved_.inverse(point)](const auto& a, const auto& b) {
        return (a - back).squaredNorm() < (b - back).squaredNorm();
      };
      const auto nearest = std::min_element(reference.begin(), reference.end(), nearer);
      ASSERT_LT((*nearest - moved_.inverse(point)).norm(), 0.002);  // [m] the grid of the leaf
    }
  }

  /// The result, after exactly one terminal state.
  scan_cell_msgs::StretchToolPathResult finish(const StretchToolPathGoal& goal, State expected) {
    client_.sendGoal(goal);
    EXPECT_TRUE(ends());
    EXPECT_EQ(client_.getState().toString(), expected.toString());
    return *client_.getResult();
  }

  synthetic::Part part_ = synthetic::photo_frame();
  synthetic::ToolPath path_ = synthetic::path_on(part_, kWaypoints);
  tool_path_stretcher::Similarity moved_ = synthetic::similarity(
      1.08, Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {0.3, 0.1, 0});
  ros::CallbackQueue queue_;
  ros::NodeHandle node_ = [this] {
    ros::NodeHandle node;
    node.setCallbackQueue(&queue_);
    return node;
  }();
  Client client_{node_, "/tool_path_stretcher/stretch", false};
};

}  // namespace

TEST_F(StretchAction, AdaptsThePathAndShowsIt) {
  const auto result = finish(goal(part_), State::SUCCEEDED);
  EXPECT_EQ(result.verdict.reason, StretchVerdict::ACCEPTED);
  EXPECT_EQ(result.verdict.name, "accepted");
  EXPECT_EQ(result.quality.size(), kWaypoints);
  EXPECT_NEAR(result.similarity.scale, 1.08, 0.001);
  EXPECT_EQ(result.path.header.frame_id, "world");
  const auto truth = synthetic::truth(path_, moved_, synthetic::no_deformation());
  ASSERT_EQ(result.path.segments.size(), truth.segments.size());
  for (std::size_t s = 0; s < truth.segments.size(); ++s) {
    ASSERT_EQ(result.path.segments[s].waypoints.size(), truth.segments[s].waypoints.size());
    for (std::size_t w = 0; w < truth.segments[s].waypoints.size(); ++w) {
      const auto& is = result.path.segments[s].waypoints[w];
      const auto& should = truth.segments[s].waypoints[w];
      EXPECT_LT(
          (scan_cell_common::from_ros(is.pose).translation() - should.pose.translation()).norm(),
          0.0003);
      EXPECT_EQ(is.process_values, should.process_values);
    }
  }
  const auto shown = latched<nav_msgs::Path>("/tool_path_stretcher/adapted_path");
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->poses.size(), kWaypoints);
  ASSERT_TRUE(latched<nav_msgs::Path>("/tool_path_stretcher/reference_path"));
  const auto markers = latched<visualization_msgs::MarkerArray>("/tool_path_stretcher/markers");
  ASSERT_TRUE(markers);
  EXPECT_EQ(markers->markers.at(0).points.size(), 2 * kWaypoints);
  EXPECT_EQ(markers->markers.at(0).color.g, 1);
  const auto& waypoints = markers->markers.at(1);
  EXPECT_EQ(waypoints.ns, "waypoints");
  ASSERT_EQ(waypoints.colors.size(), kWaypoints);
  for (const auto& colour : waypoints.colors)  // errors of hundredths of a millimetre
    EXPECT_LT(colour.r, colour.g);
  EXPECT_EQ(markers->markers.at(2).action, visualization_msgs::Marker::DELETE);
  EXPECT_TRUE(latched<sensor_msgs::PointCloud2>("/tool_path_stretcher/object"));
  EXPECT_TRUE(latched<sensor_msgs::PointCloud2>("/tool_path_stretcher/reference"));
  expect_reference_on_object();
}

TEST_F(StretchAction, RefusesAWrongPartWithAReasonAndNoPath) {
  const auto result = finish(goal(synthetic::box_lid()), State::ABORTED);
  EXPECT_EQ(result.verdict.reason, StretchVerdict::WRONG_PART);
  EXPECT_EQ(result.verdict.name, "wrong_part");
  EXPECT_FALSE(result.verdict.message.empty());
  EXPECT_TRUE(result.path.segments.empty());
  const auto shown = latched<nav_msgs::Path>("/tool_path_stretcher/adapted_path");
  ASSERT_TRUE(shown);
  EXPECT_TRUE(shown->poses.empty());
}

TEST_F(StretchAction, ShowsTheWaypointsThatAVerdictIsAbout) {
  synthetic::Scan half;
  half.is_hole = [](const Eigen::Vector3d& at) { return at.y() < -0.04; };
  StretchToolPathGoal partial = goal(part_);
  partial.object = cloud_message(synthetic::scan(part_, moved_, synthetic::no_deformation(), half));
  const auto result = finish(partial, State::ABORTED);
  EXPECT_EQ(result.verdict.name, "path_not_scanned");
  ASSERT_FALSE(result.verdict.waypoints.empty());
  const auto markers = latched<visualization_msgs::MarkerArray>("/tool_path_stretcher/markers");
  ASSERT_TRUE(markers);
  EXPECT_EQ(markers->markers.at(1).action, visualization_msgs::Marker::DELETE);
  EXPECT_EQ(markers->markers.at(2).ns, "refused");
  EXPECT_EQ(markers->markers.at(2).action, visualization_msgs::Marker::ADD);
  EXPECT_EQ(markers->markers.at(2).points.size(), result.verdict.waypoints.size());
}

TEST_F(StretchAction, GivesTheAcceptedPathAsTheRobotsProgramToo) {
  StretchToolPathGoal program = goal(part_);
  program.robot_program = "frame.src";
  program.robot_program_options = {"waypoint_z=into_part", "comment=left"};
  const auto result = finish(program, State::SUCCEEDED);
  EXPECT_EQ(result.robot_program_error, "");
  ASSERT_EQ(result.robot_program.size(), 1u);
  EXPECT_EQ(result.robot_program[0].name, "frame.src");
  const std::string& text = result.robot_program[0].text;
  EXPECT_NE(text.find("DEF frame "), std::string::npos) << text;
  EXPECT_NE(text.find("; left"), std::string::npos);
  EXPECT_NE(text.find("; path: adapted.csv sha256 "), std::string::npos);
  EXPECT_NE(result.robot_program_notes.at(1).find("moves, read back the same"), std::string::npos);
  program.robot_program = "frame.mod";
  program.robot_program_options.clear();
  const auto without = finish(program, State::SUCCEEDED);
  EXPECT_TRUE(without.robot_program.empty());
  EXPECT_NE(without.robot_program_error.find("waypoint_z"), std::string::npos);
}

TEST_F(StretchAction, RefusesAProgramThatMakesNoSenseBeforeItBegins) {
  StretchToolPathGoal elsewhere = goal(part_);
  elsewhere.robot_program = "../frame.src";
  EXPECT_NE(finish(elsewhere, State::ABORTED).verdict.message.find("../frame.src"),
            std::string::npos);
  StretchToolPathGoal unknown = goal(part_);
  unknown.robot_program = "frame.src";
  unknown.robot_program_options = {"colour=blue"};
  const auto refused = finish(unknown, State::ABORTED);
  EXPECT_EQ(refused.verdict.reason, StretchVerdict::UNUSABLE_INPUT);
  EXPECT_NE(refused.verdict.message.find("colour"), std::string::npos);
}

TEST_F(StretchAction, RefusesUnusableInputByName) {
  StretchToolPathGoal empty = goal(part_);
  empty.object = cloud_message({});
  EXPECT_EQ(finish(empty, State::ABORTED).verdict.reason, StretchVerdict::UNUSABLE_INPUT);
  StretchToolPathGoal method = goal(part_);
  method.method = "magic";
  const auto refused = finish(method, State::ABORTED);
  EXPECT_EQ(refused.verdict.reason, StretchVerdict::UNUSABLE_INPUT);
  EXPECT_NE(refused.verdict.message.find("magic"), std::string::npos);
  StretchToolPathGoal turned = goal(part_);
  turned.path.segments[0].waypoints[2].pose.orientation.w = 5;
  EXPECT_NE(finish(turned, State::ABORTED).verdict.message.find("segment 0 waypoint 2"),
            std::string::npos);
  StretchToolPathGoal frames = goal(part_);
  frames.object.header.frame_id = "elsewhere";
  EXPECT_NE(finish(frames, State::ABORTED).verdict.message.find("elsewhere"), std::string::npos);
  StretchToolPathGoal path_frame = goal(part_);
  path_frame.path.header.frame_id = "fixture";
  const auto in_fixture = finish(path_frame, State::ABORTED);
  EXPECT_EQ(in_fixture.verdict.reason, StretchVerdict::UNUSABLE_INPUT);
  EXPECT_NE(in_fixture.verdict.message.find("path: in frame 'fixture'"), std::string::npos);
  StretchToolPathGoal no_path = goal(part_);
  no_path.path.segments.clear();
  EXPECT_EQ(finish(no_path, State::ABORTED).verdict.reason, StretchVerdict::UNUSABLE_INPUT);
}

TEST_F(StretchAction, GivesTheSameBytesAsTheCommand) {
  namespace fs = std::filesystem;
  using namespace tool_path_stretcher;
  const fs::path folder = fs::temp_directory_path() / ("same_bytes_" + std::to_string(getpid()));
  fs::create_directories(folder);
  StretchToolPathGoal same = goal(part_);
  same.path = to_message(path_, std_msgs::Header());
  const auto save = [&folder](const sensor_msgs::PointCloud2& cloud, const char* name) {
    scan_cell_common::save_cloud((folder / name).string(), scan_cell_common::from_message(cloud));
  };
  save(same.reference, "r.ply");
  save(same.object, "d.ply");
  tool_paths::save_tool_path((folder / "p.csv").string(), path_);
  const std::string command = "cd " + folder.string() + " && " + STRETCH_COMMAND +
                              " --reference r.ply --object d.ply --path p.csv --output out.csv"
                              " --report report.json > /dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto result = finish(same, State::SUCCEEDED);
  const auto text_of = [&folder](const char* name) {
    std::ifstream in(folder / name);
    return std::string((std::istreambuf_iterator<char>(in)), {});
  };
  auto by_command = nlohmann::json::parse(text_of("report.json"));
  auto by_action = nlohmann::json::parse(result.report);
  for (const char* const own : {"seconds", "seconds_of", "files"}) {
    by_command.erase(own);
    by_action.erase(own);
  }
  EXPECT_EQ(by_command.dump(2), by_action.dump(2));
  std::ifstream rows(folder / "out.csv");
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row.rfind("x,y,z,qx,qy,qz,qw,", 0), 0U);
  for (const auto& segment : result.path.segments) {
    for (const auto& waypoint : segment.waypoints) {
      ASSERT_TRUE(std::getline(rows, row));
      std::istringstream numbers(row);
      const auto& [at, turn] = std::tie(waypoint.pose.position, waypoint.pose.orientation);
      for (const double expected : {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w}) {
        std::string number;
        std::getline(numbers, number, ',');
        EXPECT_EQ(std::stod(number), expected);
      }
    }
  }
  fs::remove_all(folder);
}

TEST_F(StretchAction, TakesWhatTheGoalKnowsOfTheObject) {
  StretchToolPathGoal known = goal(part_);
  known.scale = 1.08;
  known.has_initial_pose = 1;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = moved_.rotation;
  pose.translation() = moved_.translation;
  known.initial_pose = scan_cell_common::to_ros_transform(pose);
  known.initial_pose_angle = 0.3;
  known.initial_pose_distance = 0.02;
  known.resample_spacing = 0.005;
  const auto result = finish(known, State::SUCCEEDED);
  EXPECT_EQ(result.similarity.scale, 1.08);
  EXPECT_GT(result.quality.size(), kWaypoints);
  known.initial_pose_angle = -1;
  const auto refused = finish(known, State::ABORTED);
  EXPECT_EQ(refused.verdict.reason, StretchVerdict::UNUSABLE_INPUT);
  EXPECT_NE(refused.verdict.message.find("initial_pose_angle"), std::string::npos);
}

TEST_F(StretchAction, UsesTheMethodOfTheGoal) {
  StretchToolPathGoal affine = goal(part_);
  affine.method = "affine";
  affine.path.header.frame_id = "world";
  EXPECT_EQ(finish(affine, State::SUCCEEDED).verdict.reason, StretchVerdict::ACCEPTED);
}

TEST_F(StretchAction, EndsSoonWhenCancelledAndTellsItsStages) {
  std::vector<std::string> stages;
  std::vector<double> progress;
  client_.sendGoal(goal(part_), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [&](const scan_cell_msgs::StretchToolPathFeedbackConstPtr& feedback) {
                     stages.push_back(feedback->stage);
                     progress.push_back(feedback->progress);
                   });
  ASSERT_TRUE(comes([&] { return !stages.empty(); }));
  client_.cancelGoal();
  ASSERT_TRUE(ends());
  EXPECT_EQ(client_.getState().toString(), State(State::PREEMPTED).toString());
  EXPECT_EQ(client_.getResult()->verdict.reason, StretchVerdict::CANCELLED);
  EXPECT_TRUE(client_.getResult()->path.segments.empty());
  EXPECT_FALSE(stages.empty());
  EXPECT_LT(progress.back(), 1);
}

TEST(StretchNode, RefusesToStartOnABadParameter) {
  const auto start = [](const std::string& parameter) {
    const std::string command =
        std::string(STRETCHER_NODE) + " __name:=refused _" + parameter + " > /dev/null 2>&1";
    const int status = std::system(command.c_str());
    ros::NodeHandle().deleteParam("/refused");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  EXPECT_EQ(start("tolerance:=-1"), 1);
  EXPECT_EQ(start("method:=magic"), 1);
  EXPECT_EQ(start("leaf:=[0.002]"), 1);
  EXPECT_EQ(start("tolerence:=0.001"), 1);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_stretch_action");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
