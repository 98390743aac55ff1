// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scan_cell/videe_command.h"
#include "scan_cell_common/net/line_server.h"

namespace scan_cell {

/// Serves ViDeE over TCP, one command at a time: a line with a command in, a line with its result
/// out, "OK ..." or "ERROR reason". One client at a time: another one is told who is connected, and
/// is disconnected.
class VideeServer {
 public:
  using ClientThere = scan_cell_common::LineServer::ClientThere;

  /// Carries out a command and returns what follows "OK"; an exception becomes "ERROR".
  using Handler = std::function<std::string(const VideeCommand&, const ClientThere&)>;

  struct Options {
    std::string address = "127.0.0.1";  //!< of the interface to listen on
    std::uint16_t port = 5000;          //!< 0: any free one
    std::string client;                 //!< the only address to be answered; empty: any
    double idle_time = 600;  //!< [s] without a command after which a client is disconnected
  };

  /// Starts to listen.
  /// @param on_client_lost called when a client has gone, whatever it was doing
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  VideeServer(const Options& options, const Handler& handler, std::function<void()> on_client_lost);

  std::uint16_t port() const { return server_.port(); }

 private:
  scan_cell_common::LineServer server_;  // its destructor waits for the command in progress
};

}  // namespace scan_cell
