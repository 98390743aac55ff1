// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/frame_sender.h"

#include <algorithm>

#include "scene/scramble.h"

namespace scan_cell_sim::gige {
namespace {

using scan_cell_common::Nanoseconds;

constexpr std::size_t kKept = 16;          // frames to send again from; chosen
constexpr std::size_t kBurst = 16384;      // [bytes] sent at once: fits the client's buffer; chosen
constexpr Nanoseconds kCatchUp = 500'000;  // [ns] of delay that later bursts make up for; chosen
constexpr std::size_t kMaxRequests = 256;  // waiting at a time; chosen

}  // namespace

FrameSender::FrameSender(const std::string& address, double rate)
    : socket_(camera_socket(address, 0)), rate_(rate) {}

std::vector<std::uint8_t> FrameSender::spare_pixels() {
  if (frames_.size() < kKept) return {};
  std::vector<std::uint8_t> pixels = std::move(frames_.front().pixels);
  frames_.pop_front();
  return pixels;
}

void FrameSender::begin(Frame frame, std::uint32_t packet_size, const PacketFaults& faults) {
  frames_.push_back(std::move(frame));
  packets_ = StreamPackets(packet_size);
  faults_ = faults;
  next_packet_ = 0;
}

void FrameSender::request(const ControlServer::ResendRequest& request) {
  if (requests_.size() < kMaxRequests) requests_.push_back(request);
}

void FrameSender::abort() {
  next_packet_.reset();
  requests_.clear();
  frames_.clear();
}

void FrameSender::send(Nanoseconds now, const Endpoint& peer) {
  if (now < next_) return;
  std::size_t sent = 0;
  while (sent < kBurst && busy()) {
    sent += requests_.empty() ? send_next(peer) : send_requested(peer);
  }
  next_ = std::max(next_, now - kCatchUp) +
          scan_cell_common::from_seconds(static_cast<double>(sent) / rate_);
}

std::size_t FrameSender::send_next(const Endpoint& peer) {
  const Frame& frame = frames_.back();
  const std::size_t sent = send_packet(frame, *next_packet_, false, peer);
  if (++*next_packet_ == packets_.count(frame)) next_packet_.reset();
  return sent;
}

std::size_t FrameSender::send_requested(const Endpoint& peer) {
  ControlServer::ResendRequest& request = requests_.front();
  const auto frame = std::find_if(frames_.begin(), frames_.end(),
                                  [&](const Frame& f) { return f.block == request.block; });
  if (frame == frames_.end() || request.first > request.last ||
      request.first >= packets_.count(*frame)) {
    requests_.pop_front();
    return 0;
  }
  return send_packet(*frame, request.first++, true, peer);
}

std::size_t FrameSender::send_packet(const Frame& frame, std::uint32_t packet, bool again,
                                     const Endpoint& peer) {
  packets_.write(frame, packet, again, bytes_);
  const std::uint64_t name = scramble(faults_.seed) ^ (std::uint64_t{frame.block} << 32U | packet);
  const bool lost = to_unit(scramble(name)) < faults_.lost;
  const bool lost_once = to_unit(scramble(~name)) < faults_.lost_once;
  if (!lost && (again || !lost_once)) socket_.send(bytes_.data(), bytes_.size(), peer);
  return bytes_.size();
}

}  // namespace scan_cell_sim::gige
