// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lookup_server.h"

namespace pose_frame_binder {
namespace {

using scan_cell_common::LineServer;

LineServer::Options line_options(const std::string& address, std::uint16_t port,
                                 const LookupLimits& limits) {
  LineServer::Options lines;
  lines.name = "lookup";
  lines.address = address;
  lines.port = port;
  lines.max_clients = static_cast<std::size_t>(limits.max_clients);
  lines.max_bytes = limits.max_bytes;
  lines.idle_time = limits.idle_time;
  lines.bytes_count = true;
  lines.zero_ends_line = true;
  lines.too_many_clients = "ERROR too many clients";
  lines.too_long = "ERROR line too long";
  return lines;
}

}  // namespace

LookupServer::LookupServer(const std::string& address, std::uint16_t port,
                           const LookupLimits& limits, const Answer& answer)
    : server_(line_options(address, port, limits),
              [answer](const std::string& line, const LineServer::ClientThere&) {
                return answer(line);
              }) {}

}  // namespace pose_frame_binder
