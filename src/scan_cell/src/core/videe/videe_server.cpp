// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_server.h"

#include <fmt/format.h>

#include "videe/one_line.h"

namespace scan_cell {
namespace {

using scan_cell_common::LineServer;

constexpr std::size_t kMaxLine = 1024;       // [bytes] with its end; chosen
constexpr std::size_t kMaxAhead = 64 << 10;  // [bytes] of waiting lines; chosen
constexpr double kAnswerTime = 5;            // [s] chosen

LineServer::Options line_options(const VideeServer::Options& options) {
  LineServer::Options lines;
  lines.name = "ViDeE";
  lines.address = options.address;
  lines.port = options.port;
  lines.only_client = options.client;
  lines.max_bytes = kMaxLine - 1;
  lines.max_ahead = kMaxAhead;
  lines.idle_time = options.idle_time;
  lines.answer_time = kAnswerTime;
  lines.too_many_clients = "ERROR another client is connected, from {}; try again later";
  lines.too_long =
      fmt::format("ERROR line too long; send {} bytes at most, including its end", kMaxLine);
  lines.too_far_ahead = fmt::format(
      "ERROR more than {} bytes ahead of their answers; wait for each answer", kMaxAhead);
  lines.idle =
      fmt::format("ERROR no command for {} s; connect again", static_cast<int>(options.idle_time));
  return lines;
}

std::string answer(const VideeServer::Handler& handler, std::string line,
                   const VideeServer::ClientThere& client_there) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  try {
    const std::string result = handler(parse_videe(line), client_there);
    return result.empty() ? "OK" : "OK " + result;
  } catch (const std::exception& error) {  // also of OpenCV: a command must not end the node
    return "ERROR " + std::string(error.what());
  }
}

}  // namespace

VideeServer::VideeServer(const Options& options, const Handler& handler,
                         std::function<void()> on_client_lost)
    : server_(
          line_options(options),
          [handler](const std::string& line, const ClientThere& client_there) {
            return one_line(answer(handler, line, client_there));
          },
          std::move(on_client_lost)) {}

}  // namespace scan_cell
