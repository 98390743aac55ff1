// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "scan_cell_common/net/line_server.h"

namespace pose_frame_binder {

struct LookupLimits {
  int max_clients = 4;         //!< at a time; further ones get an error and are disconnected
  std::size_t max_bytes = 64;  //!< of a line
  double idle_time = 60;       //!< [s] a client that sends nothing for this long is disconnected
};

/// Answers lines over TCP: one line in, one line out. A line ends with LF, CR LF or a zero byte.
class LookupServer {
 public:
  using Answer = std::function<std::string(std::string_view line)>;

  /// Starts to listen.
  /// @param address of the interface, such as 127.0.0.1
  /// @param port 0: any free one
  /// @param answer called by the server's thread; must not throw
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  LookupServer(const std::string& address, std::uint16_t port, const LookupLimits& limits,
               const Answer& answer);

  std::uint16_t port() const { return server_.port(); }

 private:
  scan_cell_common::LineServer server_;
};

}  // namespace pose_frame_binder
