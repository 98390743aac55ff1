// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/preparation/design_link.h"

#include <QMetaType>

#include "scan_cell/ros/service_call.h"

namespace scan_cell_rviz {
namespace {

constexpr double kDesignTimeout = 20;  // [s] the node gives up after 12, and draws a picture

}  // namespace

DesignLink::DesignLink(const NodeNames& names) : names_(names), spinner_(1, &queue_) {
  qRegisterMetaType<scan_cell_msgs::DesignPathRequest>("scan_cell_msgs::DesignPathRequest");
  qRegisterMetaType<scan_cell_msgs::DesignPathResponse>("scan_cell_msgs::DesignPathResponse");
  qRegisterMetaType<visualization_msgs::MarkerConstPtr>("visualization_msgs::MarkerConstPtr");
  node_.setCallbackQueue(&queue_);
  reference_ = node_.subscribe<visualization_msgs::Marker>(
      names_.recipes + "/reference", 1,
      [this](const auto& reference) { Q_EMIT referenceCame(reference); });
}

DesignLink::~DesignLink() {
  spinner_.stop();
  worker_.reset();  // while the receivers of its signals still exist
}

void DesignLink::start() {
  spinner_.start();
}

void DesignLink::design(const scan_cell_msgs::DesignPathRequest& request) {
  const int number = ++latest_;
  const auto task = [this, request, number] {
    // A path to be saved is saved, whatever was requested since.
    if (number != latest_ && request.save_as.empty()) return;
    const auto answer = scan_cell::ask<scan_cell_msgs::DesignPath>(names_.recipes + "/design",
                                                                   request, kDesignTimeout);
    Q_EMIT designed(request, answer);
  };
  worker_->add(task, [this](const QString& message) { Q_EMIT refused(message); });
}

}  // namespace scan_cell_rviz
