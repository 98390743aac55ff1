// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

/// Runs the work of a service call, and fills in the answer's `success` and, on an Error, its
/// `message`. Other exceptions pass.
/// @return true, so that ROS sends the answer
template <class Response, class Body>
bool answer(Response& response, const Body& body) {
  try {
    body();
    response.success = true;
  } catch (const Error& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

}  // namespace scan_cell_common
