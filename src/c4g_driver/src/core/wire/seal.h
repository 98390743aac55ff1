// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace c4g_driver {

/// Adds the check number to a packet as its last entry, `,"crc":...}`: CRC-32 (ISO-HDLC, as in
/// zlib) of all bytes before that comma. It detects every change of up to three bits in a datagram;
/// a pose with one wrong digit would be a valid pose.
/// @param packet text of a JSON object with at least one entry
std::string seal(std::string packet);

/// @throw scan_cell_common::ProtocolError if the datagram is not as it was sealed
void check_seal(std::string_view datagram);

}  // namespace c4g_driver
