// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Paths of the tool on the wire: loaded in pieces, followed only when whole.
#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include "controller/bare_client.h"
#include "controller/wire/wire_json.h"
#include "scan_cell_sim/controller/offline_controller.h"

using nlohmann::json;
using scan_cell_common::Nanoseconds;

namespace {

json waypoint(double x, double y, int outputs = 0) {
  return {x, y, 600, 0, 180, 180, 50, 1, outputs};
}

class PathOnTheWire : public testing::Test {
 protected:
  void SetUp() override { open(100); }

  void open(std::uint64_t session) {
    session_ = session;
    seq_ = 0;
    ASSERT_EQ(code(ask({{"cmd", "OPEN"}})), 0);
  }

  std::string packet(json request) {
    request.update({{"c4g", 1}, {"session", session_}, {"seq", ++seq_}});
    return scan_cell_sim::sealed(request);
  }

  json send(const std::string& datagram) {
    now_ += 10'000'000;
    return json::parse(controller_.answer(datagram, now_).value());
  }

  json ask(const json& request) { return send(packet(request)); }

  json load(std::uint64_t path, int size) {
    return ask(
        {{"cmd", "LOAD_PATH"}, {"path", path}, {"size", size}, {"tool", {0, 0, 0, 0, 0, 0}}});
  }

  json piece(std::uint64_t path, int first, const std::vector<json>& waypoints) {
    return ask({{"cmd", "PATH_PIECE"}, {"path", path}, {"first", first}, {"waypoints", waypoints}});
  }

  json follow(std::uint64_t path, int from, const json& checksum, const json& watch = 100) {
    return ask({{"cmd", "FOLLOW_PATH"},
                {"path", path},
                {"from", from},
                {"checksum", checksum},
                {"watch", watch}});
  }

  /// Loads a path of three waypoints from the robot's position; returns the acknowledgement of the
  /// last piece.
  json load_whole() {
    load(5, 3);
    piece(5, 0, {waypoint(800, 0)});
    return piece(5, 1, {waypoint(820, 0, 1), waypoint(820, 20)});
  }

  scan_cell_sim::OfflineController controller_;
  Nanoseconds now_ = 1'000'000'000;
  std::uint64_t session_ = 0, seq_ = 0;
};

}  // namespace

TEST_F(PathOnTheWire, IsConfirmedWithTheChecksumOverAllItsDatagrams) {
  boost::crc_32_type crc;
  const auto take = [&](const std::string& datagram) {
    const std::string seal = datagram.substr(datagram.rfind(':') + 1);
    const std::string text = seal.substr(0, seal.size() - 1) + ",";
    crc.process_bytes(text.data(), text.size());
    return datagram;
  };
  send(
      take(packet({{"cmd", "LOAD_PATH"}, {"path", 5}, {"size", 2}, {"tool", {0, 0, 0, 0, 0, 0}}})));
  const json ack = send(take(packet({{"cmd", "PATH_PIECE"},
                                     {"path", 5},
                                     {"first", 0},
                                     {"waypoints", {waypoint(800, 0), waypoint(820, 0)}}})));
  EXPECT_EQ(ack["value"], (json{2, crc.checksum()}));
  EXPECT_EQ(code(follow(5, 0, crc.checksum())), 0);
  EXPECT_EQ(controller_.motions_begun(), 1u);
}

TEST_F(PathOnTheWire, IsFollowedOnceHoweverOftenItsStartComes) {
  const json ack = load_whole();
  const std::string start = packet({{"cmd", "FOLLOW_PATH"},
                                    {"path", 5},
                                    {"from", 0},
                                    {"checksum", ack["value"][1]},
                                    {"watch", 100}});
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(code(send(start)), 0);
  now_ += 20'000'000'000;
  EXPECT_EQ(code(send(start)), 0);
  EXPECT_EQ(controller_.motions_begun(), 1u);
}

TEST_F(PathOnTheWire, TakesARepeatedPieceOnce) {
  load(5, 3);
  const std::string piece = packet({{"cmd", "PATH_PIECE"},
                                    {"path", 5},
                                    {"first", 0},
                                    {"waypoints", {waypoint(800, 0), waypoint(820, 0)}}});
  const json first = send(piece);
  EXPECT_EQ(send(piece), first);
  EXPECT_EQ(first["value"][0], 2);
}

TEST_F(PathOnTheWire, IsRefusedUnlessItIsWholeAndTheOneThatIsMeant) {
  EXPECT_EQ(code(follow(5, 0, 0)), 20) << "none is loaded";
  EXPECT_EQ(code(piece(5, 0, {waypoint(800, 0)})), 20) << "none is begun";
  const json begun = load(5, 3);
  EXPECT_EQ(code(follow(5, 0, begun["value"][1])), 20) << "no waypoints";
  EXPECT_EQ(code(piece(6, 0, {waypoint(800, 0)})), 20) << "another path";
  EXPECT_EQ(code(piece(5, 1, {waypoint(800, 0)})), 20) << "out of turn";
  const json one = piece(5, 0, {waypoint(800, 0)});
  EXPECT_EQ(code(piece(5, 0, {waypoint(800, 0)})), 20) << "again";
  EXPECT_EQ(code(follow(5, 0, one["value"][1])), 20) << "one waypoint of three";
  EXPECT_EQ(code(piece(5, 1, {waypoint(8, 0), waypoint(8, 1), waypoint(8, 2)})), 20) << "too many";
  const json ack = piece(5, 1, {waypoint(820, 0), waypoint(820, 20)});
  EXPECT_EQ(code(follow(6, 0, ack["value"][1])), 20) << "another path";
  EXPECT_EQ(code(follow(5, 0, one["value"][1])), 20) << "another checksum";
  EXPECT_EQ(code(follow(5, 2, ack["value"][1])), 9) << "from the last waypoint";
  EXPECT_EQ(code(follow(5, 1, ack["value"][1])), 22) << "it stands elsewhere";
  EXPECT_EQ(controller_.motions_begun(), 0u);
  EXPECT_EQ(code(follow(5, 0, ack["value"][1])), 0);
}

TEST_F(PathOnTheWire, RefusesWaypointsThatAreNoneAndKeepsWhatItHas) {
  const json before = load(5, 3);
  const auto with = [](std::size_t at, const json& value) {
    json bad = waypoint(800, 0);
    bad[at] = value;
    return std::vector<json>{bad};
  };
  EXPECT_EQ(code(piece(5, 0, {})), 1);
  EXPECT_EQ(code(piece(5, 0, {json::array({1, 2, 3})})), 1);
  EXPECT_EQ(code(piece(5, 0, with(0, "x"))), 1);
  EXPECT_EQ(code(piece(5, 0, with(8, -1))), 1);
  EXPECT_EQ(code(piece(5, 0, with(4, 181))), 9);
  EXPECT_EQ(code(piece(5, 0, with(6, 0))), 9);
  EXPECT_EQ(code(piece(5, 0, with(6, 1501))), 9);
  EXPECT_EQ(code(piece(5, 0, with(7, -1))), 9);
  EXPECT_EQ(code(piece(5, 0, with(7, 101))), 9);
  EXPECT_EQ(code(piece(5, 0, with(8, 1ull << 32))), 9);
  EXPECT_EQ(code(load(0, 3)), 9);
  EXPECT_EQ(code(load(7, 1)), 9);
  EXPECT_EQ(code(load(7, 10001)), 9);
  EXPECT_EQ(piece(5, 0, {waypoint(800, 0)})["value"][0], 1);
}

TEST_F(PathOnTheWire, IsDroppedByANewSession) {
  const json ack = load_whole();
  open(101);
  EXPECT_EQ(code(follow(5, 0, ack["value"][1])), 20);
  EXPECT_EQ(controller_.motions_begun(), 0u);
}

TEST_F(PathOnTheWire, IsToldWithItsWaypointAndOutputs) {
  const json ack = load_whole();
  EXPECT_EQ(code(follow(5, 0, ack["value"][1])), 0);
  now_ += 450'000'000;  // past 20 mm at 50 mm/s
  const json streamed = json::parse(controller_.stream(now_).value());
  EXPECT_EQ(streamed["waypoint"], 1);
  EXPECT_EQ(streamed["outputs"], 1);
  EXPECT_EQ(streamed["motion"], seq_);
  const json stopped = ask({{"cmd", "STOP"}});
  EXPECT_EQ(stopped["state"]["outputs"], 0);
}
