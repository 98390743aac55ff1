// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a client can end, on real sockets.
#include <gtest/gtest.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <future>
#include <sstream>
#include <thread>

#include "videe/videe_client.h"

using namespace videe_test;  // NOLINT
using scan_cell::VideeCommandKind;

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

/// A server whose STOP_SCAN waits until the client is gone, for at most 20 s.
class Waiting {
 public:
  std::uint16_t port() const { return server_.port(); }

  void wait_until_under_way() { begun_.get_future().wait(); }

  /// Whether STOP_SCAN noticed that the client is gone, and the client was given up.
  bool noticed() {
    constexpr seconds kPatience(30);
    return lost_.get_future().wait_for(kPatience) == std::future_status::ready && noticed_;
  }

 private:
  std::string handle(const scan_cell::VideeCommand& command, const ClientThere& client_there) {
    if (command.kind != VideeCommandKind::kStopScan) return "";
    EXPECT_TRUE(client_there());
    begun_.set_value();
    const auto deadline = Clock::now() + seconds(20);
    while (client_there() && Clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    noticed_ = !client_there();
    return "";
  }

  std::promise<void> begun_, lost_;
  bool noticed_ = false;  // before lost_
  scan_cell::VideeServer server_{
      at_any_port(),
      [this](const auto& command, const auto& there) { return handle(command, there); },
      [this] { lost_.set_value(); }};
};

/// This many bytes of short commands.
std::string commands(std::size_t bytes) {
  std::string text;
  while (text.size() < bytes)
    text += "INIT_CYCLE\n";
  return text;
}

/// Sends STOP_SCAN, and then as much as there is room for.
void send_ahead(Waiting& server, Client& client, const std::string& ahead) {
  client.send("STOP_SCAN\n");
  server.wait_until_under_way();
  client.send_what_fits(ahead);
}

void set_loopback(bool up) {
  ifreq request{};
  std::snprintf(request.ifr_name, sizeof request.ifr_name, "lo");
  const int any = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(ioctl(any, SIOCGIFFLAGS, &request), 0);
  request.ifr_flags = static_cast<short>(up ? request.ifr_flags | IFF_UP  // NOLINT: the kernel's
                                            : request.ifr_flags & ~IFF_UP);
  ASSERT_EQ(ioctl(any, SIOCSIFFLAGS, &request), 0);
  close(any);
}

/// Runs a test in a process with its own loopback device.
/// @return its exit code
int with_own_network(const std::function<bool()>& test, int not_allowed) {
  const pid_t process = fork();
  if (process == 0) {
    const bool allowed = unshare(CLONE_NEWNET | (geteuid() == 0 ? 0 : CLONE_NEWUSER)) == 0;
    if (!allowed) _exit(not_allowed);
    set_loopback(true);
    _exit(test() && !testing::Test::HasFailure() ? 0 : 1);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST(VideeConnection, ItsEndIsNoticedWhileACommandIsUnderWayAndOthersWait) {
  for (const std::string& ahead : {std::string(), std::string("RESET"), commands(60000)}) {
    Waiting server;
    {
      Client client(server.port());
      send_ahead(server, client, ahead);
    }
    EXPECT_TRUE(server.noticed()) << ahead.size() << " bytes ahead";
  }
}

TEST(VideeConnection, ItsEndIsNoticedBehindMegabytesThatNobodyAskedFor) {
  constexpr std::size_t kMegabyte = 1000000;
  for (const std::size_t size : {kMegabyte / 5, kMegabyte, 8 * kMegabyte}) {
    for (const std::string& ahead : {commands(size), std::string(size, 'A')}) {
      Waiting server;
      {
        Client client(server.port());
        send_ahead(server, client, ahead);
      }
      EXPECT_TRUE(server.noticed()) << size << " bytes of " << ahead.substr(0, 5);
    }
  }
}

TEST(VideeConnection, IsGoneWhereTheClientClosesItInItsDirectionAlone) {
  for (const std::size_t ahead : {0, 60000}) {
    Waiting server;
    Client client(server.port());
    send_ahead(server, client, commands(ahead));
    client.close_sending();
    EXPECT_TRUE(server.noticed()) << ahead;
    EXPECT_EQ(client.receive(), "OK") << "what it asked for before is still answered";
  }
}

TEST(VideeConnection, IsGoneWhereTheClientResetsIt) {
  for (const std::size_t ahead : {0, 60000}) {
    Waiting server;
    {
      Client client(server.port());
      send_ahead(server, client, commands(ahead));
      client.reset_at_the_end();
    }
    EXPECT_TRUE(server.noticed()) << ahead;
  }
}

TEST(VideeConnection, ItsEndIsNoticedWhileTheClientDoesNotTakeItsAnswers) {
  std::promise<void> lost;
  const std::string long_answer(2000000, 'x');
  std::promise<void> begun;
  scan_cell::VideeServer server(
      at_any_port(),
      [&](const auto&, const auto&) {
        begun.set_value();
        return long_answer;
      },
      [&lost] { lost.set_value(); });
  Client client(server.port(), "127.0.0.1", 4096);
  client.send("GRAB_IMAGE\n");
  begun.get_future().wait();
  client.close_sending();
  EXPECT_EQ(lost.get_future().wait_for(seconds(3)), std::future_status::ready)
      << "that a client takes no answer is suffered for five seconds only where it is there";
}

TEST(VideeConnection, IsGoneWithinSecondsWhereTheLineGoesDead) {
  constexpr int kNotAllowed = 77;
  const int end = with_own_network(
      [] {
        Waiting server;
        Client client(server.port());
        send_ahead(server, client, commands(1000));
        set_loopback(false);
        const auto dead = Clock::now();
        return server.noticed() && Clock::now() - dead < seconds(10);
      },
      kNotAllowed);
  if (end == kNotAllowed) GTEST_SKIP() << "no network namespaces here";
  EXPECT_EQ(end, 0);
}

TEST(VideeConnection, EndsWhereTooMuchIsSentAheadAndSaysSo) {
  Waiting server;
  Client client(server.port());
  send_ahead(server, client, commands(70000));
  EXPECT_TRUE(server.noticed());
  std::string line = client.receive();
  while (line == "OK")
    line = client.receive();
  EXPECT_EQ(line, "ERROR more than 65536 bytes ahead of their answers; wait for each answer");
  EXPECT_TRUE(client.hung_up());
}

TEST(VideeConnection, TellsWhyAlsoAClientThatGoesOnSending) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
  Client client(server.port());
  client.send_what_fits(std::string(2000000, 'A'));
  EXPECT_EQ(client.receive().find("ERROR line too long"), 0U);
  EXPECT_TRUE(client.hung_up());
}

TEST(VideeConnection, AnswersInUtf8AndEscapesWhatIsNone) {
  scan_cell::VideeServer server(
      at_any_port(),
      [](const auto&, const auto&) { return "/b\xC3\xBCro/\xE9\x1b[31m\xC2\x9B.png"; }, [] {});
  Client client(server.port());
  client.send("GRAB_IMAGE\n");
  EXPECT_EQ(client.receive(), "OK /b\xC3\xBCro/\\xE9?[31m\\xC2\\x9B.png");
  client.send("GR\xC3\x9C\xDF!\n");
  EXPECT_EQ(client.receive().find("ERROR command 'GR\xC3\x9C\\xDF!': unknown"), 0U);
}

TEST(VideeConnection, ProbesALineThatIsSilentSoThatAPulledCableIsNoticed) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
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

TEST(VideeConnection, AnswersInOneLineWhateverIsThrown) {
  scan_cell::VideeServer server(
      at_any_port(),
      [](const scan_cell::VideeCommand&, const auto&) -> std::string {
        throw std::runtime_error("two\nlines");
      },
      [] {});
  Client client(server.port());
  client.send("GRAB_IMAGE\nRESET\n");
  EXPECT_EQ(client.receive(), "ERROR two lines");
  EXPECT_EQ(client.receive(), "ERROR two lines");
}

TEST(VideeConnection, CutsOffALineWithoutEnd) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
  Client client(server.port());
  client.send(std::string(5000, 'A'));
  EXPECT_EQ(client.receive().find("ERROR line too long"), 0U);
}

TEST(VideeConnection, CutsOffALineOneByteTooLongAndTakesOneThatIsNot) {
  scan_cell::VideeServer server(at_any_port(), nothing, [] {});
  const std::string longest = "RESET" + std::string(1018, ' ');  // 1024 bytes with its end
  Client client(server.port());
  client.send(longest + "\n");
  EXPECT_EQ(client.receive(), "OK");
  client.send(longest + " \n");
  EXPECT_EQ(client.receive().find("ERROR line too long"), 0U);
}
