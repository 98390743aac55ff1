// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "loopback_circuit.h"

namespace laser_trigger {

using scan_cell_common::ConnectionError;

LoopbackCircuit::LoopbackCircuit(const std::string& host, std::uint16_t port)
    : host_(host),
      socket_(scan_cell_common::Endpoint::parse("address of the trigger circuit", host, port),
              "trigger circuit",
              "stop the simulator or the program that holds the port, or give another address") {}

std::optional<LoopbackCircuit::Write> LoopbackCircuit::take(double timeout) {
  if (!socket_.wait(timeout)) return {};
  std::uint8_t data[2];
  const auto datagram = socket_.receive(data, sizeof data);
  if (!datagram) return {};
  if (datagram->size != 1) {
    ++refused_;
    return {};
  }
  if (!datagram->receipt) throw ConnectionError("kernel", "no receive time stamps", "use Linux");
  return Write{data[0], *datagram->receipt};
}

}  // namespace laser_trigger
