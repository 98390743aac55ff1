// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// @throw ConnectionError if the driver has lost the controller, Refused if one of them refuses
template <class Service>
typename Service::Response call_driver(const std::string& name,
                                       const typename Service::Request& request, double timeout) {
  const typename Service::Response response = ask<Service>(name, request, timeout);
  if (response.link_lost) {
    throw scan_cell_common::ConnectionError(name, "link lost", response.message);
  }
  check_answer(name, response);
  return response;
}

}  // namespace scan_cell
