// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The node on real topics, against an emulated controller in this process, whose truth is known.
#include <actionlib/client/simple_action_client.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/GetControllerParameter.h>
#include <scan_cell_msgs/GetStaticPose.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/SetControllerParameter.h>
#include <scan_cell_msgs/SetLinearSpeed.h>
#include <scan_cell_msgs/SetOverride.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <sys/wait.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_listener.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <mutex>
#include <set>

#include "closed_form.h"
#include "scan_cell_common/child_process.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_sim/controller/controller.h"

using scan_cell_common::from_ros;
using scan_cell_common::Nanoseconds;
using scan_cell_msgs::MoveGoal;
using scan_cell_msgs::MoveResult;
using scan_cell_msgs::RobotStatus;
using GoalState = actionlib::SimpleClientGoalState;
using MoveClient = actionlib::SimpleActionClient<scan_cell_msgs::MoveAction>;

namespace {

const ros::Duration kPatience(20);

Eigen::Isometry3d looking_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

MoveGoal to_pose(const Eigen::Isometry3d& pose) {
  MoveGoal goal;
  goal.kind = MoveGoal::CARTESIAN;
  goal.pose.header.frame_id = "base_link";
  goal.pose.pose = scan_cell_common::to_ros_pose(pose);
  goal.camera_rate = 100;
  return goal;
}

MoveGoal to_joints(const std::vector<double>& joints) {
  MoveGoal goal;
  goal.kind = MoveGoal::JOINT;
  goal.joints = joints;
  return goal;
}

bool eventually(const std::function<bool()>& condition, double seconds = 20) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::WallTime::now() < deadline) {
    if (condition()) return true;
    ros::WallDuration(0.005).sleep();
  }
  return condition();
}

double distance(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

/// Exit code of a shell command, and all it said.
std::pair<int, std::string> run_command(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    said += static_cast<char>(c);
  return {WEXITSTATUS(pclose(pipe)), said};
}

template <class Message>
class Latest {
 public:
  Latest(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(
            node.subscribe<Message>(topic, 1000, [this](const typename Message::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              all_.push_back(*message);
            })) {}
  std::vector<Message> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_;
  }
  bool is(const std::function<bool(const Message&)>& condition) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !all_.empty() && condition(all_.back());
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Message> all_;
  ros::Subscriber subscriber_;
};

class Driver : public testing::Test {
 protected:
  void SetUp() override {
    scan_cell_sim::ControllerOptions options;
    options.port = 35410;
    controller_ = std::make_unique<scan_cell_sim::Controller>(options);
    ASSERT_TRUE(move_.waitForServer(kPatience));
    ASSERT_TRUE(connected(true));
  }

  void TearDown() override {
    move_.cancelAllGoals();
    controller_.reset();
    EXPECT_TRUE(connected(false)) << "the driver must notice that the controller is gone";
  }

  bool connected(bool wanted) {
    return eventually([this, wanted] {
      return status_.is([wanted](const RobotStatus& status) { return status.connected == wanted; });
    });
  }

  /// Moves, and gives the result however it ended.
  MoveResult run(const MoveGoal& goal) {
    move_.sendGoal(goal);
    EXPECT_TRUE(move_.waitForResult(kPatience));
    return move_.getResult() ? *move_.getResult() : MoveResult();
  }

  /// Starts a long motion, and waits until the robot is well under way.
  void start_long_move() {
    move_.sendGoal(to_pose(looking_down(0.80, 0.35, 0.60)));
    ASSERT_TRUE(
        eventually([this] { return controller_->state().flange.translation().y() > 0.03; }));
  }

  Eigen::Isometry3d truth() const { return controller_->state().flange; }

  template <class Service>
  typename Service::Response call(const std::string& name,
                                  const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(ros::service::call("/c4g_driver/" + name, service));
    return service.response;
  }

  template <class Request, class Value>
  static Request with(Value Request::*field, const Value& value) {
    Request request;
    request.*field = value;
    return request;
  }

  /// base_link -> tool0 since the test began.
  std::vector<geometry_msgs::TransformStamped> flange_transforms() const {
    std::vector<geometry_msgs::TransformStamped> result;
    for (const auto& message : transforms_.all()) {
      for (const auto& transform : message.transforms) {
        if (transform.child_frame_id == "tool0") result.push_back(transform);
      }
    }
    return result;
  }

  ros::NodeHandle node_;
  std::unique_ptr<scan_cell_sim::Controller> controller_;
  Latest<RobotStatus> status_{node_, "/c4g_driver/status"};
  Latest<tf2_msgs::TFMessage> transforms_{node_, "/tf"};
  Latest<sensor_msgs::JointState> joints_{node_, "/joint_states"};
  MoveClient move_{"/c4g_driver/move", true};
};

}  // namespace

TEST_F(Driver, MovesAlongALineAndShowsWhereItIs) {
  const Eigen::Isometry3d target = looking_down(0.85, 0.15, 0.55);
  double progress = 0;
  bool forward = true;
  move_.sendGoal(to_pose(target), {}, {},
                 [&](const scan_cell_msgs::MoveFeedbackConstPtr& feedback) {
                   forward = forward && feedback->progress >= progress;
                   progress = feedback->progress;
                 });
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::SUCCEEDED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::REACHED);
  EXPECT_LT(distance(from_ros(move_.getResult()->pose.pose), target), 1e-5);
  EXPECT_LT(distance(truth(), target), 1e-5);
  EXPECT_TRUE(forward);
  EXPECT_GT(progress, 0.2);
  EXPECT_LE(progress, 1.0);
  EXPECT_EQ(controller_->state().camera_rate, 100);
}

TEST_F(Driver, StampsEveryTransformWithTheInstantItWasMeasured) {
  ASSERT_EQ(run(to_pose(looking_down(0.80, 0.25, 0.60))).outcome, MoveResult::REACHED);
  const auto transforms = flange_transforms();
  ros::Time last;
  std::vector<double> errors;
  for (const auto& transform : transforms) {
    EXPECT_GT(transform.header.stamp, last);
    last = transform.header.stamp;
    const Eigen::Isometry3d at = controller_->flange_at(from_ros(transform.header.stamp));
    const double y = transform.transform.translation.y;
    if (y > 0.02 && y < 0.23) errors.push_back(distance(from_ros(transform.transform), at));
  }
  // 0.21 m at 0.25 m/s and 250 Hz make 210; a busy machine loses some
  ASSERT_GT(errors.size(), 100u);
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.1e-3);  // 0.4 ms at 0.25 m/s
}

TEST_F(Driver, ShowsTheSameFlangeAsTheUrdf) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  for (const std::vector<double>& joints : std::vector<std::vector<double>>{
           {0.3, -0.2, -1.9, 0.5, 1.2, -2.0}, {-0.6, 0.4, -1.2, -1.0, 0.7, 4.0}}) {
    ASSERT_EQ(run(to_joints(joints)).outcome, MoveResult::REACHED);
    const Eigen::Isometry3d expected =
        flange_by_denavit_hartenberg(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(joints.data()));
    EXPECT_LT(distance(truth(), expected), 1e-5);
    for (const std::string frame : {"tool0", "flange"}) {
      Eigen::Isometry3d shown = Eigen::Isometry3d::Identity();
      EXPECT_TRUE(eventually([&] {
        try {
          shown = from_ros(buffer.lookupTransform("base_link", frame, ros::Time()).transform);
        } catch (const tf2::TransformException&) {
          return false;
        }
        return shown.isApprox(expected, 1e-5);
      })) << frame
          << " is at\n"
          << shown.matrix() << "\nand not at\n"
          << expected.matrix();
    }
  }
  EXPECT_TRUE(joints_.is([](const sensor_msgs::JointState& state) {
    return state.name.front() == "joint_1" && state.name.back() == "joint_6" &&
           std::abs(state.position[5] - 4.0) < 1e-5;
  }));
}

TEST_F(Driver, PollsTheRobotWhileItStands) {
  const std::size_t before = flange_transforms().size();
  EXPECT_TRUE(eventually([&] { return flange_transforms().size() > before + 5; }));
}

TEST_F(Driver, RunsAtTheSpeedAndOverrideItWasGiven) {
  using scan_cell_msgs::SetLinearSpeed;
  using scan_cell_msgs::SetOverride;
  EXPECT_TRUE(
      call<SetLinearSpeed>("set_linear_speed", with(&SetLinearSpeed::Request::speed, 0.1)).success);
  EXPECT_TRUE(
      call<SetOverride>("set_override", with(&SetOverride::Request::override, 50.0)).success);
  move_.sendGoal(to_pose(looking_down(0.80, 0.10, 0.60)));
  ASSERT_TRUE(eventually([this] { return truth().translation().y() > 0.03; }));
  const Nanoseconds now = from_ros(ros::Time::now());
  const double way =
      distance(controller_->flange_at(now), controller_->flange_at(now - 200'000'000));
  EXPECT_NEAR(way, 0.2 * 0.05, 1e-6);
  EXPECT_TRUE(eventually([this] {
    return status_.is([](const RobotStatus& status) {
      return status.override == 50 && status.linear_speed == 0.1 && status.in_motion == 1;
    });
  }));
}

TEST_F(Driver, RefusesBadTargetsWithTheReasonAndMovesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MoveGoal other_frame = to_pose(looking_down(0.8, 0, 0.6));
  other_frame.pose.header.frame_id = "world";
  MoveGoal no_rotation = to_pose(looking_down(0.8, 0, 0.6));
  no_rotation.pose.pose.orientation.x = 0;
  MoveGoal no_kind = to_pose(looking_down(0.8, 0, 0.6));
  no_kind.kind = 7;
  const std::vector<std::pair<MoveGoal, std::string>> bad = {
      {to_pose(looking_down(nan, 0, 0.6)), "target x"},
      {to_pose(looking_down(0.8, 9, 0.6)), "target y"},
      {to_pose(looking_down(0.8, 0, 0.05)), "target z"},
      {other_frame, "frame"},
      {no_rotation, "orientation"},
      {no_kind, "kind"},
      {to_joints({0, 0, -1}), "joints"},
      {to_joints({0, 0, 1, 0, 0, 0}), "target J3"},
      {to_joints({0, 0, nan, 0, 0, 0}), "target J3"},
      {to_joints({0, 1.3, -M_PI / 2, 0, 0, 0}), "target z"},  // through the floor
      {to_pose(looking_down(1.35, 0, 1.5)), "reach"}};        // this one the controller refuses
  for (const auto& [goal, reason] : bad) {
    const MoveResult result = run(goal);
    EXPECT_EQ(move_.getState(), GoalState::ABORTED);
    EXPECT_EQ(result.outcome, MoveResult::REFUSED) << reason;
    EXPECT_NE(result.message.find(reason), std::string::npos) << result.message;
  }
  EXPECT_EQ(controller_->motions_begun(), 0u);
  using scan_cell_msgs::SetLinearSpeed;
  using scan_cell_msgs::SetOverride;
  const auto speed =
      call<SetLinearSpeed>("set_linear_speed", with(&SetLinearSpeed::Request::speed, 5.0));
  EXPECT_FALSE(speed.success);
  EXPECT_NE(speed.message.find("linear speed"), std::string::npos);
  EXPECT_FALSE(
      call<SetOverride>("set_override", with(&SetOverride::Request::override, 120.0)).success);
}

TEST_F(Driver, StopsWhenTheGoalIsCancelled) {
  start_long_move();
  move_.cancelGoal();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::PREEMPTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(controller_->state().status, scan_cell_sim::MotionStatus::Stopped);
  EXPECT_LT(truth().translation().y(), 0.34);
  EXPECT_LT(distance(from_ros(move_.getResult()->pose.pose), truth()), 1e-5);
}

TEST_F(Driver, StopsTheMotionUnderWayForANewGoal) {
  start_long_move();
  MoveClient second("/c4g_driver/move", true);
  ASSERT_TRUE(second.waitForServer(kPatience));
  const Eigen::Isometry3d target = looking_down(0.80, 0, 0.65);
  second.sendGoal(to_pose(target));
  ASSERT_TRUE(second.waitForResult(kPatience));
  EXPECT_EQ(second.getResult()->outcome, MoveResult::REACHED);
  EXPECT_LT(distance(truth(), target), 1e-5);
  EXPECT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::PREEMPTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(controller_->motions_begun(), 2u);
}

TEST_F(Driver, EndsTheGoalOfALostLinkAndDoesNotResumeIt) {
  start_long_move();
  scan_cell_sim::ControllerFaults cut;
  cut.to_client.link_down = cut.from_client.link_down = true;
  controller_->set_faults(cut);
  const ros::WallTime lost = ros::WallTime::now();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_LT((ros::WallTime::now() - lost).toSec(), 1.0);
  EXPECT_EQ(move_.getState(), GoalState::ABORTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::LINK_LOST);
  ASSERT_TRUE(connected(false));
  controller_->set_faults({});
  ASSERT_TRUE(connected(true));
  ASSERT_TRUE(eventually(
      [this] { return controller_->state().status != scan_cell_sim::MotionStatus::Moving; }));
  const Eigen::Isometry3d stopped = truth();
  EXPECT_LT(stopped.translation().y(), 0.349);
  const std::size_t before = flange_transforms().size();
  ASSERT_TRUE(eventually([&] { return flange_transforms().size() > before + 10; }));
  EXPECT_EQ(distance(truth(), stopped), 0);
  EXPECT_EQ(controller_->motions_begun(), 1u);
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REACHED);
}

TEST_F(Driver, EndsTheGoalAtAnEmergencyStop) {
  start_long_move();
  controller_->press_e_stop();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::ABORTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(move_.getResult()->message, "emergency stop");
  EXPECT_TRUE(eventually([this] {
    return status_.is([](const RobotStatus& status) {
      return status.e_stopped == RobotStatus::YES && status.motion_possible == RobotStatus::NO;
    });
  }));
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REFUSED);
  controller_->release_e_stop();
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REFUSED) << "an alarm";
  EXPECT_FALSE(call<std_srvs::SetBool>("set_drives",
                                       with(&std_srvs::SetBool::Request::data, std::uint8_t{1}))
                   .success);
  EXPECT_TRUE(call<std_srvs::Trigger>("reset_alarms", {}).success);
  EXPECT_TRUE(call<std_srvs::SetBool>("set_drives",
                                      with(&std_srvs::SetBool::Request::data, std::uint8_t{1}))
                  .success);
  EXPECT_EQ(controller_->motions_begun(), 1u);
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REACHED);
}

TEST_F(Driver, ReportsAnErrorOfTheController) {
  start_long_move();
  controller_->fail_motion("following error of J2");
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::CONTROLLER_ERROR);
  EXPECT_EQ(move_.getResult()->message, "following error of J2");
}

TEST_F(Driver, ReadsAndWritesParametersAndTheStaticPose) {
  using scan_cell_msgs::GetControllerParameter;
  using scan_cell_msgs::SetControllerParameter;
  SetControllerParameter::Request set;
  set.name = "motion_type";
  set.value = "\"joint\"";
  EXPECT_TRUE(call<SetControllerParameter>("set_parameter", set).success);
  const auto name = with(&GetControllerParameter::Request::name, std::string("motion_type"));
  EXPECT_EQ(call<GetControllerParameter>("get_parameter", name).value, "\"joint\"");
  set.value = "joint";  // not JSON
  EXPECT_FALSE(call<SetControllerParameter>("set_parameter", set).success);
  const auto pose = call<scan_cell_msgs::GetStaticPose>("get_static_pose", {});
  EXPECT_TRUE(pose.success);
  EXPECT_LT(distance(from_ros(pose.pose.pose), truth()), 1e-5);
  EXPECT_EQ(pose.pose.header.frame_id, "base_link");
  EXPECT_EQ(pose.joints.position.size(), 6u);
  start_long_move();  // in joints, a line or not
  EXPECT_FALSE(call<scan_cell_msgs::GetStaticPose>("get_static_pose", {}).success);
}

TEST_F(Driver, DiagnosesTheStreamTheClockAndTheRoundTrip) {
  const Latest<diagnostic_msgs::DiagnosticArray> diagnostics(node_, "/diagnostics");
  const auto most = [&](const std::string& key) {
    double result = -1;
    for (const auto& array : diagnostics.all()) {
      for (const auto& status : array.status) {
        if (status.name != "c4g_driver: link") continue;
        for (const auto& entry : status.values) {
          if (entry.key == key) result = std::max(result, std::stod(entry.value));
        }
      }
    }
    return result;
  };
  start_long_move();
  EXPECT_TRUE(eventually([&] { return most("positions a second") > 50; }));
  EXPECT_LT(most("positions a second"), 300);
  EXPECT_GT(most("round trip of a request, half within [ms]"), 0);
  EXPECT_GT(most("from datagram to tf, 99 % within [ms]"), 0);
  EXPECT_TRUE(eventually([&] { return most("controller's clock, watched for [s]") > 2; }));
  EXPECT_GT(most("controller's clock, residual [us]"), -1);
}

TEST_F(Driver, DiagnosesLinkAndRobot) {
  const Latest<diagnostic_msgs::DiagnosticArray> diagnostics(node_, "/diagnostics");
  std::set<std::string> names;
  EXPECT_TRUE(eventually([&] {
    for (const auto& array : diagnostics.all()) {
      for (const auto& status : array.status)
        names.insert(status.name);
    }
    return names.count("c4g_driver: link") == 1 && names.count("c4g_driver: robot") == 1;
  }));
}

TEST(OtherDriver, SpeaksWithAControllerProcessOverABadWire) {
  MoveClient move("/other/other_driver/move", true);
  ASSERT_TRUE(move.waitForServer(kPatience));
  ros::NodeHandle node;
  const Latest<RobotStatus> status(node, "/other/other_driver/status");
  ASSERT_TRUE(
      eventually([&] { return status.is([](const RobotStatus& now) { return now.connected; }); }));
  move.sendGoal(to_pose(looking_down(0.80, 0.05, 0.60)));
  ASSERT_TRUE(move.waitForResult(kPatience));
  EXPECT_EQ(move.getResult()->outcome, MoveResult::REACHED) << move.getResult()->message;
  EXPECT_LT(distance(from_ros(move.getResult()->pose.pose), looking_down(0.80, 0.05, 0.60)), 1e-4);
}

TEST(KilledDriver, LeavesNothingThatMovesTheRobotWhenItIsStartedAgain) {
  scan_cell_sim::ControllerOptions options;
  options.port = 35413;
  scan_cell_sim::Controller controller(options);
  const auto node_beside_this_test =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "c4g_driver_node";
  const std::vector<std::string> command = {node_beside_this_test, "__name:=mortal",
                                            "_address:=127.0.0.1", "_port:=35413"};
  scan_cell_common::ChildProcess first(command);
  MoveClient move("/mortal/move", true);
  ASSERT_TRUE(move.waitForServer(kPatience));
  ros::NodeHandle node;
  const Latest<RobotStatus> status(node, "/mortal/status");
  const auto connected = [&] {
    return status.is([](const RobotStatus& now) { return now.connected; });
  };
  ASSERT_TRUE(eventually(connected));
  move.sendGoal(to_pose(looking_down(0.80, 0.35, 0.60)));
  ASSERT_TRUE(eventually([&] { return controller.state().flange.translation().y() > 0.03; }));
  kill(first.id(), SIGKILL);
  first.wait();
  ASSERT_TRUE(eventually(
      [&] { return controller.state().status == scan_cell_sim::MotionStatus::Stopped; }));
  const Eigen::Isometry3d stopped = controller.state().flange;
  EXPECT_LT(stopped.translation().y(), 0.349);

  const std::size_t before = status.all().size();
  const scan_cell_common::ChildProcess second(command);
  ASSERT_TRUE(eventually([&] { return status.all().size() > before + 10 && connected(); }));
  EXPECT_EQ(distance(controller.state().flange, stopped), 0);
  EXPECT_EQ(controller.motions_begun(), 1u);
}

TEST(DriverStart, RefusesBadParametersByName) {
  const std::string address = "_address:=127.0.0.1 ";
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "/refused/address: not set"},
      {"_address:=robot", "'robot'"},
      {address + "_port:=0", "/refused/port: 0"},
      {address + "_port:=5410.5", "/refused/port: not of type"},
      {address + "_port:=35412 _adress:=127.0.0.1", "/refused/adress: no such parameter"},
      {address + "_most_linear_speed:=fast", "/refused/most_linear_speed: not of type"},
      {address + "_operation:=fast", "/refused/operation: 'fast'"},
      {address + "_flange_link:=hand", "robot description: no chain from 'base_link' to 'hand'"}};
  for (const auto& [parameters, complaint] : bad) {
    const auto [code, said] =
        run_command("rosrun c4g_driver c4g_driver_node __name:=refused " + parameters);
    EXPECT_EQ(code, 1) << parameters;
    EXPECT_NE(said.find(complaint), std::string::npos) << parameters << ": " << said;
    ros::param::del("/refused");
  }
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_c4g_driver");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
