// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "binder_services.h"

#include <algorithm>
#include <chrono>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/service_answer.h"

namespace pose_frame_binder {

using scan_cell_msgs::FinishBinding;
using scan_cell_msgs::StartRun;
using scan_cell_msgs::StartScan;

BinderServices::BinderServices(ros::NodeHandle node, ros::NodeHandle private_node,
                               const Parameters& parameters)
    : parameters_(parameters),
      static_transforms_(node),
      lookup_(parameters.lookup),
      diagnostics_(node, private_node, private_node.getNamespace()) {
  constexpr std::uint32_t kBound = 20000;     // messages, as max_pending_frames; chosen
  constexpr std::uint32_t kUnbounded = 0;     // messages: no data is discarded unread
  constexpr double kDiagnosticsPeriod = 0.2;  // [s] chosen
  bound_ = private_node.advertise<scan_cell_msgs::BoundProfile>("bound_profiles", kBound);
  audit_ = private_node.advertise<scan_cell_msgs::BindingAudit>("audit", 1, true);

  ros::NodeHandle data = node;
  data.setCallbackQueue(&data_queue_);
  const boost::function<void(const scan_cell_msgs::PeakProfileConstPtr&)> on_profile =
      [this](const scan_cell_msgs::PeakProfileConstPtr& profile) {
        if (!take(profile)) ++profiles_ignored_;
      };
  const boost::function<void(const scan_cell_msgs::TriggerEventConstPtr&)> on_event =
      [this](const scan_cell_msgs::TriggerEventConstPtr& event) { take(*event); };
  const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> on_poses =
      [this](const tf2_msgs::TFMessageConstPtr& poses) { take(*poses); };
  const auto no_delay = ros::TransportHints().tcpNoDelay();
  profiles_ = data.subscribe<scan_cell_msgs::PeakProfile>("profiles", kUnbounded, on_profile,
                                                          ros::VoidConstPtr(), no_delay);
  events_ = data.subscribe<scan_cell_msgs::TriggerEvent>("trigger_events", kUnbounded, on_event,
                                                         ros::VoidConstPtr(), no_delay);
  poses_ = data.subscribe<tf2_msgs::TFMessage>("/tf", kUnbounded, on_poses, ros::VoidConstPtr(),
                                               no_delay);
  start_ = private_node.advertiseService("start", &BinderServices::start, this);
  check_run_ = private_node.advertiseService("check_run", &BinderServices::check_run, this);
  start_run_ = private_node.advertiseService("start_run", &BinderServices::start_run, this);
  finish_ = private_node.advertiseService("finish", &BinderServices::finish, this);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("binding", this, &BinderServices::diagnose);
  diagnostics_timer_ = node.createTimer(ros::Duration(kDiagnosticsPeriod),
                                        [this](const ros::TimerEvent&) { diagnostics_.update(); });
  data_spinner_.start();
}

template <class Data>
bool BinderServices::take(const Data& data) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!scan_ || !failure_.empty()) return false;
  try {
    scan_->add(data);
  } catch (const scan_cell_common::Error& error) {
    failure_ = error.what();
    ROS_ERROR("scan %s: %s", scan_id_.c_str(), error.what());
  }
  publish_bound();
  if (finishing_) news_.notify_all();
  return true;
}

void BinderServices::publish_bound() {
  for (const scan_cell_msgs::BoundProfileConstPtr& bound : scan_->take()) {
    lookup_.add(*bound);
    bound_.publish(bound);
  }
}

bool BinderServices::start(StartScan::Request& request, StartScan::Response& response) {
  return scan_cell_common::answer(response, [&] {
    const Eigen::Isometry3d fixed_to_base = static_transforms_.look_up(
        parameters_.frames.fixed, parameters_.frames.base, parameters_.transform_timeout);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (finishing_) {
      throw scan_cell_common::Refused("scan " + scan_id_, "not finished yet", "wait for its audit");
    }
    scan_ =
        std::make_unique<ProfileBinder>(parameters_.settings, parameters_.frames, fixed_to_base);
    scan_id_ = request.scan_id;
    lookup_.start();
    failure_.clear();
    profiles_ignored_ = 0;
  });
}

bool BinderServices::check_run(StartRun::Request& request, StartRun::Response& response) {
  return scan_cell_common::answer(response, [&] {
    const auto anywhere = Eigen::Isometry3d::Identity();  // the check holds wherever the base is
    check(run_from(request.run, parameters_.frames, anywhere), parameters_.settings);
  });
}

bool BinderServices::start_run(StartRun::Request& request, StartRun::Response& response) {
  return scan_cell_common::answer(response, [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!scan_) throw scan_cell_common::Refused("run", "no scan is under way", "call ~start first");
    scan_->start_run(request.run);
  });
}

void BinderServices::wait_for_all(std::unique_lock<std::mutex>& lock, std::uint64_t triggers,
                                  double timeout) {
  const auto all = [this, triggers] {
    Binder& binder = scan_->binder();
    if (binder.pulses() >= triggers) {
      binder.end_pulses();
      publish_bound();
    }
    return binder.whole(triggers) || !failure_.empty() || !ros::ok();
  };
  finishing_ = true;
  // Poses arrive as long as the robot runs, and frames as long as a camera runs free; neither means
  // that pulses will arrive.
  std::uint64_t most = 0;
  do {
    most = std::max(most, scan_->binder().progress());
  } while (!news_.wait_for(lock, std::chrono::duration<double>(timeout), all) &&
           scan_->binder().progress() > most);
  finishing_ = false;
}

bool BinderServices::finish(FinishBinding::Request& request, FinishBinding::Response& response) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!scan_ || finishing_) {
    response.success = false;
    response.message = scan_ ? "scan " + scan_id_ + " is not finished yet; wait for its audit"
                             : "no scan is running; call start first";
    return true;
  }
  wait_for_all(lock, request.triggers, request.timeout.toSec());
  scan_->binder().end(request.triggers);
  publish_bound();
  last_audit_ = scan_->binder().audit();
  response.audit = to_message(last_audit_, scan_id_, ros::Time::now());
  audit_.publish(response.audit);
  lookup_.finish();
  scan_.reset();

  response.success = failure_.empty() && last_audit_.triggers_missing == 0;
  response.message = failure_.empty() ? summary(last_audit_) : failure_;
  ROS_INFO("scan %s: %s", scan_id_.c_str(), response.message.c_str());
  return true;
}

void BinderServices::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  const Audit audit = scan_ ? scan_->binder().counts() : last_audit_;
  status.summary(failure_.empty() ? Level::OK : Level::ERROR,
                 failure_.empty() ? (scan_ ? "binding scan " + scan_id_ : "idle") : failure_);
  status.add("frames", audit.frames);
  status.add("frames bound", audit.frames_bound);
  status.add("frames dropped", audit.frames_dropped);
  status.add("frames of an uncertain laser", audit.frames_laser_uncertain);
  status.add("pulses", audit.triggers);
  status.add("pulses missing", audit.triggers_missing);
  status.add("pulses refused", audit.triggers_refused);
  status.add("poses", audit.poses);
  status.add("poses late", audit.poses_late);
  status.add("poses repeated", audit.poses_repeated);
  status.add("poses unusable", audit.poses_unusable);
  status.add("counter slips", audit.slips);
  status.add("stamp after pulse [s]", audit.latency);
  status.add("profiles outside of a scan", profiles_ignored_.load());
}

}  // namespace pose_frame_binder
