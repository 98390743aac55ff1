// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lookup_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>
#include <vector>

#include "scan_cell_common/errors.h"

namespace pose_frame_binder {
namespace {

using Clock = std::chrono::steady_clock;

/// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

Descriptor listen_on(const std::string& address, std::uint16_t port) {
  const auto refuse = [&](const std::string& why) {
    throw scan_cell_common::ConnectionError("lookup on " + address + ":" + std::to_string(port),
                                            why, "give an address of this machine and a free port");
  };
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1) refuse("no IPv4 address");
  Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int yes = 1;
  ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  constexpr int kWaiting = 16;
  if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&place), sizeof(place)) != 0 ||
      ::listen(socket.number(), kWaiting) != 0) {
    refuse(std::strerror(errno));
  }
  return socket;
}

/// @return false if the client does not take it: an answer is far smaller than its buffer
bool send_line(int socket, const std::string& text) {
  const std::string line = text + "\n";
  return ::send(socket, line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(line.size());
}

struct Client {
  Descriptor socket;
  std::string line;  // what came of it so far
  Clock::time_point heard = Clock::now();
};

}  // namespace

struct LookupServer::Implementation {
  Implementation(const std::string& address, std::uint16_t port, const LookupLimits& l, Answer a)
      : limits(l), answer(std::move(a)), listener(listen_on(address, port)) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw scan_cell_common::ConnectionError("lookup", std::strerror(errno), "close other files");
    }
    wake_reader = Descriptor(ends[0]);
    wake_writer = Descriptor(ends[1]);
    thread = std::thread([this] { serve(); });
  }

  ~Implementation() {
    wake_writer = Descriptor();  // closed: the thread wakes and ends
    thread.join();
  }

  void serve() {
    while (true) {
      std::vector<pollfd> polled = {{wake_reader.number(), POLLIN, 0},
                                    {listener.number(), POLLIN, 0}};
      for (const Client& client : clients)
        polled.push_back({client.socket.number(), POLLIN, 0});
      constexpr int kLook = 100;  // [ms] for clients that have been idle for too long
      ::poll(polled.data(), polled.size(), kLook);
      if (polled[0].revents != 0) return;
      std::vector<Client> kept;
      for (std::size_t i = 0; i < clients.size(); ++i) {
        const bool ready = polled[i + 2].revents != 0;
        if (ready ? read(clients[i]) : !idle(clients[i])) kept.push_back(std::move(clients[i]));
      }
      clients = std::move(kept);
      if (polled[1].revents != 0) accept();
    }
  }

  void accept() {
    Client client{
        Descriptor(::accept4(listener.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)),
        {}};
    if (client.socket.number() < 0) {
      constexpr int kPause = 100;  // [ms] out of files: what waits would wake poll at once
      if (errno == EMFILE || errno == ENFILE) ::poll(nullptr, 0, kPause);
      return;
    }
    if (clients.size() >= static_cast<std::size_t>(limits.most_clients)) {
      send_line(client.socket.number(), "ERROR too many clients");
      return;
    }
    clients.push_back(std::move(client));
  }

  bool idle(const Client& client) const {
    return Clock::now() - client.heard > std::chrono::duration<double>(limits.idle_time);
  }

  /// @return false to hang up
  bool read(Client& client) const {
    std::array<char, 1024> bytes;
    const ssize_t size = ::recv(client.socket.number(), bytes.data(), bytes.size(), 0);
    if (size < 0) return errno == EAGAIN || errno == EINTR;
    if (size == 0) return false;
    client.heard = Clock::now();
    for (const char byte : std::string_view(bytes.data(), static_cast<std::size_t>(size))) {
      if (byte == '\n' || byte == '\0') {
        // A zero byte after a line's end, as C strings have it, is no further line.
        if (byte == '\0' && client.line.empty()) continue;
        if (!send_line(client.socket.number(), answer(client.line))) return false;
        client.line.clear();
      } else if (client.line.size() == limits.most_bytes) {
        send_line(client.socket.number(), "ERROR line too long");
        return false;
      } else {
        client.line += byte;
      }
    }
    return true;
  }

  const LookupLimits limits;
  const Answer answer;
  Descriptor listener;
  Descriptor wake_reader;
  Descriptor wake_writer;
  std::vector<Client> clients;
  std::thread thread;
};

LookupServer::LookupServer(const std::string& address, std::uint16_t port,
                           const LookupLimits& limits, Answer answer)
    : implementation_(std::make_unique<Implementation>(address, port, limits, std::move(answer))) {}

LookupServer::~LookupServer() = default;

std::uint16_t LookupServer::port() const {
  sockaddr_in place{};
  socklen_t size = sizeof(place);
  ::getsockname(implementation_->listener.number(), reinterpret_cast<sockaddr*>(&place), &size);
  return ntohs(place.sin_port);
}

}  // namespace pose_frame_binder
