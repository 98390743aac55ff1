// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace c4g_driver {

/// The packet with its check number as the last entry, `,"crc":...}`: CRC-32 (ISO-HDLC, as of zlib)
/// of all bytes before that comma. It finds every change of up to three bits in a datagram; a pose
/// with one other digit would be a valid pose.
/// @param packet text of a JSON object with at least one entry
std::string seal(std::string packet);

/// @throw scan_cell_common::ProtocolError unless the datagram is as it was sealed
void check_seal(std::string_view datagram);

}  // namespace c4g_driver
