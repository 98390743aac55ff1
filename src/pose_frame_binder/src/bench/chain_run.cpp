// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include <fmt/format.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <sensor_msgs/PointCloud2.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "arrivals.h"
#include "laser_triangulation/triangulator.h"
#include "started_chain.h"

namespace pose_frame_binder {

using scan_cell_common::ChildProcess;
using scan_cell_common::Usage;
using scan_cell_common::usage_of;

namespace {

constexpr double kMilliseconds = 1e3;  // [ms] in a second
constexpr double kPercent = 100;
constexpr double kPointSize = sizeof(laser_triangulation::ScanPoint) / 1e6;  // [MB]

/// Usage of the processes, and the share of the thread that sends and counts.
struct Sample {
  Usage usage;
  double own_cpu = 0;  // [s]
  double points = 0;
  Instant time;
};

/// Feeds all frames; takes samples after a sixth of the time and at the end.
template <class Take>
std::pair<Sample, Sample> feed(ProfileFeeder& feeder, const Pace& pace, const Take& take) {
  feeder.start();
  ros::WallDuration(pace.seconds / 6).sleep();
  const Sample early = take();
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(2 * pace.seconds);
  while (!feeder.done() && ros::WallTime::now() < deadline)
    ros::WallDuration(0.001).sleep();
  if (!feeder.done())
    throw scan_cell_common::Refused("feeder", "far too slow", "stop other programs");
  return {early, take()};
}

void print_feeder(const ProfileFeeder& feeder) {
  const std::chrono::duration<double> span = feeder.sent().back() - feeder.sent().front();
  std::printf("  %zu profiles sent at %.1f/s, the latest %.1f ms behind its time\n",
              feeder.sent().size(), static_cast<double>(feeder.sent().size() - 1) / span.count(),
              feeder.seconds_late() * kMilliseconds);
}

void print_latency(const char* span, const Latency& latency) {
  std::printf("  %s: p50 %.1f ms, p99 %.1f ms, worst %.1f ms, of the last one %.1f ms\n", span,
              latency.median * kMilliseconds, latency.p99 * kMilliseconds,
              latency.worst * kMilliseconds, latency.last * kMilliseconds);
}

void print_usage(const std::pair<Sample, Sample>& samples, double point_size) {
  const auto& [early, end] = samples;
  const std::chrono::duration<double> span = end.time - early.time;
  const double cpu = end.usage.cpu - early.usage.cpu - (end.own_cpu - early.own_cpu);
  std::printf(
      "  %.0f %% of one core; memory without the points of the cloud: %.0f MB at a sixth of "
      "the run, %.0f MB at its end\n",
      cpu / span.count() * kPercent, early.usage.memory - early.points * point_size,
      end.usage.memory - end.points * point_size);
}

/// How the scan of a fed chain ended.
struct Ended {
  scan_cell_msgs::BindingAudit audit;
  scan_cell_msgs::FinishCloud::Response cloud;
};

Ended finish(const Pace& pace) {
  constexpr double kTimeout = 5;  // [s] chosen
  scan_cell_msgs::FinishBinding::Request binding;
  binding.triggers = pace.frames();
  binding.timeout = ros::Duration(kTimeout);
  Ended ended;
  ended.audit = call<scan_cell_msgs::FinishBinding>("/binder/finish", binding).audit;
  scan_cell_msgs::FinishCloud::Request cloud;
  cloud.profiles = ended.audit.frames_bound;
  cloud.timeout = ros::Duration(kTimeout);
  cloud.partial = true;
  ended.cloud = call<scan_cell_msgs::FinishCloud>("/triangulation/finish", cloud);
  if (!ended.cloud.file.empty())
    std::filesystem::remove(ended.cloud.file);  // the cloud, if too large for the answer
  return ended;
}

}  // namespace

int run_chain(const std::string& program, const std::string& kind, const Pace& pace) {
  join_master("bench_" + kind);
  ros::NodeHandle node;
  const std::uint64_t points = pace.frames() * pace.rows;
  const StartedChain chain(program, kind == "nodelets");
  Arrivals arrivals;
  arrivals.subscribe<sensor_msgs::PointCloud2>(
      node, "/triangulation/cloud",
      [](const sensor_msgs::PointCloud2& cloud) { return cloud.width; });
  ProfileFeeder feeder(node, pace);
  wait_until("the chain's topics", [&] { return arrivals.subscribed() && feeder.all_heard(); });
  const auto samples = feed(feeder, pace, [&] {
    const double own = chain.here() ? feeder.cpu() + arrivals.cpu() : 0;
    return Sample{chain.usage(), own, static_cast<double>(arrivals.count()),
                  std::chrono::steady_clock::now()};
  });
  const Ended ended = finish(pace);
  const std::uint64_t triangulated = ended.cloud.statistics.profiles;
  arrivals.wait(points);

  std::printf("%s\n", chain.here() ? "nodelets in one process" : "two nodes");
  print_feeder(feeder);
  std::printf(
      "  %lu bound, %lu triangulated, %lu lost (goal 0); %lu of %lu points came on ~cloud\n",
      ended.audit.frames_bound, triangulated, pace.frames() - triangulated, arrivals.count(),
      points);
  print_latency("from a profile to the arrival of its last point (goal 50 ms, p99)",
                latency_of(feeder.sent(), arrivals.all(), pace.rows));
  print_usage(samples, kPointSize);
  if (!ended.cloud.success) std::printf("  ~finish: %s\n", ended.cloud.message.c_str());
  return 0;
}

int run_relays(const std::string& program, const Pace& pace) {
  join_master("bench_relays");
  ros::NodeHandle node;
  const ChildProcess first({program, "--run", "relay", "--from", "/profiles", "--to", "/half_way"});
  const ChildProcess second(
      {program, "--run", "relay", "--from", "/half_way", "--to", "/handed_on"});
  Arrivals arrivals;
  arrivals.subscribe<scan_cell_msgs::PeakProfile>(
      node, "/handed_on", [](const scan_cell_msgs::PeakProfile&) { return 1; });
  ProfileFeeder feeder(node, pace);
  wait_until("the relays' topics",
             [&] { return arrivals.subscribed() && feeder.profiles_heard(); });
  const auto samples = feed(feeder, pace, [&] {
    const Usage a = usage_of(first.id()), b = usage_of(second.id());
    return Sample{{a.cpu + b.cpu, a.memory + b.memory}, 0, 0, std::chrono::steady_clock::now()};
  });
  arrivals.wait(pace.frames());
  std::printf("yardstick: two nodes that only hand the profiles on\n");
  print_feeder(feeder);
  print_latency("from a profile to its arrival", latency_of(feeder.sent(), arrivals.all(), 1));
  print_usage(samples, 0);
  return 0;
}

int relay(const std::string& from, const std::string& to) {
  join_master(fmt::format("relay{}", getpid()));
  ros::NodeHandle node;
  constexpr std::uint32_t kUnbounded = 0;  // messages
  const ros::Publisher publisher = node.advertise<scan_cell_msgs::PeakProfile>(to, kUnbounded);
  const boost::function<void(const scan_cell_msgs::PeakProfileConstPtr&)> hand_on =
      [&publisher](const scan_cell_msgs::PeakProfileConstPtr& profile) {
        publisher.publish(profile);
      };
  const ros::Subscriber subscriber = node.subscribe<scan_cell_msgs::PeakProfile>(
      from, kUnbounded, hand_on, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
  return 0;
}

}  // namespace pose_frame_binder
