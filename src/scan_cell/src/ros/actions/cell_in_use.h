// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// One thing at a time moves the robot. Safe for use from several threads.
class CellInUse {
 public:
  /// @param kind such as "scan" @param name of this one
  /// @throw scan_cell_common::Refused naming what has the cell
  void take(const std::string& kind, const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!kind_.empty()) {
      throw scan_cell_common::Refused(kind_, "'" + name_ + "' is running",
                                      "wait for it, or cancel it");
    }
    kind_ = kind;
    name_ = name;
  }

  /// Names what has the cell, once that is known.
  void rename(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    name_ = name;
  }

  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    kind_.clear();
  }

 private:
  std::mutex mutex_;
  std::string kind_;  // empty: free
  std::string name_;
};

}  // namespace scan_cell
