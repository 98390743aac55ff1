// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/stream_packets.h"

#include <algorithm>

#include "camera/big_endian.h"

namespace scan_cell_sim::gige {
namespace {

constexpr std::uint32_t kOverhead = 20 + 8 + 8;                   // [bytes] of IP, UDP and GVSP
constexpr std::uint32_t kMinPayload = 64;                         // [bytes] chosen
constexpr std::uint32_t kResent = 0x0100;                         // GVSP status
constexpr std::uint32_t kLeader = 1, kTrailer = 2, kPayload = 3;  // GVSP packet formats
constexpr std::uint32_t kImage = 1;                               // GVSP payload type
constexpr std::uint32_t kMono8 = 0x01080001;                      // GenICam PFNC

void write_leader(const Frame& frame, std::vector<std::uint8_t>& bytes) {
  const auto time = static_cast<std::uint64_t>(frame.time);
  put16(bytes, 0);
  put16(bytes, kImage);
  put32(bytes, time >> 32U);
  put32(bytes, time & 0xffffffffU);
  put32(bytes, kMono8);
  for (const int value :
       {frame.region.width, frame.region.height, frame.region.x, frame.region.y}) {
    put32(bytes, static_cast<std::uint32_t>(value));
  }
  put32(bytes, 0);  // padding
}

void write_trailer(const Frame& frame, std::vector<std::uint8_t>& bytes) {
  put32(bytes, kImage);
  put32(bytes, static_cast<std::uint32_t>(frame.region.height));
}

}  // namespace

StreamPackets::StreamPackets(std::uint32_t packet_size)
    : payload_(std::max(packet_size, kOverhead + kMinPayload) - kOverhead) {}

std::uint32_t StreamPackets::count(const Frame& frame) const {
  const auto size = static_cast<std::uint32_t>(frame.pixels.size());
  return (size + payload_ - 1) / payload_ + 2;
}

void StreamPackets::write(const Frame& frame, std::uint32_t packet, bool again,
                          std::vector<std::uint8_t>& bytes) const {
  const bool trailer = packet + 1 == count(frame);
  const std::uint32_t kind = packet == 0 ? kLeader : trailer ? kTrailer : kPayload;
  bytes.clear();
  put16(bytes, again ? kResent : 0);
  put16(bytes, frame.block);
  put32(bytes, kind << 24U | packet);
  if (kind == kLeader) return write_leader(frame, bytes);
  if (kind == kTrailer) return write_trailer(frame, bytes);
  const std::size_t begin = static_cast<std::size_t>(packet - 1) * payload_;
  const std::size_t end = std::min(begin + payload_, frame.pixels.size());
  bytes.insert(bytes.end(), frame.pixels.begin() + static_cast<std::ptrdiff_t>(begin),
               frame.pixels.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace scan_cell_sim::gige
