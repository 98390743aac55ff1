// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe_connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

namespace scan_cell {
namespace {

constexpr std::size_t kLongestLine = 1024;  // with its end
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
  const timeval patience{kUnheard, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
}

}  // namespace

VideeConnection::VideeConnection(int socket, double idle_time)
    : socket_(socket), idle_time_(idle_time) {
  watch_line(socket);
}

std::optional<std::string> VideeConnection::next_line() {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(idle_time_);
  while (true) {
    const std::size_t end = pending_.find('\n');
    if (std::min(end, pending_.size()) >= kLongestLine) {
      send_line("ERROR line too long");
      return std::nullopt;
    }
    if (end != std::string::npos) {
      std::string line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return line;
    }
    const std::chrono::duration<double, std::milli> left = deadline - Clock::now();
    if (left.count() <= 0) {
      send_line("ERROR no command for " + std::to_string(static_cast<int>(idle_time_)) +
                " s; connect again");
      return std::nullopt;
    }
    if (!read_more(static_cast<int>(left.count()) + 1)) return std::nullopt;
  }
}

bool VideeConnection::read_more(int patience_ms) {
  pollfd readable{socket_, POLLIN, 0};
  if (::poll(&readable, 1, patience_ms) == 0) return true;  // the deadline is over
  std::array<char, kLongestLine> bytes;
  const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), 0);
  if (size <= 0) return size < 0 && errno == EINTR;
  pending_.append(bytes.data(), static_cast<std::size_t>(size));
  return true;
}

bool VideeConnection::send_line(std::string text) const {
  std::replace(text.begin(), text.end(), '\n', ' ');
  text += '\n';
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t size = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    sent += static_cast<std::size_t>(size);
  }
  return true;
}

bool VideeConnection::is_there() const {
  pollfd look{socket_, POLLRDHUP, 0};
  return ::poll(&look, 1, 0) == 0;
}

}  // namespace scan_cell
