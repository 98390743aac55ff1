// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/listeners.h"

#include <utility>

namespace scan_cell_common {

Listeners::Listeners(OnGone on_gone) : on_gone_(std::move(on_gone)) {}

bool Listeners::contains(const std::string& node) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return nodes_.count(node) > 0;
}

void Listeners::come(const std::string& node) {
  const std::lock_guard<std::mutex> lock(mutex_);
  nodes_.insert(node);
}

void Listeners::go(const std::string& node) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto gone = nodes_.find(node);
    if (gone != nodes_.end()) nodes_.erase(gone);
    if (nodes_.count(node) > 0) return;
  }
  if (on_gone_) on_gone_(node);
}

}  // namespace scan_cell_common
