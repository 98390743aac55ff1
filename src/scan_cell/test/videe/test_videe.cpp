// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <random>
#include <thread>

#include "scan_cell_common/errors/errors.h"
#include "videe/videe_client.h"

using namespace videe_test;  // NOLINT
using scan_cell::VideeCommandKind;
using scan_cell_common::ProtocolError;

TEST(VideePose, TurnsAboutFixedAxesInMillimetresAndDegrees) {
  const Eigen::Isometry3d pose = scan_cell::pose_from_wire("100,-20,5.5,90,0,90");
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(0.1, -0.02, 0.0055)));
  // x first: y -> z; then z: x -> y, y -> -x.
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ()));
}

TEST(VideePose, ComesBackFromTheWire) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> angle(-180, 180);
  for (int i = 0; i < 200; ++i) {
    const double ry = i % 4 == 0 ? (i % 8 == 0 ? 90 : -90) : angle(generator) / 2;
    const std::string text = "1,2,3," + std::to_string(angle(generator)) + "," +
                             std::to_string(ry) + "," + std::to_string(angle(generator));
    const Eigen::Isometry3d pose = scan_cell::pose_from_wire(text);
    const Eigen::Isometry3d back = scan_cell::pose_from_wire(scan_cell::pose_to_wire(pose));
    EXPECT_TRUE(back.isApprox(pose, 1e-6)) << text;
  }
}

TEST(VideeCommand, IsReadWithItsArguments) {
  EXPECT_EQ(scan_cell::parse_videe("INIT_CYCLE").kind, VideeCommandKind::kInitCycle);
  const auto command = scan_cell::parse_videe("SET_POSITION 1,2,3,4,5,6 2,2,3,4,5,6");
  EXPECT_EQ(command.kind, VideeCommandKind::kSetPosition);
  ASSERT_EQ(command.poses.size(), 2U);
  EXPECT_NEAR(command.poses[1].translation().x(), 0.002, 1e-12);
}

TEST(VideeCommand, IsRefusedWhereItMakesNoSense) {
  for (const char* line :
       {"", "JUMP", "init_cycle", "SET_POSITION", "SET_POSITION 1,2,3,4,5,6",
        "SET_POSITION 1,2,3,4,5 1,2,3,4,5,6", "SET_POSITION 1,2,3,4,5,nan 1,2,3,4,5,6",
        "SET_POSITION 1,2,3,4,5,6x 1,2,3,4,5,6", "START_SCAN now"}) {
    EXPECT_THROW(scan_cell::parse_videe(line), ProtocolError) << line;
  }
}

TEST(VideeCommand, NeverCrashesOnNoise) {
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> byte(0, 255);
  const std::string good = "SET_POSITION 1,2,3,4,5,6 2,2,3,4,5,6";
  for (int i = 0; i < 20000; ++i) {
    std::string line = good;
    for (int k = 0; k < 1 + i % 5; ++k) {
      line[static_cast<std::size_t>(byte(generator)) % line.size()] =
          static_cast<char>(byte(generator));
    }
    try {
      scan_cell::parse_videe(line);
    } catch (const ProtocolError&) {
    }
  }
}

TEST(VideeServer, AnswersEachCommandInTurn) {
  scan_cell::VideeServer server(
      at_any_port(),
      [](const scan_cell::VideeCommand& command, const auto&) -> std::string {
        if (command.kind == VideeCommandKind::kStartScan) {
          throw scan_cell_common::Refused("START_SCAN", "no positions", "send SET_POSITION first");
        }
        return command.kind == VideeCommandKind::kGrabImage ? "image.png" : "";
      },
      [] {});
  Client client(server.port());
  client.send("INIT_CYCLE\nGRAB_IMAGE\r\nSTART_SCAN\nNONSENSE\n");
  EXPECT_EQ(client.receive(), "OK");
  EXPECT_EQ(client.receive(), "OK image.png");
  EXPECT_EQ(client.receive(), "ERROR START_SCAN: no positions; send SET_POSITION first");
  EXPECT_EQ(client.receive().substr(0, 5), "ERROR");
}

TEST(VideeServer, TakesTheNextClientAfterOneIsLostAndSaysSo) {
  std::atomic<int> lost{0};
  scan_cell::VideeServer server(at_any_port(), nothing, [&lost] { ++lost; });
  { Client client(server.port()); }
  Client next(server.port());
  next.send("RESET\n");
  EXPECT_EQ(next.receive(), "OK");
  EXPECT_EQ(lost, 1);
}

TEST(VideeServer, TellsASecondClientThatThereIsOneAndServesTheFirstOn) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
  Client first(server.port());
  first.send("RESET\n");
  EXPECT_EQ(first.receive(), "OK");
  Client second(server.port());
  EXPECT_EQ(second.receive(), "ERROR another client is connected, from 127.0.0.1; try again later");
  EXPECT_TRUE(second.hung_up());
  first.send("RESET\n");
  EXPECT_EQ(first.receive(), "OK");
}

TEST(VideeServer, TellsASecondClientAlsoWhileACommandIsUnderWay) {
  std::promise<void> begun, end;
  scan_cell::VideeServer server(
      at_any_port(),
      [&](const scan_cell::VideeCommand&, const ClientThere&) {
        begun.set_value();
        end.get_future().wait();
        return "";
      },
      [] {});
  Client first(server.port());
  first.send("STOP_SCAN\n");
  begun.get_future().wait();
  EXPECT_EQ(Client(server.port()).receive().find("ERROR another client"), 0U);
  end.set_value();
  EXPECT_EQ(first.receive(), "OK");
}

TEST(VideeServer, HangsUpOnAClientThatIsIdleForTooLongAndSaysSo) {
  auto options = at_any_port();
  options.idle_time = 0.2;
  std::atomic<int> lost{0};
  scan_cell::VideeServer server(options, nothing, [&lost] { ++lost; });
  Client client(server.port());
  client.send("RES");  // half a command is not a command
  EXPECT_EQ(client.receive(), "ERROR no command for 0 s; connect again");
  EXPECT_TRUE(client.hung_up());
  Client next(server.port());
  next.send("RESET\n");
  EXPECT_EQ(next.receive(), "OK");
  EXPECT_GE(lost, 1) << "what the idle one had under way must be cancelled";
}

TEST(VideeServer, HasNoIdleTimeLimitForACommandUnderWay) {
  auto options = at_any_port();
  options.idle_time = 0.2;
  scan_cell::VideeServer server(
      options,
      [](const scan_cell::VideeCommand&, const ClientThere&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        return "late";
      },
      [] {});
  Client client(server.port());
  client.send("STOP_SCAN\n");
  EXPECT_EQ(client.receive(), "OK late");
}

TEST(VideeServer, AnswersNobodyButTheClientItIsSetTo) {
  auto options = at_any_port();
  options.client = "127.0.0.9";
  std::atomic<int> commands{0};
  scan_cell::VideeServer server(
      options,
      [&commands](const scan_cell::VideeCommand&, const ClientThere&) {
        ++commands;
        return "";
      },
      [] {});
  Client stranger(server.port(), "127.0.0.2");
  EXPECT_TRUE(stranger.hung_up());
  EXPECT_EQ(commands, 0);
  Client ours(server.port(), "127.0.0.9");
  ours.send("RESET\n");
  EXPECT_EQ(ours.receive(), "OK");
}

TEST(VideeServer, RefusesAPortInUse) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
  scan_cell::VideeServer::Options same;
  same.port = server.port();
  EXPECT_THROW(scan_cell::VideeServer(same, nothing, [] {}), scan_cell_common::ConnectionError);
}
