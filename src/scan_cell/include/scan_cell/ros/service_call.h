// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/service.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "scan_cell_common/errors.h"

namespace scan_cell {

/// Calls a service and waits at most `timeout` [s]: roscpp alone would wait for ever on a node that
/// hangs.
/// @throw ConnectionError if there is no such service, or no answer in time
/// @throw Refused with the service's own message if it answers success: false
template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request,
                                double timeout) {
  if (!ros::service::exists(name, false)) {
    throw scan_cell_common::ConnectionError(name, "no such service", "is its node running?");
  }
  struct Call {
    Service service;
    std::promise<bool> answered;
  };
  const auto shared = std::make_shared<Call>();  // outlives a call that is given up
  shared->service.request = request;
  std::future<bool> answered = shared->answered.get_future();
  std::thread([shared, name] {
    shared->answered.set_value(ros::service::call(name, shared->service));
  }).detach();
  if (answered.wait_for(std::chrono::duration<double>(timeout)) != std::future_status::ready ||
      !answered.get()) {
    throw scan_cell_common::ConnectionError(
        name, "no answer within " + std::to_string(timeout) + " s", "is its node alive?");
  }
  if (!shared->service.response.success) {
    throw scan_cell_common::Refused(name, "refused", shared->service.response.message);
  }
  return shared->service.response;
}

}  // namespace scan_cell
