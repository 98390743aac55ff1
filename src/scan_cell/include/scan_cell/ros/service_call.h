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

/// Asks a service and waits at most `timeout` [s]: roscpp alone would wait for ever on a node that
/// hangs.
/// @throw ConnectionError if there is no such service, or no answer in time
template <class Service>
typename Service::Response ask(const std::string& name, const typename Service::Request& request,
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
  return shared->service.response;
}

/// Throws what a service answered, if it was success: false.
template <class Response>
void check_answer(const std::string& name, const Response& response) {
  if (!response.success) throw scan_cell_common::Refused(name, "refused", response.message);
}

/// As ask(), for services whose answer is only good where they succeed.
/// @throw Refused with the service's own message if it answers success: false
template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request,
                                double timeout) {
  const typename Service::Response response = ask<Service>(name, request, timeout);
  check_answer(name, response);
  return response;
}

}  // namespace scan_cell
