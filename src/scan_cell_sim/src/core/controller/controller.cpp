// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/controller.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/host_clock.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::from_seconds;
using scan_cell_common::host_now;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;

constexpr std::size_t kMostBytes = 1400;

sockaddr_in to_socket_address(const Peer& peer) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = peer.address;
  address.sin_port = peer.port;
  return address;
}

Peer listening_at(const ControllerOptions& options) {
  in_addr parsed{};
  if (inet_pton(AF_INET, options.address.c_str(), &parsed) != 1) {
    throw InvalidParameter("controller address", "'" + options.address + "'",
                           "give an IPv4 address such as 127.0.0.1");
  }
  return {parsed.s_addr, htons(options.port)};
}

int open_socket(const ControllerOptions& options) {
  sockaddr_in address = to_socket_address(listening_at(options));
  const int opened = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (opened >= 0 && bind(opened, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
    return opened;
  }
  const std::string reason = std::strerror(errno);
  if (opened >= 0) close(opened);
  throw ConnectionError("UDP port " + options.address + ":" + std::to_string(options.port), reason,
                        "end the program that uses it, or choose another port");
}

std::uint16_t port_of(int opened) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(opened, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

void check_stream_period(double period) {
  if (period >= 0.002 && period <= 0.010) return;
  throw InvalidParameter("stream period", std::to_string(period) + " s",
                         "give one from 0.002 to 0.010 s");
}

}  // namespace

Joints Controller::start_posture() {
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange.translation() << 0.80, 0, 0.60;
  flange.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  static const Joints posture = reach(flange, Joints::Zero());
  return posture;
}

void ControllerFaults::check() const {
  constexpr double kMostDrift = 0.5;
  scan_cell_sim::check(to_client, "to_client/");
  scan_cell_sim::check(from_client, "from_client/");
  if (std::abs(clock_drift) <= kMostDrift) return;
  throw InvalidParameter("clock_drift", std::to_string(clock_drift), "give -0.5 .. 0.5");
}

Controller::Controller(const ControllerOptions& options)
    : options_(options),
      motion_(start_posture()),
      clock_(host_now()),
      server_(make_server()),
      incoming_(options.faults.seed),
      outgoing_(options.faults.seed + 1) {
  check_stream_period(options.stream_period);
  set_faults(options.faults);
  adopted_.seed = options.faults.seed;
  select(options.mode);
  switch_drives(true);
  socket_ = open_socket(options);
  port_ = port_of(socket_);
  thread_ = std::thread([this] { serve(); });
}

std::unique_ptr<ProtocolServer> Controller::make_server() {
  return std::make_unique<ProtocolServer>(motion_, clock_, options_.stream_period, options_.noise,
                                          options_.witness);
}

Controller::~Controller() {
  ending_ = true;
  thread_.join();
  close(socket_);
}

Eigen::Isometry3d Controller::flange_at(Nanoseconds host) const {
  const Run run = motion_.log().at(host);
  return run.path->flange(run.way(host));
}

MotionState Controller::state() const {
  return motion_.state(host_now());
}

void Controller::set_faults(const ControllerFaults& faults) {
  faults.check();
  const std::lock_guard<std::mutex> lock(mutex_);
  faults_ = faults;
  faults_since_ = host_now();
}

ControllerFaults Controller::faults() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  ControllerFaults present = faults_;
  const Nanoseconds passed = host_now() - faults_since_;
  for (WireFaults* const wire : {&present.to_client, &present.from_client})
    wire->link_down = wire->link_down || passed < from_seconds(wire->silence);
  return present;
}

void Controller::restart(double dark) {
  if (!(dark >= 0)) {
    throw InvalidParameter("restart", std::to_string(dark) + " s", "give 0 s or more");
  }
  const Nanoseconds now = host_now();
  const std::lock_guard<std::mutex> lock(mutex_);
  motion_.power_off(now);
  dark_until_ = now + from_seconds(dark);
}

/// Begins anew where a restart is over.
bool Controller::is_on(Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!dark_until_) return true;
  if (now < *dark_until_) return false;
  dark_until_.reset();
  clock_.restart(now);
  motion_.power_on(now);
  server_ = make_server();
  return true;
}

void Controller::press_e_stop() {
  motion_.press_e_stop(host_now());
}

void Controller::release_e_stop() {
  motion_.release_e_stop();
}

void Controller::select(ControllerMode mode) {
  motion_.select(mode, host_now());
}

void Controller::switch_drives(bool on) {
  motion_.switch_drives(on, Readiness::Source::Panel, host_now());
}

void Controller::reset_alarms() {
  motion_.reset_alarms(Readiness::Source::Panel);
}

void Controller::fail_motion(const std::string& text) {
  motion_.fail(text, host_now());
}

void Controller::serve() {
  Nanoseconds tick = host_now();
  while (!ending_) {
    const Nanoseconds next =
        std::min({tick, incoming_.next_due().value_or(tick), outgoing_.next_due().value_or(tick)});
    wait(next);
    const ControllerFaults present = faults();
    adopt(present);
    receive(present.from_client);
    answer_received(present.to_client);
    const Nanoseconds now = host_now();
    if (now >= tick) {
      if (is_on(now)) stream(present.to_client);
      const Nanoseconds period = from_seconds(server_->stream_period());
      tick += period;
      if (tick < now || tick > now + period) tick = now + period;  // late, or the clock was set
    }
    send_due();
  }
}

void Controller::adopt(const ControllerFaults& faults) {
  if (faults.clock_drift != adopted_.clock_drift) clock_.set_drift(faults.clock_drift, host_now());
  if (faults.seed != adopted_.seed) {
    incoming_.seed(faults.seed);
    outgoing_.seed(faults.seed + 1);
  }
  adopted_ = faults;
}

void Controller::stream(const WireFaults& faults) {
  const Nanoseconds now = host_now();
  server_->watch(now);
  const auto datagram = server_->stream(now);
  if (datagram) outgoing_.put({*server_->client(), *datagram}, faults, now);
}

void Controller::wait(Nanoseconds until) const {
  const Nanoseconds left = std::max<Nanoseconds>(0, until - host_now());
  const timespec timeout{static_cast<time_t>(left / 1'000'000'000),
                         static_cast<long>(left % 1'000'000'000)};
  pollfd readable{socket_, POLLIN, 0};
  ppoll(&readable, 1, &timeout, nullptr);
}

void Controller::receive(const WireFaults& faults) {
  char bytes[kMostBytes];
  sockaddr_in from{};
  socklen_t size = sizeof from;
  ssize_t length = 0;
  while ((length = recvfrom(socket_, bytes, sizeof bytes, MSG_DONTWAIT | MSG_TRUNC,
                            reinterpret_cast<sockaddr*>(&from), &size)) >= 0 ||
         errno == ECONNREFUSED) {  // an answer found nobody: no news of our own
    if (length < 0 || static_cast<std::size_t>(length) > sizeof bytes) continue;
    const Datagram datagram{{from.sin_addr.s_addr, from.sin_port},
                            std::string(bytes, static_cast<std::size_t>(length))};
    incoming_.put(datagram, faults, host_now());
  }
}

void Controller::answer_received(const WireFaults& faults) {
  while (const auto request = incoming_.take(host_now())) {
    const Nanoseconds now = host_now();
    if (!is_on(now)) continue;
    const auto answer = server_->answer(*request, now);
    if (answer) outgoing_.put({request->peer, *answer}, faults, now);
  }
}

void Controller::send_due() {
  while (const auto datagram = outgoing_.take(host_now())) {
    const sockaddr_in address = to_socket_address(datagram->peer);
    sendto(socket_, datagram->text.data(), datagram->text.size(), MSG_DONTWAIT,
           reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
}

}  // namespace scan_cell_sim
