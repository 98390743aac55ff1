// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/host_clock.h"

#include <cstring>
#include <ctime>

namespace scan_cell_common {
namespace {

Nanoseconds to_nanoseconds(const timespec& time) {
  return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

Nanoseconds host_now() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return to_nanoseconds(time);
}

std::optional<Nanoseconds> receipt_time(const msghdr& message) {
  for (const cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(const_cast<msghdr*>(&message), const_cast<cmsghdr*>(part))) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec time{};
    std::memcpy(&time, CMSG_DATA(part), sizeof time);
    return to_nanoseconds(time);
  }
  return std::nullopt;
}

}  // namespace scan_cell_common
