// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "scan_cell_common/host_clock.h"

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::receipt_time;

namespace {

/// Two ends of a datagram socket; the kernel stamps what the second receives where asked to.
class Datagrams {
 public:
  explicit Datagrams(bool stamped) {
    const int on = stamped ? 1 : 0;
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_DGRAM, 0, ends_), 0);
    EXPECT_EQ(setsockopt(ends_[1], SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on), 0);
  }
  ~Datagrams() {
    close(ends_[0]);
    close(ends_[1]);
  }
  Datagrams(const Datagrams&) = delete;
  Datagrams& operator=(const Datagrams&) = delete;

  void send() { EXPECT_EQ(::send(ends_[0], "?", 1, 0), 1); }
  std::optional<Nanoseconds> receive() {
    char data = 0;
    iovec part{&data, 1};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    EXPECT_EQ(recvmsg(ends_[1], &message, MSG_DONTWAIT), 1);
    return receipt_time(message);
  }

 private:
  int ends_[2] = {-1, -1};
};

}  // namespace

TEST(HostClock, IsTheWallClock) {
  const auto now = [] {
    const auto passed = std::chrono::system_clock::now().time_since_epoch();
    return Nanoseconds{std::chrono::duration_cast<std::chrono::nanoseconds>(passed).count()};
  };
  const Nanoseconds before = now();
  const Nanoseconds time = host_now();
  EXPECT_LE(before, time);
  EXPECT_LE(time, now());
}

TEST(ReceiptTime, IsWhenTheDatagramCameHoweverLateItIsRead) {
  Datagrams datagrams(true);
  const Nanoseconds before = host_now();
  datagrams.send();
  const Nanoseconds sent = host_now();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // what the reader was busy with
  const auto received = datagrams.receive();
  ASSERT_TRUE(received);
  EXPECT_LE(before, *received);
  EXPECT_LE(*received, sent);
}

TEST(ReceiptTime, IsNoneWhereTheKernelGaveNone) {
  Datagrams datagrams(false);
  datagrams.send();
  EXPECT_FALSE(datagrams.receive());
}
