// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/service.h>

#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// Calls a service and waits at most `timeout` [s]. roscpp alone would wait for ever for a node or
/// a master that hangs, and minutes for a computer that is gone.
/// @throw ConnectionError if there is no such service, or no answer in time
template <class Service>
typename Service::Response ask(const std::string& name, const typename Service::Request& request,
                               double timeout) {
  enum class End { kNoService, kNoAnswer, kAnswered };
  struct Call {
    Service service;
    std::promise<End> end;
  };
  const auto shared = std::make_shared<Call>();  // outlives an abandoned call
  shared->service.request = request;
  std::future<End> future = shared->end.get_future();
  std::thread([shared, name] {
    try {
      // Looked up only if the call fails, since that takes as long as the call. A service found
      // then may just have come up, as when a cell starts, so it is called once more.
      bool answered = ros::service::call(name, shared->service);
      const bool exists = answered || ros::service::exists(name, false);
      if (!answered && exists) answered = ros::service::call(name, shared->service);
      shared->end.set_value(answered ? End::kAnswered : exists ? End::kNoAnswer : End::kNoService);
    } catch (const std::exception& error) {  // from an invalid name
      ROS_ERROR("%s: %s", name.c_str(), error.what());
      shared->end.set_value(End::kNoService);
    }
  }).detach();
  const bool ended =
      future.wait_for(std::chrono::duration<double>(timeout)) == std::future_status::ready;
  const End end = ended ? future.get() : End::kNoAnswer;
  if (end == End::kNoService) {
    throw scan_cell_common::ConnectionError(name, "no such service", "is its node running?");
  }
  if (end == End::kNoAnswer) {
    throw scan_cell_common::ConnectionError(name, fmt::format("no answer within {:g} s", timeout),
                                            "is its node alive?");
  }
  return shared->service.response;
}

/// Throws the message of a service's answer if it was success: false.
template <class Response>
void check_answer(const std::string& name, const Response& response) {
  if (!response.success) throw scan_cell_common::Refused(name, "refused", response.message);
}

/// As ask(), for services whose answer is only valid on success.
/// @throw Refused with the service's own message if it answers success: false
template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request,
                                double timeout) {
  const typename Service::Response response = ask<Service>(name, request, timeout);
  check_answer(name, response);
  return response;
}

}  // namespace scan_cell
