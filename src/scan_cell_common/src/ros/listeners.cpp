// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/listeners.h"

#include <utility>

namespace scan_cell_common {

Listeners::Listeners(OnGone on_gone) : on_gone_(std::move(on_gone)) {}

bool Listeners::contains(const std::string& node) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = nodes_.find(node);
  return found != nodes_.end() && found->second > 0;
}

void Listeners::come(const std::string& node) {
  count(node, +1);
}

void Listeners::go(const std::string& node) {
  if (count(node, -1) <= 0 && on_gone_) on_gone_(node);
}

int Listeners::count(const std::string& node, int change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const int connections = nodes_[node] += change;
  if (connections == 0) nodes_.erase(node);
  return connections;
}

}  // namespace scan_cell_common
