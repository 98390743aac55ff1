// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/receiver.h"

#include <fmt/core.h>
#include <pthread.h>

#include <cstring>
#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

Receiver::Receiver(PeerSocket& socket, int realtime_priority, Handler handler)
    : socket_(socket), handler_(std::move(handler)), thread_([this] { receive(); }) {
  if (realtime_priority != 0) raise_priority(realtime_priority);
}

Receiver::~Receiver() {
  end();
}

void Receiver::end() {
  ending_ = true;
  thread_.join();
}

void Receiver::raise_priority(int realtime_priority) {
  sched_param priority{};
  priority.sched_priority = realtime_priority;
  const int error = pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &priority);
  if (error == 0) return;
  end();
  throw scan_cell_common::InvalidParameter(
      "realtime_priority", fmt::format("{} ({})", realtime_priority, std::strerror(error)),
      "allow it (rtprio in /etc/security/limits.d), or set 0");
}

Malformed Receiver::malformed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return malformed_;
}

void Receiver::receive() {
  constexpr double kGlance = 0.05;  // [s] between two looks at ending_; chosen
  while (!ending_) {
    const auto received = socket_.receive(kGlance);
    if (!received) continue;
    try {
      handler_(parse(received->datagram), received->time);
    } catch (const scan_cell_common::ProtocolError& error) {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++malformed_.count;
      malformed_.last = error.what();
    }
  }
}

}  // namespace c4g_driver
