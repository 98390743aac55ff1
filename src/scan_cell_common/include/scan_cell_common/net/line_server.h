// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace scan_cell_common {

/// Serves lines over TCP: one line in, one line out, one at a time for all clients. The end of a
/// connection is noticed at once, even while a line is being answered and others wait.
class LineServer {
 public:
  /// Where it listens, and its limits.
  struct Options {
    std::string name;                   //!< of the service, in errors
    std::string address = "127.0.0.1";  //!< of the interface to listen on
    std::uint16_t port = 0;             //!< 0: any free one
    std::string only_client;            //!< the only address to be answered; empty: any

    std::size_t max_clients = 1;   //!< at a time
    std::size_t max_bytes = 1023;  //!< of a line without its end
    std::size_t max_ahead = 0;     //!< [bytes] of waiting lines; 0: further lines stay unread
    double idle_time = 600;        //!< [s] without a line after which a client is disconnected
    bool bytes_count = false;      //!< idle means no byte, instead of no whole line
    double answer_time = 0;       //!< [s] in which a client must accept an answer, else its line is
                                  //!< dead; 0: at once, and lines are not probed
    bool zero_ends_line = false;  //!< a zero byte also ends a line, and is ignored after its end

    // What a client is told before it is disconnected; empty: nothing.
    std::string too_many_clients;  //!< {} stands for the address of the client being served
    std::string too_long;          //!< a line
    std::string too_far_ahead;     //!< of the answers
    std::string idle;              //!< silent for idle_time
  };

  /// Whether the client is still there; to be called now and then by long work.
  using ClientThere = std::function<bool()>;

  /// Answers a line, in the server's thread; must not throw.
  using Answer = std::function<std::string(const std::string& line, const ClientThere&)>;

  /// Starts to listen.
  /// @param on_client_lost called when a client has gone, whatever it was doing; empty: nothing
  /// @throw ConnectionError if the port cannot be opened
  LineServer(const Options& options, Answer answer, std::function<void()> on_client_lost = {});

  /// Disconnects all clients and ends the threads; waits for the answer in progress.
  ~LineServer();

  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  std::uint16_t port() const;  //!< on which it listens

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell_common
