// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "delay_runs.h"

#include <actionlib/client/simple_action_client.h>
#include <arpa/inet.h>
#include <fmt/format.h>
#include <ros/ros.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/SetLinearSpeed.h>
#include <sys/socket.h>

#include <filesystem>
#include <vector>

#include "driver_node.h"
#include "messages.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_common/testing/child_process.h"
#include "wire/allocations.h"
#include "wire/codec.h"
#include "wire/peer_socket.h"

namespace c4g_driver {

using scan_cell_common::ChildProcess;
using scan_cell_common::Durations;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;

namespace {

constexpr double kRate = 500;                // [Hz] the highest of the controller
constexpr std::size_t kBytesOfAState = 480;  // [bytes] as the emulated controller sends it
constexpr double kPatience = 30;             // [s] chosen
constexpr std::uint32_t kQueue = 100;        // messages; chosen

void join_master(const std::string& name) {
  ros::M_string no_remappings;
  ros::init(no_remappings, name, ros::init_options::NoRosout);
}

template <class Condition>
void wait_until(const std::string& what, const Condition& met) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!met()) {
    if (ros::WallTime::now() > deadline)
      throw Refused(what, "not there after 30 s", "see the messages above");
    ros::WallDuration(0.01).sleep();
  }
}

std::string free_udp_port() {
  return fmt::format("{}", scan_cell_common::free_port());
}

DriverParameters parameters(const std::string& port, int priority) {
  ros::NodeHandle node("driver");
  node.setParam("address", "127.0.0.1");
  node.setParam("port", std::stoi(port));
  node.setParam("realtime_priority", priority);
  return DriverParameters::load(node);
}

template <class Message>
void ignore(const boost::shared_ptr<const Message>&) {}

/// Moves along y, slowly enough for the motion to outlast the measurement.
void start_motion() {
  constexpr double kWay = 0.35, kSpeed = 0.02;  // [m], [m/s] chosen
  scan_cell_msgs::SetLinearSpeed speed;
  speed.request.speed = kSpeed;
  if (!ros::service::call("driver/set_linear_speed", speed) || !speed.response.success)
    throw Refused("linear speed", speed.response.message, "see the message");
  actionlib::SimpleActionClient<scan_cell_msgs::MoveAction> move("driver/move", false);
  wait_until("move action", [&] { return move.isServerConnected(); });
  scan_cell_msgs::MoveGoal goal;
  goal.pose.header.frame_id = "base_link";
  goal.pose.pose.position.x = 0.8;
  goal.pose.pose.position.y = kWay;
  goal.pose.pose.position.z = 0.6;
  goal.pose.pose.orientation.x = 1;  // looking down
  move.sendGoal(goal);
}

}  // namespace

DelayRuns::DelayRuns(const std::string& program) : program_(program) {
  join_master("bench_c4g_driver");
  wait_until("ROS master", [] { return ros::master::check(); });
}

BareRun DelayRuns::bare(double seconds) const {
  ros::NodeHandle node;
  auto transforms = node.advertise<tf2_msgs::TFMessage>("/tf", kQueue);
  auto joints = node.advertise<sensor_msgs::JointState>("joint_states", kQueue);
  auto transform = transform_message("base_link", "tool0");
  auto joint = joint_message({"joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6"});
  const std::string port = free_udp_port();
  const ChildProcess source({program_, "--run", "source", "--port", port});
  const ChildProcess listener({program_, "--run", "listener"});
  ros::AsyncSpinner spinner(1);
  spinner.start();
  wait_until("listener", [&] { return transforms.getNumSubscribers() > 0; });
  constexpr double kWait = 0.1;  // [s] chosen
  PeerSocket socket("0.0.0.0", "127.0.0.1", static_cast<std::uint16_t>(std::stoi(port)),
                    kMaxDatagramBytes);
  wait_until("source", [&] { return socket.send("hello") && socket.receive(kWait); });
  BareRun run;
  const std::uint64_t before = allocations_of_this_thread();
  const Nanoseconds end = host_now() + scan_cell_common::from_seconds(seconds);
  while (host_now() < end) {
    const auto received = socket.receive(kWait);
    if (!received) continue;
    joint.header.stamp = transform.transforms.front().header.stamp =
        scan_cell_common::to_ros(received->time);
    transforms.publish(transform);
    joints.publish(joint);
    run.delays.add(host_now() - received->time);
  }
  run.allocations = static_cast<double>(allocations_of_this_thread() - before) /
                    static_cast<double>(std::max<std::uint64_t>(1, run.delays.count()));
  return run;
}

Durations DelayRuns::driver(double seconds, int priority) const {
  const std::string port = free_udp_port();
  const auto folder = std::filesystem::path(program_).parent_path().parent_path();
  const ChildProcess controller(
      {folder / "scan_cell_sim/controller_only", "--port", port, "--stream-period", "2"}, true);
  const ChildProcess listener({program_, "--run", "listener"});
  ros::AsyncSpinner spinner(2);
  spinner.start();
  const ros::NodeHandle private_node("driver");
  const DriverNode node(ros::NodeHandle(), private_node, parameters(port, priority));
  wait_until("controller", [&] { return node.client().link().up; });
  start_motion();
  constexpr std::uint64_t kSettled = 250;  // states: half a second; chosen
  wait_until("stream", [&] { return node.client().link().stream.received > kSettled; });
  const Durations before = node.client().link().hand_on;
  ros::WallDuration(seconds).sleep();
  return node.client().link().hand_on.since(before);
}

int send_to_whoever_asks(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int opened = socket(AF_INET, SOCK_DGRAM, 0);
  if (bind(opened, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) return 1;
  std::vector<char> bytes(kBytesOfAState, ' ');
  sockaddr_in client{};
  socklen_t size = sizeof client;
  recvfrom(opened, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&client), &size);
  constexpr long kSecond = 1'000'000'000;  // [ns]
  timespec next{};
  clock_gettime(CLOCK_MONOTONIC, &next);
  while (true) {
    next.tv_nsec += static_cast<long>(kSecond / kRate);
    if (next.tv_nsec >= kSecond) {
      next.tv_nsec -= kSecond;
      ++next.tv_sec;
    }
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
    sendto(opened, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&client), size);
  }
}

int listen() {
  join_master("listener");
  ros::NodeHandle node;
  const auto transforms = node.subscribe("/tf", kQueue, &ignore<tf2_msgs::TFMessage>);
  const auto joints = node.subscribe("joint_states", kQueue, &ignore<sensor_msgs::JointState>);
  ros::spin();
  return 0;
}

}  // namespace c4g_driver
