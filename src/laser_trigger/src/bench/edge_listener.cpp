// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_listener.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "scan_cell_common/stamped_datagram.h"

namespace laser_trigger {

using scan_cell_common::ConnectionError;
using scan_cell_common::Nanoseconds;

EdgeListener::EdgeListener() : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const int on = 1;
  if (setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0 ||
      bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    close(socket_);
    throw ConnectionError("the bench's circuit", std::strerror(errno), "end other programs");
  }
  port_ = ntohs(address.sin_port);
}

EdgeListener::~EdgeListener() {
  stop();
  close(socket_);
}

PortAddress EdgeListener::address() const {
  return PortAddress::loopback("127.0.0.1", port_);
}

void EdgeListener::start() {
  while (take()) {
  }
  edges_.clear();
  ending_ = false;
  thread_ = std::thread(&EdgeListener::listen, this);
}

std::vector<Nanoseconds> EdgeListener::stop() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
  return edges_;
}

void EdgeListener::listen() {
  constexpr std::chrono::milliseconds kLook(50);  // the kernel keeps 100 ms of 1000 bytes a second
  while (!ending_) {
    std::this_thread::sleep_for(kLook);
    while (take()) {
    }
  }
}

bool EdgeListener::take() {
  std::uint8_t data[2];
  const auto datagram = scan_cell_common::receive_stamped(socket_, data, sizeof data);
  if (!datagram || datagram->size != 1) return false;
  if (!datagram->receipt)
    throw ConnectionError("the kernel", "gives no receive time stamps", "use Linux");
  if ((data[0] & kCameraPulse) != 0 && (data_ & kCameraPulse) == 0)
    edges_.push_back(*datagram->receipt);
  data_ = data[0];
  return true;
}

}  // namespace laser_trigger
