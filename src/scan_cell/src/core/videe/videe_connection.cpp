// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>

#include "videe/one_line.h"

namespace scan_cell {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = 1024;    // with its end
constexpr std::size_t kMostAhead = 64 << 10;  // bytes of lines that wait for their turn
constexpr int kUnheard = 5;  // [s] in which a client takes an answer, or its line is dead

void set_option(int socket, int level, int name, int value) {
  ::setsockopt(socket, level, name, &value, sizeof(value));
}

/// Lets a client whose cable was pulled be noticed within five seconds.
void watch_line(int socket) {
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 2);   // [s] of silence before the first probe
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 1);  // [s]
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);    // probes without answer
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, 1000 * kUnheard);  // [ms]
}

}  // namespace

VideeConnection::VideeConnection(int socket, double idle_time)
    : socket_(socket), idle_time_(idle_time) {
  watch_line(socket);
  reader_ = std::thread([this] { read(); });
}

VideeConnection::~VideeConnection() {
  // Bytes that nobody read would make the kernel reset the connection, and the client might lose
  // what it was told last: it is given time to hang up itself.
  constexpr std::chrono::milliseconds kFarewell(500);
  ::shutdown(socket_, SHUT_WR);
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kFarewell, [this] { return all_read_; });
    ending_ = true;
  }
  ::shutdown(socket_, SHUT_RD);  // wakes the reader
  reader_.join();
}

void VideeConnection::read() {
  std::array<char, 4 * kLongestLine> bytes;
  while (true) {
    const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (size <= 0 || ending_) {
      all_read_ = true;
      leave("");
      return;
    }
    if (there_) take({bytes.data(), static_cast<std::size_t>(size)});
  }
}

void VideeConnection::take(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    rest_ += bytes.substr(0, end);
    if (rest_.size() >= kLongestLine) {
      return leave("ERROR line too long; send " + std::to_string(kLongestLine) +
                   " bytes at most, with its end");
    }
    if (end == std::string_view::npos) return;
    bytes.remove_prefix(end + 1);
    ahead_ += rest_.size() + 1;
    lines_.push_back(std::move(rest_));
    rest_.clear();
    changed_.notify_all();
    if (ahead_ > kMostAhead) {
      return leave("ERROR more than " + std::to_string(kMostAhead) +
                   " bytes ahead of their answers; wait for each answer");
    }
  }
}

void VideeConnection::leave(const std::string& farewell) {
  if (there_) farewell_ = farewell;
  there_ = false;
  changed_.notify_all();
}

std::optional<std::string> VideeConnection::next_line() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(idle_time_),
                    [this] { return !lines_.empty() || !there_; });
  if (!lines_.empty()) {
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    ahead_ -= line.size() + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }
  leave("ERROR no command for " + std::to_string(static_cast<int>(idle_time_)) +
        " s; connect again");
  const std::string farewell = farewell_;
  lock.unlock();
  if (!farewell.empty()) send_line(farewell);
  return std::nullopt;
}

bool VideeConnection::send_line(const std::string& text) const {
  constexpr int kLook = 20;  // [ms] between two looks whether the client is there
  const auto deadline = Clock::now() + std::chrono::seconds(kUnheard);
  const std::string line = one_line(text) + '\n';
  std::size_t sent = 0;
  while (sent < line.size()) {
    const ssize_t size =
        ::send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (size >= 0) {
      sent += static_cast<std::size_t>(size);
    } else if (errno == EAGAIN) {
      if (!is_there() || Clock::now() > deadline) return false;
      pollfd writable{socket_, POLLOUT, 0};
      ::poll(&writable, 1, kLook);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

bool VideeConnection::is_there() const {
  pollfd end{socket_, POLLRDHUP, 0};  // of which the reader may not know yet
  const std::lock_guard<std::mutex> lock(mutex_);
  return there_ && ::poll(&end, 1, 0) == 0;
}

void turn_away(int socket, const std::string& why) {
  const std::string line = one_line(why) + '\n';
  ::send(socket, line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace scan_cell
