// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "net/line_session.h"

#include <netinet/tcp.h>
#include <poll.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

namespace scan_cell_common {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

void set_option(int socket, int level, int name, int value) {
  ::setsockopt(socket, level, name, &value, sizeof(value));
}

/// Detects a client whose cable was pulled within five seconds.
/// @param unheard [s] in which sent bytes must be acknowledged
void probe_line(int socket, double unheard) {
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 2);   // [s] of silence before the first probe
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 1);  // [s]
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);    // probes without answer
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(1000 * unheard));  // [ms]
}

std::string address_of(const LineSession::Socket& socket) {
  error_code unknown;
  return socket.remote_endpoint(unknown).address().to_string();
}

}  // namespace

std::size_t send_now(LineSession::Socket& socket, std::string_view bytes, error_code& error) {
  socket.non_blocking(true, error);
  return error ? 0 : socket.write_some(asio::buffer(bytes.data(), bytes.size()), error);
}

LineSession::LineSession(LineService& service, Socket socket, std::function<void()> on_end)
    : service_(service),
      socket_(std::move(socket)),
      peer_(address_of(socket_)),
      on_end_(std::move(on_end)),
      timer_(service.context) {
  const double answer_time = service.options.answer_time;
  if (answer_time > 0) probe_line(socket_.native_handle(), answer_time);
}

void LineSession::begin() {
  read();
  next();
}

void LineSession::stop() {
  error_code ignored;
  lines_.clear();
  leave("");
  socket_.shutdown(Socket::shutdown_both, ignored);
}

bool LineSession::is_there() {
  pollfd end{socket_.native_handle(), POLLRDHUP, 0};  // the end may not have been read yet
  return there_ && ::poll(&end, 1, 0) == 0;
}

void LineSession::read() {
  socket_.async_read_some(
      asio::buffer(bytes_), [this, self = shared_from_this()](error_code error, std::size_t size) {
        if (!error) {
          if (there_) take({bytes_.data(), size});
          unread_ = service_.options.max_ahead == 0 && there_ && !lines_.empty();
          if (!unread_) read();
          return;
        }
        all_read_ = true;
        leave("");
        if (loss_told_) finish();
      });
}

void LineSession::take(std::string_view bytes) {
  const LineServer::Options& options = service_.options;
  const std::string_view ends("\n\0", options.zero_ends_line ? 2 : 1);
  while (!bytes.empty()) {
    const std::size_t end = bytes.find_first_of(ends);
    rest_ += bytes.substr(0, end);
    if (rest_.size() > options.max_bytes) return leave(options.too_long);
    if (end == std::string_view::npos) break;
    const bool padding = bytes[end] == '\0' && rest_.empty();
    bytes.remove_prefix(end + 1);
    if (padding) continue;
    ahead_ += rest_.size() + 1;
    lines_.push_back(std::exchange(rest_, {}));
    if (options.max_ahead > 0 && ahead_ > options.max_ahead) return leave(options.too_far_ahead);
  }
  next();
}

void LineSession::next() {
  if (answering_ || closing_) return;
  if (!lines_.empty()) return give_to_answerer();
  if (!there_) return close();
  if (std::exchange(unread_, false)) read();
  if (!waits_for_line_ || service_.options.bytes_count) {
    waits_for_line_ = true;
    after(service_.options.idle_time, &LineSession::be_idle);
  }
}

void LineSession::give_to_answerer() {
  answering_ = true;
  waits_for_line_ = false;
  stop_timer();
  std::string line = std::move(lines_.front());
  lines_.pop_front();
  ahead_ -= line.size() + 1;
  asio::post(service_.answerer, [this, self = shared_from_this(), line = std::move(line),
                                 work = asio::make_work_guard(service_.context)] {
    std::string answer = service_.answer(line, [this] { return is_there(); });
    asio::post(service_.context, [this, self, answer = std::move(answer)]() mutable {
      send(std::move(answer) + '\n');
    });
  });
}

void LineSession::send(std::string line) {
  output_ = std::move(line);
  error_code error;
  const std::size_t sent = send_now(socket_, output_, error);
  answering_ = sent < output_.size();
  if (!answering_) return next();
  const bool full = !error || error == asio::error::would_block;
  if (!full || !is_there() || service_.options.answer_time <= 0) return close();
  send_rest(sent);
}

void LineSession::send_rest(std::size_t sent) {
  sending_ = true;
  after(service_.options.answer_time, &LineSession::close);
  asio::async_write(socket_, asio::buffer(output_.data() + sent, output_.size() - sent),
                    [this, self = shared_from_this()](error_code error, std::size_t) {
                      sending_ = false;
                      if (error || closing_) return close();
                      answering_ = false;
                      stop_timer();
                      next();
                    });
}

void LineSession::leave(const std::string& farewell) {
  if (there_.exchange(false)) farewell_ = farewell;
  if (sending_) return close();  // the client does not accept its answer, and will not
  next();
}

void LineSession::close() {
  if (std::exchange(closing_, true)) return;
  there_ = false;
  error_code ignored;
  if (!farewell_.empty() && !sending_) send_now(socket_, farewell_ + '\n', ignored);
  socket_.shutdown(Socket::shutdown_send, ignored);
  stop_timer();
  asio::post(service_.answerer,
             [this, self = shared_from_this(), work = asio::make_work_guard(service_.context)] {
               if (service_.on_client_lost) service_.on_client_lost();
               asio::post(service_.context, [this, self] { after_loss(); });
             });
}

void LineSession::after_loss() {
  // Unread bytes would make the kernel reset the connection, and the client might lose the last
  // message. So it is given time to close the connection itself.
  constexpr double kFarewell = 0.5;  // [s] chosen
  loss_told_ = true;
  if (all_read_) return finish();
  if (std::exchange(unread_, false)) read();
  after(kFarewell, &LineSession::finish);
}

void LineSession::finish() {
  if (std::exchange(finished_, true)) return;
  error_code ignored;
  stop_timer();
  socket_.close(ignored);
  on_end_();
}

void LineSession::stop_timer() {
  ++turn_;  // invalidates a wait that has ended but was not handled yet
  timer_.cancel();
}

void LineSession::after(double seconds, void (LineSession::*action)()) {
  using Clock = std::chrono::steady_clock;
  timer_.expires_after(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
  timer_.async_wait([this, self = shared_from_this(), action, turn = ++turn_](error_code error) {
    if (!error && turn == turn_) (this->*action)();
  });
}

}  // namespace scan_cell_common
