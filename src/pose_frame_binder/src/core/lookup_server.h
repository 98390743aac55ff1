// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace pose_frame_binder {

struct LookupLimits {
  int most_clients = 4;         //!< at a time; further ones are told so and hung up
  std::size_t most_bytes = 64;  //!< of a line
  double idle_time = 60;        //!< [s] without a byte, after which a client is hung up
};

/// Answers lines over TCP: a line in, a line out. A line ends with LF, CR LF or a zero byte.
class LookupServer {
 public:
  using Answer = std::function<std::string(std::string_view line)>;

  /// Starts to listen.
  /// @param address of the interface, such as 127.0.0.1
  /// @param port 0: any free one
  /// @param answer called by the server's thread; must not throw
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  LookupServer(const std::string& address, std::uint16_t port, const LookupLimits& limits,
               Answer answer);

  /// Hangs up all clients and ends the thread.
  ~LookupServer();

  LookupServer(const LookupServer&) = delete;
  LookupServer& operator=(const LookupServer&) = delete;

  std::uint16_t port() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pose_frame_binder
