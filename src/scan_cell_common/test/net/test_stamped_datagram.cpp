// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/net/stamped_datagram.h"

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::receive_stamped;

namespace {

/// Two ends of a datagram socket; the kernel stamps what the second one receives, if asked to.
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
    const auto datagram = receive_stamped(ends_[1], &data, 1);
    EXPECT_TRUE(datagram && datagram->size == 1 && !datagram->cut && data == '?');
    return datagram ? datagram->receipt : std::nullopt;
  }
  int end() const { return ends_[1]; }

 private:
  int ends_[2] = {-1, -1};
};

}  // namespace

TEST(StampedDatagram, SaysWhenItCameHoweverLateItIsRead) {
  Datagrams datagrams(true);
  const Nanoseconds before = host_now();
  datagrams.send();
  const Nanoseconds sent = host_now();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // while the reader is busy
  const auto received = datagrams.receive();
  ASSERT_TRUE(received);
  EXPECT_LE(before, *received);
  EXPECT_LE(*received, sent);
}

TEST(StampedDatagram, HasNoTimeWhereTheKernelGaveNone) {
  Datagrams datagrams(false);
  datagrams.send();
  EXPECT_FALSE(datagrams.receive());
}

TEST(StampedDatagram, IsNoneWhereNothingWaits) {
  const Datagrams datagrams(true);
  char data = 0;
  EXPECT_FALSE(receive_stamped(datagrams.end(), &data, 1));
}

TEST(StampedDatagram, SaysThatItWasLongerThanTheRoomForIt) {
  Datagrams datagrams(true);
  datagrams.send();
  char data = 0;
  const auto datagram = receive_stamped(datagrams.end(), &data, 0);
  ASSERT_TRUE(datagram);
  EXPECT_TRUE(datagram->cut);
  EXPECT_EQ(datagram->size, 0U);
}
