// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <netinet/in.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

/// A controller on a real socket that does what a test tells it, and otherwise behaves well: it
/// acknowledges every request, and a motion stays "moving" and is streamed until the test says
/// otherwise.
class FakeController {
 public:
  using Json = nlohmann::json;
  /// What to answer to a request; none: the normal answer.
  using Script = std::function<std::optional<std::vector<Json>>(const Json& request)>;

  explicit FakeController(std::uint16_t port = 0);
  ~FakeController();

  std::uint16_t port() const { return port_; }

  void play(const Script& script);
  /// Entries of every state from now on.
  void set_state(const Json& entries);

  void stop_streaming();

  /// Streams a state to the client.
  void stream(std::uint64_t number, std::int64_t microseconds, const Json& entries = {});
  void send(const std::string& text);
  /// Sends as a stranger to the client of another controller.
  void send_to_client_of(const FakeController& other, const std::string& text);

  Json acknowledge(const Json& request);

  /// Requests so far; of one kind if `command` is given.
  std::vector<Json> requests(const std::string& command = "") const;

 private:
  void serve();
  Json state_at(std::int64_t microseconds) const;
  std::int64_t clock() const;  // [us]

  int socket_;
  std::uint16_t port_ = 0;
  mutable std::recursive_mutex mutex_;
  Script script_;
  Json state_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::uint64_t streamed_ = 0;
  bool streaming_ = true;
  std::vector<Json> requests_;
  sockaddr_in client_{};
  bool ending_ = false;
  std::thread thread_;
};
