// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio.hpp>
#include <chrono>
#include <fstream>
#include <future>
#include <random>
#include <sstream>
#include <thread>

#include "scan_cell/videe_server.h"
#include "scan_cell_common/errors.h"

using boost::asio::ip::tcp;
using scan_cell::VideeCommandKind;
using scan_cell_common::ProtocolError;

namespace {

using ClientThere = scan_cell::VideeServer::ClientThere;

std::string nothing(const scan_cell::VideeCommand&, const ClientThere&) {
  return "";
}

class Client {
 public:
  explicit Client(std::uint16_t port) {
    socket_.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  }
  void send(const std::string& text) { boost::asio::write(socket_, boost::asio::buffer(text)); }
  std::string receive() {
    boost::asio::read_until(socket_, buffer_, '\n');
    std::istream stream(&buffer_);
    std::string line;
    std::getline(stream, line);
    return line;
  }

 private:
  boost::asio::io_context context_;
  tcp::socket socket_{context_};
  boost::asio::streambuf buffer_;
};

}  // namespace

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
  EXPECT_EQ(scan_cell::parse_videe("INIT_CYCLE").kind, VideeCommandKind::InitCycle);
  const auto command = scan_cell::parse_videe("SET_POSITION 1,2,3,4,5,6 2,2,3,4,5,6");
  EXPECT_EQ(command.kind, VideeCommandKind::SetPosition);
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
      "127.0.0.1", 0,
      [](const scan_cell::VideeCommand& command, const auto&) -> std::string {
        if (command.kind == VideeCommandKind::StartScan) {
          throw scan_cell_common::Refused("START_SCAN", "no positions", "send SET_POSITION first");
        }
        return command.kind == VideeCommandKind::GrabImage ? "image.png" : "";
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
  scan_cell::VideeServer server("127.0.0.1", 0, nothing, [&lost] { ++lost; });
  { Client client(server.port()); }
  Client next(server.port());
  next.send("RESET\n");
  EXPECT_EQ(next.receive(), "OK");
  EXPECT_EQ(lost, 1);
}

TEST(VideeServer, NoticesALostClientWhileItsCommandIsUnderWay) {
  std::promise<void> begun;
  std::promise<void> lost;
  bool noticed = false;
  scan_cell::VideeServer server(
      "127.0.0.1", 0,
      [&](const scan_cell::VideeCommand&, const ClientThere& client_there) {
        EXPECT_TRUE(client_there());
        begun.set_value();
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (client_there() && std::chrono::steady_clock::now() < deadline)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        noticed = !client_there();
        return "";
      },
      [&lost] { lost.set_value(); });
  {
    Client client(server.port());
    client.send("STOP_SCAN\nRESET");  // what was not read yet must not hide the end
    begun.get_future().wait();
  }
  lost.get_future().wait();
  EXPECT_TRUE(noticed);
}

TEST(VideeServer, ProbesALineThatIsSilentSoThatAPulledCableIsNoticed) {
  scan_cell::VideeServer server("127.0.0.1", 0, nothing, [] {});
  Client client(server.port());
  client.send("RESET\n");
  EXPECT_EQ(client.receive(), "OK");
  char port[5];
  std::snprintf(port, sizeof(port), "%04X", server.port());
  const std::string connected = "0100007F:" + std::string(port);
  const auto probed = [&connected] {  // timer 02 of proc(5)'s net/tcp is the keep-alive's
    std::ifstream connections("/proc/net/tcp");
    std::string line;
    while (std::getline(connections, line)) {
      std::istringstream words(line);
      std::string number, local, remote, state, queues, timer;
      words >> number >> local >> remote >> state >> queues >> timer;
      if (local == connected && state == "01" && timer.substr(0, 2) == "02") return true;
    }
    return false;
  };
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!probed() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(probed());
}

TEST(VideeServer, AnswersInOneLineWhateverIsThrown) {
  scan_cell::VideeServer server(
      "127.0.0.1", 0,
      [](const scan_cell::VideeCommand&, const auto&) -> std::string {
        throw std::runtime_error("two\nlines");
      },
      [] {});
  Client client(server.port());
  client.send("GRAB_IMAGE\nRESET\n");
  EXPECT_EQ(client.receive(), "ERROR two lines");
  EXPECT_EQ(client.receive(), "ERROR two lines");
}

TEST(VideeServer, CutsOffALineWithoutEnd) {
  scan_cell::VideeServer server("127.0.0.1", 0, nothing, [] {});
  Client client(server.port());
  client.send(std::string(5000, 'A'));
  EXPECT_EQ(client.receive(), "ERROR line too long");
}

TEST(VideeServer, RefusesAPortInUse) {
  scan_cell::VideeServer server("127.0.0.1", 0, nothing, [] {});
  EXPECT_THROW(scan_cell::VideeServer("127.0.0.1", server.port(), nothing, [] {}),
               scan_cell_common::ConnectionError);
}
