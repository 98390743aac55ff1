// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// Ensures that only one activity at a time uses the cell. Thread-safe.
class CellInUse {
 public:
  /// @param kind such as "scan" @param name of this one
  /// @throw scan_cell_common::Refused naming the activity that has the cell
  void take(const std::string& kind, const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!kind_.empty()) {
      throw scan_cell_common::Refused(kind_, "'" + name_ + "' is running",
                                      "wait for it, or cancel it");
    }
    kind_ = kind;
    name_ = name;
  }

  /// Names the activity that has the cell, once its name is known.
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
