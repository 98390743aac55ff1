// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

namespace part_recipes {

/// Fills a service's answer, or says in it why that failed.
/// @return always true: the service was called
template <class Response, class Fill>
bool answer(Response& response, const Fill& fill) {
  try {
    fill();
    response.success = 1;
  } catch (const std::exception& error) {  // of a file system, too: no request may end the node
    response.message = error.what();
  }
  return true;
}

}  // namespace part_recipes
