// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>

#include "camera/loopback.h"
#include "controller/wire/wire_json.h"
#include "scan_cell_sim/controller/controller.h"

/// Requests to the controller on its real wire, with packets written out by hand.

using nlohmann::json;
using scan_cell_common::Nanoseconds;

inline scan_cell_sim::ControllerOptions any_port() {
  scan_cell_sim::ControllerOptions options;
  options.port = 0;
  return options;
}

/// A client that sends exactly what it is told.
class BareClient {
 public:
  explicit BareClient(std::uint16_t port) : socket_(socket_to(port)) {}
  ~BareClient() { close(socket_); }

  void send(const std::string& text) { ::send(socket_, text.data(), text.size(), 0); }
  void send(const json& packet) { send(scan_cell_sim::sealed(packet)); }

  /// The next datagram as it came; empty if there is none.
  std::string receive_bytes(int milliseconds) {
    pollfd readable{socket_, POLLIN, 0};
    if (poll(&readable, 1, milliseconds) != 1) return "";
    std::string text(65536, '\0');
    const ssize_t length = recv(socket_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
    return text;
  }

  /// The next datagram, or null.
  json receive(int milliseconds = 2000) {
    const std::string text = receive_bytes(milliseconds);
    return text.empty() ? json(nullptr) : json::parse(text);
  }

  json receive(const std::string& type, int milliseconds = 2000) {
    json datagram = receive(milliseconds);
    while (!datagram.is_null() && datagram["type"] != type)
      datagram = receive(milliseconds);
    return datagram;
  }

  /// Drops what has arrived: a full receive buffer cannot take an answer.
  void drain() {
    while (!receive(0).is_null()) {
    }
  }

  json ask(std::uint64_t seq, json request, std::uint64_t session = 100) {
    request.update({{"c4g", 1}, {"session", session}, {"seq", seq}});
    send(request);
    return receive("ack");
  }

  json open(std::uint64_t session = 100) { return ask(1, {{"cmd", "OPEN"}}, session); }

 private:
  int socket_;
};

inline json move_to(double x, double y, double z) {
  return {{"cmd", "MOVE_CARTESIAN"}, {"pose", {x, y, z, 0, 180, 180}}, {"camera_fps", 100}};
}

/// @param via x, y, z, A, E, R
inline json move_through(const json& via, double x, double y, double z) {
  json move = move_to(x, y, z);
  move.update({{"cmd", "MOVE_CIRCULAR"}, {"via", via}});
  return move;
}

inline int code(const json& ack) {
  return ack["error"].is_null() ? 0 : ack["error"]["code"].get<int>();
}
