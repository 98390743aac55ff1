// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "scan_cell_common/net/line_server.h"

namespace scan_cell_common {

/// State shared by all clients of a server.
struct LineService {
  LineServer::Options options;
  LineServer::Answer answer;
  std::function<void()> on_client_lost;
  boost::asio::io_context context;       // run by one thread, for all sockets
  boost::asio::thread_pool answerer{1};  // one thread: one line at a time
};

/// One client's connection. Everything but is_there() is for the thread of the service's context.
/// Reading never pauses while a line is answered, so that the end of the connection is noticed at
/// once.
class LineSession : public std::enable_shared_from_this<LineSession> {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  LineSession(LineService& service, Socket socket, std::function<void()> on_end);

  void begin();

  /// Disconnects as soon as the line in progress is answered.
  void stop();

  /// False once the client has closed its direction of the connection, its line has gone dead, or
  /// it has sent what ends the connection, even while earlier lines are not answered yet.
  bool is_there();

  /// The client's address.
  const std::string& peer() const { return peer_; }

 private:
  void read();
  void take(std::string_view bytes);
  void next();
  void give_to_answerer();
  void send(std::string line);
  void send_rest(std::size_t sent);
  void leave(const std::string& farewell);
  void be_idle() { leave(service_.options.idle); }
  void close();
  void after_loss();
  void finish();
  void after(double seconds, void (LineSession::*action)());
  void stop_timer();

  LineService& service_;
  Socket socket_;
  const std::string peer_;
  const std::function<void()> on_end_;
  boost::asio::steady_timer timer_;
  std::uint64_t turn_ = 0;  // of the timer: earlier waits no longer count
  std::array<char, 4096> bytes_{};
  std::string rest_;               // the beginning of the next line
  std::deque<std::string> lines_;  // not answered yet
  std::size_t ahead_ = 0;          // [bytes] of these lines
  std::string output_;             // the line being sent
  std::string farewell_;           // what the client is told before it is disconnected
  std::atomic<bool> there_{true};
  bool waits_for_line_ = false;
  bool unread_ = false;     // reading pauses until all lines are answered
  bool answering_ = false;  // true until the answer to a line is sent
  bool sending_ = false;
  bool closing_ = false;
  bool loss_told_ = false;
  bool all_read_ = false;  // nothing more will arrive
  bool finished_ = false;
};

/// Sends what the client accepts without waiting. @return [bytes] accepted
std::size_t send_now(LineSession::Socket& socket, std::string_view bytes,
                     boost::system::error_code& error);

}  // namespace scan_cell_common
