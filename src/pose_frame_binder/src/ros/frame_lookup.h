// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/BoundProfile.h>

#include <memory>
#include <mutex>
#include <string>

#include "lookup_server.h"
#include "poses/pose_table.h"

namespace pose_frame_binder {

struct LookupParameters {
  std::string address = "127.0.0.1";
  int port = 0;  //!< 0: no lookup
  LookupLimits limits;
};

/// The thesis' lookup over TCP: the pose of a frame of the scan finished last.
class FrameLookup {
 public:
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  explicit FrameLookup(const LookupParameters& parameters);

  /// A scan begins: lookups find nothing until it is finished.
  void start();
  void add(const scan_cell_msgs::BoundProfile& bound);
  void finish();

 private:
  const bool on_;
  PoseTable collected_;

  std::mutex mutex_;
  PoseTable finished_;
  std::unique_ptr<LookupServer> server_;  // last member, so that it ends before what it uses
};

}  // namespace pose_frame_binder
