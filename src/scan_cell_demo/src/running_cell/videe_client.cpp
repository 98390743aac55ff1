// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/videe_client.h"

#include <algorithm>
#include <chrono>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_demo {

using scan_cell_common::ConnectionError;

VideeClient::VideeClient(std::uint16_t port) {
  using boost::asio::ip::tcp;
  connection_.connect(tcp::endpoint(boost::asio::ip::address_v4::loopback(), port));
  if (!connection_) {
    throw ConnectionError("ViDeE on port " + std::to_string(port), connection_.error().message(),
                          "is videe_node running?");
  }
}

std::string VideeClient::ask(const std::string& command) {
  constexpr std::chrono::seconds kPatience(60);
  connection_.expires_after(kPatience);
  connection_ << command << '\n' << std::flush;
  std::string answer;
  if (!std::getline(connection_, answer)) {
    throw ConnectionError("ViDeE", "no answer to " + command + ": " + connection_.error().message(),
                          "see the log of videe_node");
  }
  const std::string ok = "OK";
  if (answer.compare(0, ok.size(), ok) != 0)
    throw scan_cell_common::Refused("ViDeE", command, answer);
  return answer.substr(std::min(answer.size(), ok.size() + 1));
}

}  // namespace scan_cell_demo
