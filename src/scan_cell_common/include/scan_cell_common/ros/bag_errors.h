// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

/// Runs work that opens, reads or writes a bag, and turns its errors into FileError. Errors of
/// rosbag and of message deserialisation name neither the file nor a cure ("Buffer Overrun"). The
/// suite's own errors pass unchanged.
/// @throw FileError
template <class Work>
void name_bag_in_errors(const std::string& path, const Work& work) {
  try {
    work();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw FileError(path, error.what(),
                    "check the path and the disk, try rosbag reindex, or record it again");
  }
}

}  // namespace scan_cell_common
