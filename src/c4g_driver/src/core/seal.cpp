// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/seal.h"

#include <boost/crc.hpp>
#include <string_view>

#include "scan_cell_common/errors.h"

namespace c4g_driver {
namespace {

constexpr std::string_view kKey = ",\"crc\":";

/// The entry that seals these bytes, to the object's closing brace.
std::string entry_for(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return std::string(kKey) + std::to_string(crc.checksum()) + '}';
}

}  // namespace

std::string seal(std::string packet) {
  packet.pop_back();
  return packet + entry_for(packet);
}

void check_seal(const std::string& datagram) {
  const std::size_t end = datagram.rfind(kKey);
  const std::string_view bytes(datagram);
  if (end != std::string::npos && bytes.substr(end) == entry_for(bytes.substr(0, end))) return;
  throw scan_cell_common::ProtocolError(
      "C4G datagram", end == std::string::npos ? "no crc at its end" : "its crc does not match",
      "see docs/c4g_protocol.md; where the sender is right, look for what spoils the network");
}

}  // namespace c4g_driver
