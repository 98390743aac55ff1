// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_listener.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <ctime>

#include "scan_cell_common/host_clock.h"

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
  iovec part{data, sizeof data};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  if (recvmsg(socket_, &message, MSG_DONTWAIT) != 1) return false;
  const auto time = scan_cell_common::receipt_time(message);
  if (!time) throw ConnectionError("the kernel", "gives no receive time stamps", "use Linux");
  if ((data[0] & kCameraPulse) != 0 && (data_ & kCameraPulse) == 0) edges_.push_back(*time);
  data_ = data[0];
  return true;
}

}  // namespace laser_trigger
