// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <scan_cell_msgs/StartRun.h>

#include <cstdio>

#include "client/adaptation.h"
#include "client/bag_replay.h"
#include "client/clean_cloud_watch.h"
#include "devices/ros_stages.h"
#include "replay_parameters.h"
#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

using Parameters = scan_cell::ReplayParameters;

void wait_for_services(const Parameters& parameters) {
  for (const std::string& name :
       {parameters.binder + "/start", parameters.binder + "/finish",
        parameters.triangulation + "/start", parameters.triangulation + "/finish"}) {
    if (!ros::service::waitForService(name, ros::Duration(parameters.timeout))) {
      throw scan_cell_common::ConnectionError(name, "no such service", "is its node running?");
    }
  }
}

/// @throw Refused if the path was refused, or preprocessing failed
void replay(const Parameters& parameters) {
  scan_cell::clear_results(parameters.files);
  const scan_cell::CellClient::Names names;
  ros::NodeHandle node;
  scan_cell::BagReplay bag(parameters.bag, parameters.scan_id, {});
  if (!bag.scan().whole) ROS_WARN("Scan '%s' ended early", bag.scan().scan_id.c_str());
  scan_cell::RosStages stages(parameters.binder, parameters.triangulation, parameters.timeout);
  scan_cell::CleanCloudWatch watch(node, names.clean_cloud, names.report);
  scan_cell::CellClient client(node, names);
  scan_cell::ProgressBar bar("replay '" + bag.scan().scan_id + "'");

  wait_for_services(parameters);
  stages.start(bag.scan().scan_id);
  for (const scan_cell_msgs::ScanRun& run : bag.scan().runs) {
    scan_cell_msgs::StartRun::Request request;
    request.run = run;
    scan_cell::call<scan_cell_msgs::StartRun>(parameters.binder + "/start_run", request,
                                              parameters.timeout);
  }
  bag.play(node, parameters.speed, parameters.timeout,
           [&bar](double share) { bar.show("play", 0.5 * share); });
  bar.show("bind and triangulate", 0.5);
  watch.forget();
  stages.bind({{0, bag.pulses()}}, parameters.patience);  // of all armings
  stages.triangulate(true, parameters.patience);
  if (!stages.disagreement().empty())
    throw scan_cell_common::Refused("scan '" + bag.scan().scan_id + "'", "no single surface",
                                    stages.disagreement());
  bar.show("clean", 0.6);
  scan_cell::check_published(stages.cloud_file());
  const auto object = watch.wait(stages.cloud().header.stamp, parameters.timeout);
  const auto verdict = scan_cell::adapt(
      client, parameters.files, object, parameters.timeout,
      [&bar](const std::string& stage, double share) { bar.show(stage, 0.7 + 0.3 * share); },
      stages.statistics());
  std::printf("%lu frames bound, %lu dropped, %lu never arrived; path %s\n",
              stages.audit().frames_bound, stages.audit().frames_dropped,
              stages.audit().frames_never_arrived, verdict.name.c_str());
  if (verdict.reason != scan_cell_msgs::StretchVerdict::ACCEPTED) {
    throw scan_cell_common::Refused("path", verdict.name, verdict.message);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return scan_cell_common::node_main<Parameters>(
      argc, argv, "replay",
      "Plays a recorded scan to the running stages, and adapts a "
      "tool path to what was scanned (launch/replay.launch).",
      [] {
        const auto parameters = scan_cell_common::load_parameters<Parameters>(ros::NodeHandle("~"));
        ros::AsyncSpinner spinner(2);
        spinner.start();
        replay(parameters);
      });
}
