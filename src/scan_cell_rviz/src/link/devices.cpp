// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// What the link receives from the devices, and which of their nodes are running.
#include "link/cell_link.h"
#include "scan_cell_common/ros/node_process.h"
#include "signs/signs.h"

namespace scan_cell_rviz {

void CellLink::on_diagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics) {
  const std::string prefix = names_.camera.substr(1) + ": ";  // of diagnostic_updater
  for (const diagnostic_msgs::DiagnosticStatus& status : diagnostics.status) {
    if (status.name.rfind(prefix, 0) != 0) continue;
    camera_seen_ = ros::WallTime::now();
    show(Device::kCamera, sign_of(status));
  }
}

void CellLink::show(Device device, const Sign& sign) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    Sign& shown = signs_.at(static_cast<std::size_t>(device));
    if (shown == sign) return;
    shown = sign;
  }
  Q_EMIT signChanged(device, sign);
}

void CellLink::hear(Device device, const Sign& sign) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.at(static_cast<std::size_t>(device)) = sign;
  }
  show(device, sign);
}

/// Shows the last state of a device, unless its node is gone.
void CellLink::show_presence(Device device, const ros::Subscriber& subscriber) {
  std::optional<Sign> sign;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    sign = missed_.count(subscriber.getTopic()) > 0
               ? Sign{Level::kGone, subscriber.getTopic() + ": its node is not running"}
               : heard_.at(static_cast<std::size_t>(device));
  }
  if (sign) show(device, *sign);
}

/// Has its own worker: each check of a computer that is gone takes a second.
void CellLink::look_for_nodes() {
  if (looking_.exchange(true)) return;
  presence_worker_->add([this] {
    const ros::Subscriber* const all[] = {&robot_, &trigger_, &cell_, &actions_->of_recipes()};
    for (const ros::Subscriber* const subscriber : all) {
      const std::string topic = subscriber->getTopic();
      const std::optional<bool> there = scan_cell_common::is_published(topic);
      const std::lock_guard<std::mutex> lock(mutex_);
      if (there && *there) missed_.erase(topic);
      if (there && !*there) missed_.insert(topic);
    }
    looking_ = false;
  });
}

bool CellLink::is_missed(const ros::Subscriber& subscriber) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return missed_.count(subscriber.getTopic()) > 0;
}

}  // namespace scan_cell_rviz
