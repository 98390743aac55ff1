// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/preparation/teach_link.h"

#include <scan_cell_msgs/RecordPose.h>

#include <QMetaType>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_rviz {
namespace {

constexpr double kTell = 0.1;          // [s] between joint readings, for a person; chosen
constexpr double kRecordTimeout = 10;  // [s] the robot must stand still first; chosen

QString words_of(const scan_cell_msgs::RecordPoseResponse& answer, const QString& file) {
  using scan_cell_common::kMillimetres;
  const geometry_msgs::Point& place = answer.pose.pose.position;
  return TeachLink::tr("Pose %1 of %2: %3, %4, %5 mm in %6")
      .arg(answer.poses)
      .arg(file)
      .arg(place.x * kMillimetres, 0, 'f', 2)
      .arg(place.y * kMillimetres, 0, 'f', 2)
      .arg(place.z * kMillimetres, 0, 'f', 2)
      .arg(QString::fromStdString(answer.pose.header.frame_id));
}

}  // namespace

TeachLink::TeachLink(const NodeNames& names) : names_(names), spinner_(1, &queue_) {
  qRegisterMetaType<scan_cell_msgs::JogState>("scan_cell_msgs::JogState");
  qRegisterMetaType<std::vector<double>>("std::vector<double>");
  node_.setCallbackQueue(&queue_);
  jog_ = node_.advertise<scan_cell_msgs::Jog>(names_.robot + "/jog", 10);
  state_ = node_.subscribe<scan_cell_msgs::JogState>(
      names_.robot + "/jog_state", 10, [this](const auto& state) { Q_EMIT jogTold(*state); });
  joints_ = node_.subscribe<sensor_msgs::JointState>(
      names_.joints, 1, [this](const auto& joints) { latest_ = joints; });
  timer_ = node_.createWallTimer(ros::WallDuration(kTell), [this](const auto&) { tell_joints(); });
}

TeachLink::~TeachLink() {
  spinner_.stop();
  worker_.reset();  // while the receivers of its signals still exist
}

void TeachLink::start() {
  spinner_.start();
}

void TeachLink::record(const QString& file) {
  const auto task = [this, file] {
    scan_cell_msgs::RecordPose::Request request;
    request.file = file.toStdString();
    const auto answer = scan_cell::call<scan_cell_msgs::RecordPose>(names_.cell + "/record_pose",
                                                                    request, kRecordTimeout);
    Q_EMIT recorded(words_of(answer, file));
  };
  worker_->add(task, [this](const QString& message) { Q_EMIT failed(message); });
}

void TeachLink::tell_joints() {
  if (latest_ == nullptr) return;
  Q_EMIT jointsCame(latest_->position);
  latest_.reset();
}

}  // namespace scan_cell_rviz
