// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/seal.h"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <charconv>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

constexpr std::string_view kKey = ",\"crc\":";

/// The entry that seals these bytes, up to the object's closing brace.
class Entry {
 public:
  explicit Entry(std::string_view bytes) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    char* end = std::copy(kKey.begin(), kKey.end(), text_.data());
    end = std::to_chars(end, text_.data() + text_.size(), crc.checksum()).ptr;
    *end++ = '}';
    length_ = static_cast<std::size_t>(end - text_.data());
  }
  std::string_view text() const { return {text_.data(), length_}; }

 private:
  std::array<char, 24> text_{};
  std::size_t length_ = 0;
};

}  // namespace

std::string seal(std::string packet) {
  packet.pop_back();
  return packet.append(Entry(packet).text());
}

void check_seal(std::string_view datagram) {
  const std::size_t end = datagram.rfind(kKey);
  const bool there = end != std::string_view::npos;
  if (there && datagram.substr(end) == Entry(datagram.substr(0, end)).text()) return;
  throw scan_cell_common::ProtocolError("C4G datagram",
                                        there ? "its crc does not match" : "no crc at its end",
                                        "see c4g_protocol.md; if the sender is right, find out "
                                        "what corrupts datagrams on the network");
}

}  // namespace c4g_driver
