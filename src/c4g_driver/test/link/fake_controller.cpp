// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/fake_controller.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "wire/seal.h"

FakeController::FakeController(std::uint16_t port)
    : socket_(socket(AF_INET, SOCK_DGRAM, 0)),
      state_({{"pose", {800, 0, 600, 0, 180, 180}},
              {"joints", {0, 8.1589, -124.1102, 0, 47.7310, 0}},
              {"status", "idle"},
              {"motion", 0},
              {"progress", 0},
              {"camera_fps", 0},
              {"e_stop", false},
              {"drives", true},
              {"mode", "remote"},
              {"override", 100},
              {"linear_speed", 250},
              {"waypoint", 0},
              {"outputs", 0},
              {"error", nullptr},
              {"alarms", nlohmann::json::array()}}) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  socklen_t size = sizeof address;
  getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { serve(); });
}

FakeController::~FakeController() {
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    ending_ = true;
  }
  thread_.join();
  close(socket_);
}

void FakeController::play(const Script& script) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  script_ = script;
}

void FakeController::set_state(const Json& entries) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  state_.update(entries);
}

void FakeController::stop_streaming() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  streaming_ = false;
}

std::int64_t FakeController::clock() const {
  const auto now = std::chrono::steady_clock::now();
  return std::chrono::duration_cast<std::chrono::microseconds>(now - start_).count();
}

FakeController::Json FakeController::state_at(std::int64_t microseconds) const {
  Json state = state_;
  state["t"] = microseconds;
  return state;
}

FakeController::Json FakeController::acknowledge(const Json& request) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  Json answer = {{"c4g", 1},         {"session", request["session"]},
                 {"type", "ack"},    {"seq", request["seq"]},
                 {"error", nullptr}, {"state", state_at(clock())}};
  const std::string name = request.value("name", "");
  if (name == "rotational_speed") answer["value"] = 60;
  if (name == "motion_type" || name == "interpolation") answer["value"] = "linear";
  return answer;
}

void FakeController::stream(std::uint64_t number, std::int64_t microseconds, const Json& entries) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  Json state = state_at(microseconds);
  state.update({{"c4g", 1}, {"type", "state"}, {"n", number}});
  state["session"] = requests_.back()["session"];
  if (entries.is_object()) state.update(entries);
  send(c4g_driver::seal(state.dump()));
}

void FakeController::send(const std::string& text) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<sockaddr*>(&client_),
         sizeof client_);
}

void FakeController::send_to_client_of(const FakeController& other, const std::string& text) {
  sockaddr_in client{};
  {
    const std::lock_guard<std::recursive_mutex> lock(other.mutex_);
    client = other.client_;
  }
  sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<sockaddr*>(&client), sizeof client);
}

std::vector<FakeController::Json> FakeController::requests(const std::string& command) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  std::vector<Json> chosen;
  for (const Json& request : requests_) {
    if (command.empty() || request["cmd"] == command) chosen.push_back(request);
  }
  return chosen;
}

void FakeController::serve() {
  while (true) {
    pollfd readable{socket_, POLLIN, 0};
    const bool came = poll(&readable, 1, 10) == 1;
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    if (ending_) return;
    if (streaming_ && state_["status"] == "moving") stream(++streamed_, clock());
    if (!came) continue;
    std::string text(2000, '\0');
    socklen_t size = sizeof client_;
    const ssize_t length = recvfrom(socket_, text.data(), text.size(), 0,
                                    reinterpret_cast<sockaddr*>(&client_), &size);
    if (length < 0) continue;
    text.resize(static_cast<std::size_t>(length));
    const Json request = Json::parse(text);
    if (request["cmd"] == "OPEN") streamed_ = 0;
    requests_.push_back(request);
    if (request["cmd"].get<std::string>().compare(0, 4, "MOVE") == 0) {
      set_state({{"status", "moving"}, {"motion", request["seq"]}});
    }
    const auto answers = script_ ? script_(request) : std::nullopt;
    for (const Json& answer : answers.value_or(std::vector<Json>{acknowledge(request)}))
      send(c4g_driver::seal(answer.dump()));
  }
}
