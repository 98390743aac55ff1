// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause Tests what the
// tests of its users do not: test_lookup.cpp and test_videe_connection.cpp test the rest.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "scan_cell_common/net/descriptor.h"
#include "scan_cell_common/net/endpoint.h"
#include "scan_cell_common/net/line_server.h"

using scan_cell_common::Descriptor;
using scan_cell_common::Endpoint;
using scan_cell_common::LineServer;

namespace {

class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const sockaddr_in place = Endpoint::parse("server", "127.0.0.1", port).to_kernel();
    EXPECT_EQ(::connect(socket_.number(), reinterpret_cast<const sockaddr*>(&place), sizeof place),
              0);
  }
  void send(const std::string& text) const {
    ::send(socket_.number(), text.data(), text.size(), MSG_NOSIGNAL);
  }
  std::string receive() const {
    std::string line;
    char byte = 0;
    pollfd look{socket_.number(), POLLIN, 0};
    constexpr int kPatience = 20000;  // [ms]
    while (::poll(&look, 1, kPatience) > 0 && ::recv(socket_.number(), &byte, 1, 0) == 1) {
      if (byte == '\n') return line;
      line += byte;
    }
    return "hung up";
  }

 private:
  Descriptor socket_;
};

std::string echo(const std::string& line, const LineServer::ClientThere&) {
  return line;
}

LineServer::Options two_clients() {
  LineServer::Options options;
  options.name = "echo";
  options.max_clients = 2;
  options.too_many_clients = "first come: {}";
  return options;
}

}  // namespace

TEST(LineServer, AnswersHoweverMuchIsSentAheadInOrder) {
  const LineServer server(two_clients(), echo);
  const Client client(server.port());
  std::string text;
  constexpr int kLines = 20000;
  for (int i = 0; i < kLines; ++i)
    text += std::to_string(i) + "\n";
  std::thread sender([&] { client.send(text); });
  for (int i = 0; i < kLines; ++i)
    ASSERT_EQ(client.receive(), std::to_string(i));
  sender.join();
}

TEST(LineServer, LetsAClientWaitWhereAPlaceIsAboutToBeFree) {
  std::atomic<bool> lost{false};
  const LineServer server(two_clients(), echo, [&lost] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    lost = true;
  });
  const Client first(server.port());
  first.send("1\n");
  EXPECT_EQ(first.receive(), "1");
  { const Client second(server.port()); }
  const Client third(server.port());
  third.send("3\n");
  EXPECT_EQ(third.receive(), "3");
  EXPECT_TRUE(lost);
  EXPECT_EQ(Client(server.port()).receive(), "first come: 127.0.0.1");
}

TEST(LineServer, EndsWhileALineIsAnsweredAndDropsThoseThatWait) {
  std::atomic<int> answered{0};
  std::atomic<bool> lost{false};
  auto server = std::make_unique<LineServer>(
      two_clients(),
      [&](const std::string&, const LineServer::ClientThere& there) {
        ++answered;
        while (there())
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return "";
      },
      [&lost] { lost = true; });
  const Client client(server->port());
  client.send("1\n2\n3\n");
  while (answered == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  server.reset();
  EXPECT_EQ(answered, 1);
  EXPECT_TRUE(lost);
}
