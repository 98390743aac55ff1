// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/net/stamped_datagram.h"

#include <sys/socket.h>

#include <array>
#include <cstring>
#include <ctime>

namespace scan_cell_common {
namespace {

std::optional<Nanoseconds> receipt_time(msghdr& message) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec time{};
    std::memcpy(&time, CMSG_DATA(part), sizeof time);
    return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  }
  return std::nullopt;
}

}  // namespace

std::optional<StampedDatagram> receive_stamped(int socket, void* data, std::size_t size) {
  StampedDatagram datagram;
  sockaddr_in from{};
  iovec part{data, size};
  alignas(cmsghdr) std::array<char, 128> control{};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof from;
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t length = recvmsg(socket, &message, MSG_DONTWAIT);
  if (length < 0) return std::nullopt;
  datagram.size = static_cast<std::size_t>(length);
  datagram.cut = (message.msg_flags & MSG_TRUNC) != 0;
  datagram.from = Endpoint::from_kernel(from);
  datagram.receipt = receipt_time(message);
  return datagram;
}

}  // namespace scan_cell_common
