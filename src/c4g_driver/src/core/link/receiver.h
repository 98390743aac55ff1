// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "c4g_driver/link_report.h"
#include "wire/codec.h"
#include "wire/peer_socket.h"

namespace c4g_driver {

/// Receives the controller's datagrams in its own thread, and counts malformed ones.
class Receiver {
 public:
  /// Called in the receiver's thread. @param arrival when the kernel received the datagram
  using Handler = std::function<void(const Reply&, scan_cell_common::Nanoseconds arrival)>;

  /// @param realtime_priority of the thread, SCHED_FIFO; 0: normal scheduling
  /// @throw scan_cell_common::InvalidParameter if the priority is not permitted
  Receiver(PeerSocket& socket, int realtime_priority, Handler handler);
  ~Receiver();

  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;

  Malformed malformed() const;

 private:
  void raise_priority(int realtime_priority);
  void receive();
  void end();

  PeerSocket& socket_;
  const Handler handler_;
  mutable std::mutex mutex_;  // guards malformed_
  Malformed malformed_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace c4g_driver
