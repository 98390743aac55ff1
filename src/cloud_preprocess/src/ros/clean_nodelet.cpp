// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clean_nodelet.h"

#include <fmt/format.h>
#include <scan_cell_common/errors/errors.h>
#include <scan_cell_common/parameters/parameter_table.h>
#include <scan_cell_common/ros/load_parameters.h>
#include <scan_cell_common/ros/service_answer.h>
#include <scan_cell_msgs/ObjectClouds.h>

#include "load_finder.h"
#include "stage_reports.h"

namespace cloud_preprocess {

void describe(scan_cell_common::ParameterTable& table, CleanNodeletParameters& parameters) {
  describe(table, parameters.target);
  table.add("reduce", parameters.reduce, "true: the clean clouds are reduced by the grid");
  describe(table, parameters.stages);
}

namespace {

CleanNodeletParameters load(const ros::NodeHandle& own) {
  auto parameters = scan_cell_common::load_parameters<CleanNodeletParameters>(own);
  parameters.stages.isolate.finder = load_finder(parameters.stages.isolate);
  return parameters;
}

}  // namespace

void CleanNodelet::start() {
  parameters_ = load(getPrivateNodeHandle());
  frames_.set_target(parameters_.target, getNodeHandle());
  constexpr bool kLatched = true;
  constexpr int kReports = 10;  // more than one cloud's stages
  ros::NodeHandle node = getPrivateNodeHandle();
  clean_cloud_ = node.advertise<sensor_msgs::PointCloud2>("clean_cloud", 1, kLatched);
  objects_ = node.advertise<scan_cell_msgs::ObjectClouds>("objects", 1, kLatched);
  report_ = node.advertise<scan_cell_msgs::PreprocessReport>("report", kReports, kLatched);
  apply_ = node.advertiseService("apply", &CleanNodelet::apply, this);
  input_ = getNodeHandle().subscribe("input", 2, &CleanNodelet::on_cloud, this);
}

void CleanNodelet::on_cloud(const sensor_msgs::PointCloud2ConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_ = message;
  clean_and_publish(*message);
}

bool CleanNodelet::apply(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return scan_cell_common::answer(response, [&] {
    parameters_ = load(getPrivateNodeHandle());
    frames_.set_target(parameters_.target, getNodeHandle());
    if (!latest_) return;
    const std::string failure = clean_and_publish(*latest_);
    if (!failure.empty())
      throw scan_cell_common::Refused("latest cloud", "cannot be cleaned with these parameters",
                                      failure);
  });
}

std::string CleanNodelet::clean_and_publish(const sensor_msgs::PointCloud2& message) {
  std_msgs::Header header = message.header;
  std::vector<StageReport> reports;
  std::string failure;
  try {
    run(message, header, reports);
  } catch (const scan_cell_common::Error& error) {
    failure = error.what();
    NODELET_ERROR("%s", error.what());
    if (reports.empty())
      reports.push_back({"input", std::size_t{message.width} * message.height, 0, 0, ""});
  }
  for (const StageReport& report : reports)
    report_.publish(to_message(report, &report == &reports.back() ? failure : "", header));
  return failure;
}

void CleanNodelet::run(const sensor_msgs::PointCloud2& message, std_msgs::Header& header,
                       std::vector<StageReport>& reports) {
  Eigen::Isometry3f motion;
  TracedCloud cloud = frames_.places_of(message, motion);
  header = frames_.header_of(header);
  CleanParameters stages = parameters_.stages;
  if (!parameters_.reduce) stages.grid.reset();
  std::vector<TracedCloud> objects;
  clean(cloud, stages, reports, objects);
  scan_cell_msgs::ObjectClouds clouds;
  clouds.header = header;
  for (const TracedCloud& object : objects)
    clouds.clouds.push_back(*to_message(object, message, motion, header));
  objects_.publish(clouds);
  clean_cloud_.publish(to_message(cloud, message, motion, header));
}

}  // namespace cloud_preprocess
