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

enum class CallEnd { kNoService, kLost, kLate, kAnswered };

/// Calls a service once, however long that takes.
template <class Service>
CallEnd call_once(const std::string& name, Service& service) {
  // Persistent: otherwise the server closes the connection behind its answer, and roscpp may lose
  // that answer (github.com/ros/ros_comm/issues/1976).
  constexpr bool kPersistent = true;
  ros::ServiceClient client = ros::service::createClient<Service>(name, kPersistent);
  if (!client.isValid()) {
    // Nothing was sent: the service may just have come up, as when a cell starts.
    if (!ros::service::exists(name, false)) return CallEnd::kNoService;
    client = ros::service::createClient<Service>(name, kPersistent);
  }
  // Never called again: the service may have acted although its answer did not come.
  if (client.isValid() && client.call(service)) return CallEnd::kAnswered;
  return ros::service::exists(name, false) ? CallEnd::kLost : CallEnd::kNoService;
}

/// @param timeout [s] for the words
/// @throw ConnectionError unless the service answered
inline void check_end(CallEnd end, const std::string& name, double timeout) {
  using scan_cell_common::ConnectionError;
  switch (end) {
    case CallEnd::kAnswered:
      return;
    case CallEnd::kNoService:
      throw ConnectionError(name, "no such service", "is its node running?");
    case CallEnd::kLost:
      throw ConnectionError(name, "no answer: connection lost",
                            "is its node alive? It may have acted nevertheless");
    case CallEnd::kLate:
      throw ConnectionError(name, fmt::format("no answer within {:g} s", timeout),
                            "is its node alive?");
  }
}

/// Calls a service once, and waits at most `timeout` [s]. roscpp alone would wait for ever for a
/// node or a master that hangs, and minutes for a computer that is gone.
/// @throw ConnectionError if there is no such service, or no answer in time
template <class Service>
typename Service::Response ask(const std::string& name, const typename Service::Request& request,
                               double timeout) {
  struct Call {
    Service service;
    std::promise<CallEnd> end;
  };
  const auto shared = std::make_shared<Call>();  // outlives an abandoned call
  shared->service.request = request;
  std::future<CallEnd> future = shared->end.get_future();
  std::thread([shared, name] {
    try {
      shared->end.set_value(call_once(name, shared->service));
    } catch (const std::exception& error) {  // from an invalid name
      ROS_ERROR("%s: %s", name.c_str(), error.what());
      shared->end.set_value(CallEnd::kNoService);
    }
  }).detach();
  const bool ended =
      future.wait_for(std::chrono::duration<double>(timeout)) == std::future_status::ready;
  check_end(ended ? future.get() : CallEnd::kLate, name, timeout);
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
