// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>

#include <memory>
#include <string>
#include <utility>

namespace scan_cell_rviz {

/// A server of interactive markers that starts with its first marker. If rviz is told to end while
/// it starts, no server may start any more: the library would abort the process.
class HandleServer {
 public:
  using Taken = interactive_markers::InteractiveMarkerServer::FeedbackCallback;

  /// @param topic its namespace
  explicit HandleServer(std::string topic) : topic_(std::move(topic)) {}

  const std::string& topic() const { return topic_; }

  void clear();
  void insert(const visualization_msgs::InteractiveMarker& marker, const Taken& taken);
  void apply();

 private:
  const std::string topic_;
  std::unique_ptr<interactive_markers::InteractiveMarkerServer> server_;
};

}  // namespace scan_cell_rviz
