// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/link.h"

#include <fmt/core.h>

#include <algorithm>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;
using Seconds = std::chrono::duration<double>;

/// True for the errors after which only a new session helps; c4g_protocol.md.
bool ends_the_session(const ControllerError& error) {
  constexpr int kOtherVersion = 2, kNoSuchSession = 3, kAnotherClient = 4, kOutOfTurn = 18;
  return error.code == kOtherVersion || error.code == kNoSuchSession ||
         error.code == kAnotherClient || error.code == kOutOfTurn;
}

}  // namespace

Link::Link(const ClientOptions& options, Client::Listener listener)
    : options_(options),
      name_(fmt::format("controller {}:{}", options.address, options.port)),
      listener_(std::move(listener)),
      socket_(options.local_address, options.address, options.port, kMaxDatagramBytes),
      poses_(options.clock_window, options.link_timeout),
      receiver_(socket_, options.realtime_priority,
                [this](const Reply& reply, Nanoseconds arrival) {
                  std::visit([&](const auto& kind) { handle(kind, arrival); }, reply);
                }),
      keeper_([this] { keep(); }) {}

Link::~Link() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  keeper_.join();
  try {
    if (goal().underway()) request(Stop{});
    if (up()) request(Close{});
  } catch (const Error&) {
    // the controller stops the motion of a silent client
  }
}

void Link::keep() {
  while (true) {
    const Clock::time_point begin = Clock::now();
    if (up()) {
      poll();
    } else {
      connect();
    }
    std::unique_lock<std::mutex> lock(mutex_);
    if (report_.up) {
      const double wait = period();
      const auto next = begin + std::chrono::duration_cast<Clock::duration>(Seconds(wait));
      changed_.wait_until(lock, next, [=] { return ending_ || !report_.up || period() < wait; });
    }
    // Reconnects at once after a loss: OPEN voids what may still be in transit to the controller.
    if (!report_.up) changed_.wait_until(lock, next_attempt_, [this] { return ending_; });
    if (ending_) return;
  }
}

/// [s] between two signs of life. While a tool path is followed they are so frequent that the
/// controller receives one in time even if the network loses some.
double Link::period() const {
  constexpr double kSignsAWatch = 10;  // with 30 % loss, ten in a row are lost twice an hour
  if (!follows()) return options_.poll_period;
  return std::min(options_.poll_period, watch_ / kSignsAWatch);
}

/// [s] from one try of a request to the next
double Link::patience() const {
  const double usual = options_.link_timeout / options_.tries;
  return follows() ? std::min(usual, period()) : usual;
}

bool Link::follows() const {
  return watch_ > 0 && goal_.underway();
}

void Link::connect() {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  const std::uint64_t malformed = receiver_.malformed().count;
  std::string datagram;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    constexpr Nanoseconds kMicrosecond = 1000;  // [ns] so that sessions grow after a restart, too
    session_ = std::max(session_ + 1, static_cast<std::uint64_t>(host_now() / kMicrosecond));
    ++report_.attempts;
    next_attempt_ = Clock::now() +
                    std::chrono::duration_cast<Clock::duration>(Seconds(options_.reconnect_period));
    seq_ = 1;
    answer_.reset();
    stream_.restart();
    poses_.restart(Clock::now());
    datagram = build(Open{}, session_, seq_);
  }
  const auto answer = exchange(datagram);
  const std::string why = answer ? "" : why_no_answer(Open{}, malformed);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    report_.up = answer && !answer->error;
    if (!report_.up) report_.message = answer ? answer->error->text.c_str() : why;
  }
  changed_.notify_all();
}

void Link::poll() {
  try {
    request(GetStaticPose{});
  } catch (const ConnectionError&) {
    return;  // the next round notices a lost link
  } catch (const Error&) {
    // the state shows the controller's errors
  }
  // Everything that arrived before the answer is processed by now, so the controller is not blamed
  // for a delay of this process.
  bool stale = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stale = poses_.stale(Clock::now());
  }
  if (stale) lose("sends no fresh poses");
}

void Link::lose(const std::string& reason) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    report_.up = false;
    report_.message = reason;
    ++report_.losses;
    report_.attempts = 0;
    goal_.end(Goal::Outcome::kLinkLost, name_ + " " + reason);
  }
  changed_.notify_all();
}

Acknowledgement Link::request(const Request& request, const Start* start, std::string* sent) {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  const std::uint64_t malformed = receiver_.malformed().count;
  const std::string datagram = next_datagram(request, start);
  if (sent != nullptr) *sent = datagram;
  const auto answer = exchange(datagram);
  if (!answer || (answer->error && ends_the_session(*answer->error))) {
    const std::string reason =
        answer ? fmt::format("dropped the session: {}", answer->error->text.c_str())
               : why_no_answer(request, malformed);
    lose(reason);
    throw ConnectionError(name_, reason, kCheckLink);
  }
  if (answer->error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (start != nullptr) goal_ = Goal();
    throw Refused(name_of(request),
                  fmt::format("refused by the controller, {}", answer->error->text.c_str()),
                  fmt::format("see error {} in c4g_protocol.md", answer->error->code));
  }
  return *answer;
}

/// @throw ConnectionError, Refused; then nothing has changed
std::string Link::next_datagram(const Request& request, const Start* start) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!report_.up) throw ConnectionError(name_, report_.message, kCheckLink);
  if (start != nullptr && goal_.underway()) {
    throw Refused(name_of(request), "another motion is under way", "stop it first");
  }
  std::string datagram = build(request, session_, seq_ + 1);
  ++seq_;
  answer_.reset();
  if (start != nullptr) {
    goal_ = Goal(seq_, start->target, options_.arrival);
    max_override_ = start->max_override;
    const auto* const follow = std::get_if<FollowPath>(&request);
    watch_ = follow != nullptr ? follow->watch : 0;
  }
  return datagram;
}

std::optional<Acknowledgement> Link::exchange(const std::string& datagram) {
  const Clock::time_point begin = Clock::now();
  const auto timeout = std::chrono::duration_cast<Clock::duration>(Seconds(options_.link_timeout));
  // Uses all tries, so that the controller is not blamed for a delay of this process.
  for (int i = 0; i < options_.tries || Clock::now() - begin < timeout; ++i) {
    const Clock::time_point sent = Clock::now();
    socket_.send(datagram);
    std::unique_lock<std::mutex> lock(mutex_);
    const auto answered = [this] { return answer_.has_value(); };
    if (!changed_.wait_for(lock, Seconds(patience()), answered)) continue;
    // Karn's rule (1987): the answer to a retry may belong to an earlier try
    if (i == 0) report_.round_trip.add(std::chrono::nanoseconds(Clock::now() - sent).count());
    return answer_;
  }
  return std::nullopt;
}

/// @param malformed count of malformed datagrams before the request
std::string Link::why_no_answer(const Request& request, std::uint64_t malformed) const {
  const Malformed now = receiver_.malformed();
  if (now.count > malformed) return "violates the protocol: " + now.last;
  return "does not answer " + name_of(request);
}

void Link::handle(const StreamedState& streamed, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (streamed.session != session_) return;
    if (stream_.take(streamed.number) != SequenceMonitor::Verdict::kNext) return;
  }
  take(streamed.session, streamed.robot, arrival, PoseFeed::Source::kStream);
}

void Link::handle(const Acknowledgement& acknowledgement, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;
  }
  if (acknowledgement.robot) {
    take(acknowledgement.session, *acknowledgement.robot, arrival,
         PoseFeed::Source::kAcknowledgement);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;  // another session began meanwhile
    answer_ = acknowledgement;
  }
  changed_.notify_all();
}

bool Link::awaited(const Acknowledgement& acknowledgement) const {
  return acknowledgement.session == session_ && acknowledgement.seq == seq_ && !answer_;
}

void Link::take(std::uint64_t session, const RobotState& robot, Nanoseconds arrival,
                PoseFeed::Source source) {
  MeasuredState measured;
  PoseFeed::Verdict verdict = PoseFeed::Verdict::kOvertaken;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session != session_) return;
    verdict = poses_.take(robot, arrival, source, Clock::now());
    if (verdict == PoseFeed::Verdict::kOvertaken) return;
    measured = *poses_.latest();
    if (source == PoseFeed::Source::kStream) report_.late.add(arrival - measured.time);
    goal_.update(robot);
  }
  changed_.notify_all();
  if (verdict != PoseFeed::Verdict::kHandOn || !listener_) return;
  listener_(measured);
  const std::lock_guard<std::mutex> lock(mutex_);
  report_.hand_on.add(host_now() - arrival);
}

Goal Link::goal() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_;
}

Goal Link::wait_for_goal(double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, Seconds(timeout), [this] { return !goal_.underway(); });
  return goal_;
}

double Link::max_override() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_.underway() ? max_override_ : 100;
}

bool Link::up() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_.up;
}

bool Link::wait_until_up(double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, Seconds(timeout), [this] { return report_.up; });
}

std::optional<MeasuredState> Link::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return poses_.latest();
}

LinkReport Link::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  LinkReport report = report_;
  report.stream = stream_.counts();
  report.dropped = poses_.dropped();
  report.clock = poses_.clock();
  report.malformed = receiver_.malformed();
  report.foreign = socket_.foreign();
  report.overlong = socket_.overlong();
  return report;
}

}  // namespace c4g_driver
