// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

// The client's own threads: what comes, and keeping the link.
#include <pthread.h>

#include <algorithm>
#include <cstring>

#include "c4g_driver/client.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/host_clock.h"

namespace c4g_driver {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::ProtocolError;

void Client::connect() {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  std::string datagram;
  std::uint64_t malformed = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_ = std::max(session_ + 1, static_cast<std::uint64_t>(host_now() / 1000));
    ++attempts_;
    next_attempt_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(options_.reconnect_period));
    seq_ = 1;
    malformed = malformed_;
    answer_.reset();
    stream_.restart();
    poses_.restart(Clock::now());
    datagram = build(Open{}, session_, seq_);
  }
  const auto answer = exchange(datagram);
  const std::string why = answer ? "" : why_no_answer(Open{}, malformed);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    up_ = answer && !answer->error;
    if (!up_) why_down_ = answer ? answer->error->text.c_str() : why;
  }
  changed_.notify_all();
}

void Client::lose(const std::string& reason) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    up_ = false;
    why_down_ = reason;
    ++losses_;
    attempts_ = 0;
    goal_.end(Goal::Outcome::LinkLost, name_ + " " + reason);
  }
  changed_.notify_all();
}

void Client::keep() {
  while (true) {
    if (up()) {
      poll();
    } else {
      connect();
    }
    std::unique_lock<std::mutex> lock(mutex_);
    if (up_) {
      changed_.wait_for(lock, std::chrono::duration<double>(options_.poll_period),
                        [this] { return ending_ || !up_; });
    }
    // After a loss at once: OPEN ends what may still be on its way to the controller.
    if (!up_) changed_.wait_until(lock, next_attempt_, [this] { return ending_; });
    if (ending_) return;
  }
}

void Client::poll() {
  try {
    request(GetStaticPose{});
  } catch (const ConnectionError&) {
    return;  // a lost link is seen in the next round
  } catch (const Error&) {
    // what the controller complains of is in its state
  }
  // All that came before the answer is taken in by now, so a delay of this process is not blamed on
  // the controller.
  bool stale = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stale = poses_.stale(Clock::now());
  }
  if (stale) lose("sends no fresh poses");
}

void Client::start_receiving() {
  receiver_ = std::thread([this] { receive(); });
  if (options_.realtime_priority == 0) return;
  sched_param priority{};
  priority.sched_priority = options_.realtime_priority;
  const int error = pthread_setschedparam(receiver_.native_handle(), SCHED_FIFO, &priority);
  if (error == 0) return;
  deaf_ = true;
  receiver_.join();
  throw scan_cell_common::InvalidParameter(
      "realtime_priority",
      std::to_string(options_.realtime_priority) + " (" + std::strerror(error) + ")",
      "allow it (rtprio in /etc/security/limits.d), or set 0");
}

void Client::receive() {
  constexpr double kGlance = 0.05;  // [s]
  while (!deaf_) {
    const auto received = socket_.receive(kGlance);
    if (!received) continue;
    try {
      handle(*received);
    } catch (const ProtocolError& error) {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++malformed_;
      last_malformed_ = error.what();
    }
  }
}

void Client::handle(const UdpSocket::Received& received) {
  const Reply reply = parse(received.datagram);
  std::visit([&](const auto& kind) { handle(kind, received.time); }, reply);
}

void Client::handle(const StreamedState& streamed, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (streamed.session != session_) return;
    if (stream_.take(streamed.number) != SequenceMonitor::Verdict::Next) return;
  }
  take(streamed.session, streamed.robot, arrival, PoseFeed::Source::Stream);
}

void Client::handle(const Acknowledgement& acknowledgement, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;
  }
  if (acknowledgement.robot) {
    take(acknowledgement.session, *acknowledgement.robot, arrival,
         PoseFeed::Source::Acknowledgement);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;  // another session began meanwhile
    answer_ = acknowledgement;
  }
  changed_.notify_all();
}

bool Client::awaited(const Acknowledgement& acknowledgement) const {
  return acknowledgement.session == session_ && acknowledgement.seq == seq_ && !answer_;
}

void Client::take(std::uint64_t session, const RobotState& robot, Nanoseconds arrival,
                  PoseFeed::Source source) {
  MeasuredState measured;
  PoseFeed::Verdict verdict = PoseFeed::Verdict::Overtaken;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session != session_) return;
    verdict = poses_.take(robot, arrival, source, Clock::now());
    if (verdict == PoseFeed::Verdict::Overtaken) return;
    measured = *poses_.latest();
    if (source == PoseFeed::Source::Stream) late_.add(arrival - measured.time);
    goal_.update(robot);
  }
  changed_.notify_all();
  if (verdict != PoseFeed::Verdict::HandOn || !listener_) return;
  listener_(measured);
  const std::lock_guard<std::mutex> lock(mutex_);
  hand_on_.add(host_now() - arrival);
}

}  // namespace c4g_driver
