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

/// What all clients of a server share.
struct LineService {
  LineServer::Options options;
  LineServer::Answer answer;
  std::function<void()> on_client_lost;
  boost::asio::io_context context;       // run by one thread, for all sockets
  boost::asio::thread_pool answerer{1};  // one thread: one line at a time
};

/// One client's connection. All but is_there() is for the thread of the service's context. Reading
/// never pauses while a line is answered, so that the end of the connection is seen at once.
class LineSession : public std::enable_shared_from_this<LineSession> {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  LineSession(LineService& service, Socket socket, std::function<void()> on_end);

  void begin();

  /// Hangs up as soon as the line under way is answered.
  void stop();

  /// False from when the client closed the connection in its direction, its line went dead, or it
  /// sent what ends the connection, also while lines that came before are not answered yet.
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
  std::uint64_t turn_ = 0;  // of the timer: a wait before this one counts no more
  std::array<char, 4096> bytes_{};
  std::string rest_;               // the beginning of the next line
  std::deque<std::string> lines_;  // not answered yet
  std::size_t ahead_ = 0;          // [bytes] of them
  std::string output_;             // the line that is being sent
  std::string farewell_;           // what the client is told before it is hung up on
  std::atomic<bool> there_{true};
  bool waits_for_line_ = false;
  bool unread_ = false;     // reading pauses until all lines are answered
  bool answering_ = false;  // a line, up to the end of its answer
  bool sending_ = false;
  bool closing_ = false;
  bool loss_told_ = false;
  bool all_read_ = false;  // nothing will come any more
  bool finished_ = false;
};

/// Sends what the client takes without waiting. @return [bytes] that it took
std::size_t send_now(LineSession::Socket& socket, std::string_view bytes,
                     boost::system::error_code& error);

}  // namespace scan_cell_common
