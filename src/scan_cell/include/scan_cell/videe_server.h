// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "scan_cell/videe_command.h"

namespace scan_cell {

/// Serves ViDeE over TCP: a line with a command in, a line with its result out, one command at a
/// time and one client at a time (others wait). "OK ..." or "ERROR reason".
class VideeServer {
 public:
  /// Whether the client is still there. A handler that waits for long asks it now and then.
  using ClientThere = std::function<bool()>;

  /// Carries out a command and returns what follows "OK"; an exception becomes "ERROR".
  using Handler = std::function<std::string(const VideeCommand&, const ClientThere&)>;

  /// Starts to listen.
  /// @param address of the interface, such as 127.0.0.1
  /// @param port 0: any free one
  /// @param on_client_lost called when a client has gone, whatever it had under way
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  VideeServer(const std::string& address, std::uint16_t port, Handler handler,
              std::function<void()> on_client_lost);

  /// Ends the connection and the thread; waits for the command under way.
  ~VideeServer();

  VideeServer(const VideeServer&) = delete;
  VideeServer& operator=(const VideeServer&) = delete;

  std::uint16_t port() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell
