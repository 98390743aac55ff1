// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "scan_cell_common/net/udp_socket.h"
#include "scan_cell_sim/laser_line_renderer.h"

struct _ArvFakeCamera;

namespace scan_cell_sim::gige {

using scan_cell_common::Endpoint;

/// A socket of the camera.
/// @param port 0: any
/// @param shared others may bind the same address and port
/// @throw scan_cell_common::InvalidParameter if the address is not an IPv4 address
/// @throw scan_cell_common::ConnectionError if it cannot be bound
scan_cell_common::UdpSocket camera_socket(const std::string& address, std::uint16_t port,
                                          bool shared = false);

/// The camera's side of the GigE Vision control protocol (GVCP 1.2) over Aravis' register file and
/// GenICam description: discovery, registers, memory, control by one client with its heartbeat,
/// test packets and requests to send packets again. To be used from one thread.
class ControlServer {
 public:
  static constexpr std::uint16_t kPort = 3956;  //!< GVCP's

  /// Packets that a client missed, first and last included.
  struct ResendRequest {
    std::uint16_t block;
    std::uint32_t first;
    std::uint32_t last;
  };

  /// @param genicam_file readable
  /// @throw as camera_socket()
  ControlServer(const std::string& address, const std::string& serial,
                const std::string& genicam_file);
  ~ControlServer();

  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  /// Answers all waiting commands. A client that was silent for longer than its heartbeat timeout
  /// loses control, and acquisition stops.
  void serve(scan_cell_common::Nanoseconds now,
             const std::function<void(const ResendRequest&)>& on_resend);

  /// Descriptors to wait on for commands.
  std::array<int, 2> handles() const { return {unicast_.number(), broadcast_.number()}; }

  void set_register(std::uint32_t address, std::uint32_t value);

  bool acquires() const;
  bool in_trigger_mode() const;
  bool triggered_by_line() const;  //!< not by software
  Region region() const;
  double exposure() const;  //!< [s]
  double gain() const;      //!< factor
  double period() const;    //!< [s] of the free run

  /// Whether the client asked for a frame since the last time.
  bool take_software_trigger();

  std::uint32_t packet_size() const;  //!< [bytes] with IP and UDP headers
  Endpoint stream_peer() const;

 private:
  struct Command;

  void answer(const Command& command, const Endpoint& peer,
              const std::function<void(const ResendRequest&)>& on_resend);
  void read_registers(const Command& command, const Endpoint& peer);
  void write_registers(const Command& command, const Endpoint& peer);
  void read_memory(const Command& command, const Endpoint& peer);
  void write_memory(const Command& command, const Endpoint& peer);
  void acknowledge(const Command& command, std::uint32_t status,
                   const std::vector<std::uint8_t>& data, const Endpoint& peer);
  void send(const std::vector<std::uint8_t>& packet, const Endpoint& peer) const {
    unicast_.send(packet.data(), packet.size(), peer);  // what the network refuses is lost
  }
  void after_write(const Endpoint& peer);
  void fire_test_packet();
  void release();
  bool controls(const Endpoint& peer) const;
  std::uint32_t get(std::uint32_t address) const;
  std::size_t memory_size() const;

  scan_cell_common::UdpSocket unicast_;
  scan_cell_common::UdpSocket broadcast_;
  std::unique_ptr<_ArvFakeCamera, void (*)(_ArvFakeCamera*)> registers_;
  std::optional<Endpoint> controller_;
  scan_cell_common::Nanoseconds now_ = 0;
  scan_cell_common::Nanoseconds heard_ = 0;  // from the controller
};

}  // namespace scan_cell_sim::gige
