// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/net/udp_socket.h"

using scan_cell_common::Endpoint;
using scan_cell_common::host_now;
using scan_cell_common::UdpSocket;

namespace {

constexpr double kPatience = 20;  // [s]
const Endpoint kAnyPort = Endpoint::parse("test", "127.0.0.1", 0);

}  // namespace

TEST(Endpoint, ComesBackFromTextAndFromTheKernel) {
  const Endpoint endpoint = Endpoint::parse("camera address", "192.168.0.10", 3956);
  EXPECT_EQ(endpoint.address, 0xc0a8000aU);
  EXPECT_EQ(endpoint.text(), "192.168.0.10:3956");
  EXPECT_EQ(Endpoint::from_kernel(endpoint.to_kernel()), endpoint);
}

TEST(Endpoint, RefusesWhatIsNoAddressByItsName) {
  for (const std::string text : {"", "localhost", "127.0.0", "127.0.0.256", "::1", "1.2.3.4 "}) {
    try {
      Endpoint::parse("camera address", text, 1);
      ADD_FAILURE() << text;
    } catch (const scan_cell_common::InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()),
                "camera address: '" + text + "'; give an IPv4 address such as 127.0.0.1");
    }
  }
}

TEST(UdpSocket, CarriesDatagramsWithTheirSenderAndTheTimeOfReceipt) {
  const UdpSocket sender(kAnyPort, "sender", ""), receiver(kAnyPort, "receiver", "");
  EXPECT_FALSE(receiver.wait(0));
  char byte = 0;
  EXPECT_FALSE(receiver.receive(&byte, 1));
  const auto before = host_now();
  ASSERT_TRUE(sender.send("?", 1, receiver.local()));
  ASSERT_TRUE(receiver.wait(kPatience));
  const auto datagram = receiver.receive(&byte, 1);
  ASSERT_TRUE(datagram && datagram->receipt);
  EXPECT_EQ(byte, '?');
  EXPECT_EQ(datagram->from, sender.local());
  EXPECT_LE(before, *datagram->receipt);
  EXPECT_LE(*datagram->receipt, host_now());
}

TEST(UdpSocket, RefusesAPortThatIsTakenUnlessBothShareIt) {
  const UdpSocket first(kAnyPort, "first", "");
  try {
    const UdpSocket second(first.local(), "second", "give another port");
    FAIL() << "two sockets on one port";
  } catch (const scan_cell_common::CannotBind& error) {
    EXPECT_EQ(std::string(error.what()),
              "second on " + first.local().text() + ": Address already in use; give another port");
  }
  const UdpSocket shared(kAnyPort, "shared", "", true);
  EXPECT_NO_THROW(UdpSocket(shared.local(), "another", "", true));
}
