// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The thesis' lookup after the scan (section 6.2), over a real socket.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <random>

#include "lookup_server.h"
#include "poses/pose_table.h"
#include "scan_cell_common/errors/errors.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

constexpr double kDegree = M_PI / 180;

Eigen::Matrix3d about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
}

Eigen::Matrix3d rotation(double rx, double ry, double rz) {
  return about(Eigen::Vector3d::UnitZ(), rz) * about(Eigen::Vector3d::UnitY(), ry) *
         about(Eigen::Vector3d::UnitX(), rx);
}

PoseTable table() {
  PoseTable poses;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation(10, -20, 130);
  for (std::uint64_t frame : {65536, 7, 9, 9}) {
    pose.translation() << 0.001 * static_cast<double>(frame), -0.5, 0.25;
    poses.add(frame, pose);
  }
  poses.seal();
  return poses;
}

/// An old client.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected = ::connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof(place)) == 0;
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void send(const std::string& bytes) { ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }

  /// A line without its end, or "hung up".
  std::string receive() {
    std::string line;
    char byte = 0;
    pollfd look{socket_, POLLIN, 0};
    constexpr int kPatience = 20000;  // [ms]
    while (::poll(&look, 1, kPatience) > 0 && ::recv(socket_, &byte, 1, 0) == 1) {
      if (byte == '\n') return line;
      line += byte;
    }
    return "hung up";
  }
  std::string ask(const std::string& line) {
    send(line);
    return receive();
  }

  bool connected = false;

 private:
  int socket_;
};

LookupServer::Answer echo() {
  return [](std::string_view line) { return "<" + std::string(line) + ">"; };
}

}  // namespace

TEST(DocumentUnits, AreMillimetresAndTurnsAboutTheFixedAxes) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 1, -2, 0.0005;
  pose.linear() = rotation(30, 40, -50);
  const std::array<double, 6> six = to_document_units(pose);
  const double expected[6] = {1000, -2000, 0.5, 30, 40, -50};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(six[i], expected[i], 1e-9);
}

TEST(DocumentUnits, GiveTheRotationBackWhateverItIs) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-180, 180);
  for (int i = 0; i < 3000; ++i) {
    const double ry = i % 3 == 0 ? 90 : i % 3 == 1 ? -90 : angle(random);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation(angle(random), ry, angle(random));
    const std::array<double, 6> six = to_document_units(pose);
    EXPECT_LT((rotation(six[3], six[4], six[5]) - pose.linear()).norm(), 1e-7);
    EXPECT_LE(std::abs(six[4]), 90 + 1e-9);
  }
}

TEST(PoseTable, AnswersFrameNumbersAlone) {
  const PoseTable poses = table();
  EXPECT_EQ(poses.answer("7"),
            "7.000000,-500.000000,250.000000,10.000000000,-20.000000000,130.000000000");
  EXPECT_EQ(poses.answer(" 65536 \r").substr(0, 13), "65536.000000,");
  EXPECT_EQ(poses.answer("8"), "NONE");
  EXPECT_EQ(poses.answer("0"), "NONE");
  EXPECT_EQ(poses.answer("18446744073709551615"), "NONE");
  EXPECT_EQ(poses.answer("9").substr(0, 30), "ERROR the camera was restarted");
  for (const char* line : {"", " ", "-7", "7.0", "7 8", "seven", "18446744073709551616", "0x7"})
    EXPECT_EQ(poses.answer(line).substr(0, 5), "ERROR") << line;
  EXPECT_EQ(PoseTable().answer("7"), "NONE");
}

TEST(LookupServer, AnswersALineWithALine) {
  const LookupServer server("127.0.0.1", 0, {}, echo());
  Client client(server.port());
  EXPECT_EQ(client.ask("12\n"), "<12>");
  EXPECT_EQ(client.ask("13\r\n"), "<13\r>");
  client.send("1");
  EXPECT_EQ(client.ask("4\n15\n"), "<14>");
  EXPECT_EQ(client.receive(), "<15>");
  EXPECT_EQ(client.ask(std::string("16\0", 3)), "<16>");    // a C string
  EXPECT_EQ(client.ask(std::string("17\n\0", 4)), "<17>");  // with both ends
  EXPECT_EQ(client.ask("18\n"), "<18>");
}

TEST(LookupServer, ServesSeveralClientsAndNoMoreThanAllowed) {
  LookupLimits limits;
  limits.max_clients = 2;
  const LookupServer server("127.0.0.1", 0, limits, echo());
  Client first(server.port());
  EXPECT_EQ(first.ask("1\n"), "<1>");
  {
    Client second(server.port());
    EXPECT_EQ(second.ask("2\n"), "<2>");
    Client third(server.port());
    EXPECT_EQ(third.receive(), "ERROR too many clients");
    EXPECT_EQ(third.receive(), "hung up");
  }
  std::string answer;
  for (int i = 0; i < 1000 && answer != "<4>"; ++i)  // until the second client's place is free
    answer = Client(server.port()).ask("4\n");
  EXPECT_EQ(answer, "<4>");
  EXPECT_EQ(first.ask("5\n"), "<5>");
}

TEST(LookupServer, HangsUpALineWithoutEndAndASilentClient) {
  LookupLimits limits;
  limits.max_bytes = 8;
  limits.idle_time = 1;
  const LookupServer server("127.0.0.1", 0, limits, echo());
  Client talker(server.port());
  EXPECT_EQ(talker.ask("12345678\n"), "<12345678>");
  EXPECT_EQ(talker.ask("123456789"), "ERROR line too long");
  EXPECT_EQ(talker.receive(), "hung up");
  Client silent(server.port());
  EXPECT_TRUE(silent.connected);
  EXPECT_EQ(silent.receive(), "hung up");
}

TEST(LookupServer, StandsClientsThatSendAnythingAndNeverRead) {
  const LookupServer server("127.0.0.1", 0, {}, echo());
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    Client client(server.port());
    std::string bytes(20000, '\0');
    for (char& byte : bytes)
      byte = i % 2 == 0 ? static_cast<char>(random()) : "1\n"[random() % 2];
    client.send(bytes);
  }
  std::string answer;
  for (int i = 0; i < 1000 && answer != "<1>"; ++i)
    answer = Client(server.port()).ask("1\n");
  EXPECT_EQ(answer, "<1>");
}

TEST(LookupServer, RefusesAPortThatIsTakenAndAnAddressThatIsNone) {
  const LookupServer server("127.0.0.1", 0, {}, echo());
  EXPECT_THROW(LookupServer("127.0.0.1", server.port(), {}, echo()),
               scan_cell_common::ConnectionError);
  EXPECT_THROW(LookupServer("localhost", 0, {}, echo()), scan_cell_common::ConnectionError);
  EXPECT_THROW(LookupServer("203.0.113.7", 0, {}, echo()), scan_cell_common::ConnectionError);
}
