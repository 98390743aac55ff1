// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "scan_cell_common/errors/errors.h"
#include "wire/peer_socket.h"

using c4g_driver::PeerSocket;

namespace {

constexpr std::size_t kMost = 100;
constexpr double kPatience = 20;  // [s]

sockaddr_in on(const std::string& address, std::uint16_t port) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(port);
  inet_pton(AF_INET, address.c_str(), &result.sin_addr);
  return result;
}

/// Another program on this machine, with its own address and port.
class Somebody {
 public:
  explicit Somebody(const std::string& address) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in name = on(address, 0);
    socklen_t size = sizeof name;
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&name), size), 0);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&name), &size);
    port_ = ntohs(name.sin_port);
    const timeval patience{static_cast<time_t>(kPatience), 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~Somebody() { close(socket_); }
  std::uint16_t port() const { return port_; }

  /// Waits for a datagram. @return who sent it
  sockaddr_in receive() const {
    char byte = 0;
    sockaddr_in from{};
    socklen_t size = sizeof from;
    EXPECT_GE(recvfrom(socket_, &byte, 1, 0, reinterpret_cast<sockaddr*>(&from), &size), 0);
    return from;
  }
  void send(const sockaddr_in& to, const std::string& text) const {
    sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

}  // namespace

TEST(PeerSocket, IsBoundToTheAddressItIsGiven) {
  const Somebody controller("127.0.0.1");
  PeerSocket socket("127.0.0.7", "127.0.0.1", controller.port(), kMost);
  ASSERT_TRUE(socket.send("hello"));
  EXPECT_EQ(controller.receive().sin_addr.s_addr, on("127.0.0.7", 0).sin_addr.s_addr);
}

TEST(PeerSocket, RefusesAnAddressThatIsNotOfThisMachineByItsName) {
  try {
    PeerSocket socket("192.0.2.77", "127.0.0.1", 5410, kMost);  // reserved for documentation
    FAIL() << "it listens nowhere";
  } catch (const scan_cell_common::InvalidParameter& error) {
    EXPECT_NE(std::string(error.what()).find("local address: '192.0.2.77'"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(PeerSocket("eth0", "127.0.0.1", 5410, kMost), scan_cell_common::InvalidParameter);
  EXPECT_THROW(PeerSocket("0.0.0.0", "robot", 5410, kMost), scan_cell_common::InvalidParameter);
}

TEST(PeerSocket, HearsItsPeerOnlyAndCountsTheOthers) {
  const Somebody controller("127.0.0.1");
  const Somebody other_port("127.0.0.1");
  const Somebody other_address("127.0.0.8");
  PeerSocket socket("127.0.0.7", "127.0.0.1", controller.port(), kMost);
  ASSERT_TRUE(socket.send("hello"));
  const sockaddr_in here = controller.receive();
  other_port.send(here, "stranger");
  other_address.send(here, "stranger");
  controller.send(here, std::string(kMost + 1, 'a'));
  controller.send(here, "well");
  const auto received = socket.receive(kPatience);
  ASSERT_TRUE(received);
  EXPECT_EQ(std::string(received->datagram), "well");
  EXPECT_EQ(socket.foreign(), 2U);
  EXPECT_EQ(socket.overlong(), 1U);
}
