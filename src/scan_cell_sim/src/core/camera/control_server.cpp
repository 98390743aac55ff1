// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/control_server.h"

#include <arv.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "camera/big_endian.h"

namespace scan_cell_sim::gige {
namespace {

using scan_cell_common::Nanoseconds;
using Bytes = std::vector<std::uint8_t>;

constexpr double kMicrosecond = 1e-6;  // [s]

// Bootstrap registers (GigE Vision 1.2, section 28)
constexpr std::uint32_t kVendor = 0x0048, kModel = 0x0068, kDiscoveryEnd = 0x00f8;
constexpr std::uint32_t kCapabilities = 0x0934, kHeartbeat = 0x0938, kPrivilege = 0x0a00;
constexpr std::uint32_t kStreamPort = 0x0d00, kPacketSize = 0x0d04, kStreamAddress = 0x0d18;
constexpr std::uint32_t kCanResend = 4, kCanWriteMemory = 2;  // bits of kCapabilities
constexpr std::uint32_t kFireTestPacket = 1U << 31U;          // bit of kPacketSize
// Status codes (GVCP)

constexpr std::uint32_t kSuccess = 0, kNotImplemented = 0x8001, kInvalidParameter = 0x8002,
                        kInvalidAddress = 0x8003, kAccessDenied = 0x8006;

// GVCP
enum CommandCode : std::uint32_t {
  kDiscovery = 0x0002,
  kResend = 0x0040,
  kReadRegister = 0x0080,
  kWriteRegister = 0x0082,
  kReadMemory = 0x0084,
  kWriteMemory = 0x0086
};

}  // namespace

/// A command packet: key 0x42, flags, code, length, request id, then data.
struct ControlServer::Command {
  explicit Command(const Bytes& packet) : bytes(packet) {}

  static constexpr std::size_t kHeader = 8;  // [bytes] GVCP
  bool valid() const {
    return bytes.size() >= kHeader && bytes[0] == 0x42 && size() == get16(&bytes[4]);
  }
  std::uint32_t code() const { return get16(&bytes[2]); }
  std::uint32_t id() const { return get16(&bytes[6]); }
  std::size_t size() const { return bytes.size() - kHeader; }
  std::uint32_t word(std::size_t index) const { return get32(&bytes[kHeader + 4 * index]); }
  std::size_t words() const { return size() / 4; }

  const Bytes& bytes;
};

scan_cell_common::UdpSocket camera_socket(const std::string& address, std::uint16_t port,
                                          bool shared) {
  return {Endpoint::parse("camera address", address, port), "camera",
          "stop the other camera or simulator on this address, or give another address", shared};
}

ControlServer::ControlServer(const std::string& address, const std::string& serial,
                             const std::string& genicam_file)
    : unicast_(camera_socket(address, kPort)),
      broadcast_(camera_socket("255.255.255.255", kPort, true)),
      registers_(arv_fake_camera_new_full(serial.c_str(), genicam_file.c_str()),
                 [](ArvFakeCamera* camera) { g_object_unref(camera); }) {
  const in_addr own = unicast_.local().to_kernel().sin_addr;
  GInetAddress* const inet_address = g_inet_address_new_from_bytes(
      reinterpret_cast<const guint8*>(&own.s_addr), G_SOCKET_FAMILY_IPV4);
  arv_fake_camera_set_inet_address(registers_.get(), inet_address);
  g_object_unref(inet_address);

  constexpr std::array<std::pair<std::uint32_t, const char*>, 2> kNames = {
      {{kVendor, "ScanCell"}, {kModel, "SimulatedCamera"}}};
  for (const auto& [place, name] : kNames) {
    std::array<char, 32> field{};
    std::strncpy(field.data(), name, field.size() - 1);
    arv_fake_camera_write_memory(registers_.get(), place, field.size(), field.data());
  }
  set_register(kCapabilities, kCanResend | kCanWriteMemory);
}

ControlServer::~ControlServer() = default;

void ControlServer::serve(Nanoseconds now,
                          const std::function<void(const ResendRequest&)>& on_resend) {
  now_ = now;
  std::array<std::uint8_t, 1500> bytes;  // of Ethernet
  for (const auto* const socket : {&unicast_, &broadcast_}) {
    while (const auto datagram = socket->receive(bytes.data(), bytes.size())) {
      const Bytes packet(bytes.data(), bytes.data() + datagram->size);
      const Command command(packet);
      if (!command.valid()) continue;
      if (controls(datagram->from)) heard_ = now;
      answer(command, datagram->from, on_resend);
    }
  }
  constexpr Nanoseconds kMillisecond = 1'000'000;  // [ns]
  if (controller_ && now - heard_ > get(kHeartbeat) * kMillisecond) release();
}

void ControlServer::answer(const Command& command, const Endpoint& peer,
                           const std::function<void(const ResendRequest&)>& on_resend) {
  switch (command.code()) {
    case kDiscovery: {
      Bytes data(kDiscoveryEnd);
      arv_fake_camera_read_memory(registers_.get(), 0, kDiscoveryEnd, data.data());
      return acknowledge(command, kSuccess, data, peer);
    }
    case kResend:
      if (command.words() < 3) return;  // never answered
      return on_resend({static_cast<std::uint16_t>(command.word(0)), command.word(1) & 0xffffffU,
                        command.word(2) & 0xffffffU});
    case kReadRegister:
      return read_registers(command, peer);
    case kWriteRegister:
      return write_registers(command, peer);
    case kReadMemory:
      return read_memory(command, peer);
    case kWriteMemory:
      return write_memory(command, peer);
    default:
      return acknowledge(command, kNotImplemented, {}, peer);
  }
}

void ControlServer::read_registers(const Command& command, const Endpoint& peer) {
  Bytes data;
  for (std::size_t i = 0; i < command.words(); ++i) {
    if (command.word(i) > ARV_FAKE_CAMERA_MEMORY_SIZE - 8) {
      return acknowledge(command, kInvalidAddress, {}, peer);
    }
    put32(data, get(command.word(i)));
  }
  acknowledge(command, kSuccess, data, peer);
}

void ControlServer::write_registers(const Command& command, const Endpoint& peer) {
  if (controller_ && !controls(peer)) return acknowledge(command, kAccessDenied, {}, peer);
  std::uint32_t written = 0;
  for (std::size_t i = 0; i + 1 < command.words(); i += 2) {
    if (command.word(i) > ARV_FAKE_CAMERA_MEMORY_SIZE - 8) {
      return acknowledge(command, kInvalidAddress, {}, peer);
    }
    set_register(command.word(i), command.word(i + 1));
    ++written;
  }
  after_write(peer);
  Bytes data;
  put32(data, written);
  acknowledge(command, kSuccess, data, peer);
}

void ControlServer::read_memory(const Command& command, const Endpoint& peer) {
  constexpr std::uint32_t kMost = 536;  // [bytes] a packet that every network passes
  if (command.words() != 2) return acknowledge(command, kInvalidParameter, {}, peer);
  const std::uint32_t address = command.word(0);
  const std::uint32_t size = command.word(1) & 0xffffU;
  if (size == 0 || size > kMost) return acknowledge(command, kInvalidParameter, {}, peer);
  if (address >= memory_size()) return acknowledge(command, kInvalidAddress, {}, peer);
  Bytes data;
  put32(data, address);
  data.resize(4 + size);
  arv_fake_camera_read_memory(registers_.get(), address, size, &data[4]);
  acknowledge(command, kSuccess, data, peer);
}

void ControlServer::write_memory(const Command& command, const Endpoint& peer) {
  if (controller_ && !controls(peer)) return acknowledge(command, kAccessDenied, {}, peer);
  if (command.words() < 2) return acknowledge(command, kInvalidParameter, {}, peer);
  const std::uint32_t address = command.word(0);
  const auto size = static_cast<std::uint32_t>(command.size() - 4);
  if (address > ARV_FAKE_CAMERA_MEMORY_SIZE - 8 - size) {
    return acknowledge(command, kInvalidAddress, {}, peer);
  }
  arv_fake_camera_write_memory(registers_.get(), address, size,
                               &command.bytes[Command::kHeader + 4]);
  after_write(peer);
  Bytes data;
  put32(data, size);
  acknowledge(command, kSuccess, data, peer);
}

void ControlServer::acknowledge(const Command& command, std::uint32_t status, const Bytes& data,
                                const Endpoint& peer) {
  constexpr std::uint8_t kWanted = 1;  // GVCP flag
  if ((command.bytes[1] & kWanted) == 0) return;
  Bytes packet;
  put16(packet, status);
  put16(packet, command.code() + 1);
  put16(packet, static_cast<std::uint32_t>(data.size()));
  put16(packet, command.id());
  packet.insert(packet.end(), data.begin(), data.end());
  send(packet, peer);
}

void ControlServer::after_write(const Endpoint& peer) {
  const bool claimed = get(kPrivilege) != 0;
  if (claimed && !controller_) {
    controller_ = peer;
    heard_ = now_;
  }
  if (!claimed && controller_) release();
  if ((get(kPacketSize) & kFireTestPacket) != 0) fire_test_packet();
}

/// Sends a datagram of the size of stream packets, to show the client whether the network passes
/// it.
void ControlServer::fire_test_packet() {
  set_register(kPacketSize, get(kPacketSize) & ~kFireTestPacket);
  constexpr std::uint32_t kHeaders = 20 + 8, kLongest = 9000;  // [bytes] IP and UDP; jumbo
  const std::uint32_t size = packet_size();
  if (size > kHeaders && size <= kLongest) send(Bytes(size - kHeaders), stream_peer());
}

void ControlServer::release() {
  controller_.reset();
  set_register(kPrivilege, 0);
  set_register(ARV_FAKE_CAMERA_REGISTER_ACQUISITION, 0);
}

bool ControlServer::controls(const Endpoint& peer) const {
  return controller_ && *controller_ == peer;
}

std::uint32_t ControlServer::get(std::uint32_t address) const {
  guint32 value = 0;
  arv_fake_camera_read_register(registers_.get(), address, &value);
  return value;
}

void ControlServer::set_register(std::uint32_t address, std::uint32_t value) {
  arv_fake_camera_write_register(registers_.get(), address, value);
}

std::size_t ControlServer::memory_size() const {
  std::size_t genicam = 0;
  arv_fake_camera_get_genicam_xml(registers_.get(), &genicam);
  return ARV_FAKE_CAMERA_MEMORY_SIZE + genicam;
}

bool ControlServer::acquires() const {
  return controller_ && get(ARV_FAKE_CAMERA_REGISTER_ACQUISITION) != 0;
}

bool ControlServer::triggered_by_line() const {
  return get(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOURCE) == 0;
}

bool ControlServer::in_trigger_mode() const {
  return get(ARV_FAKE_CAMERA_REGISTER_TRIGGER_MODE) != 0;
}

Region ControlServer::region() const {
  const auto number = [this](std::uint32_t address) { return static_cast<int>(get(address)); };
  return {number(ARV_FAKE_CAMERA_REGISTER_X_OFFSET), number(ARV_FAKE_CAMERA_REGISTER_Y_OFFSET),
          number(ARV_FAKE_CAMERA_REGISTER_WIDTH), number(ARV_FAKE_CAMERA_REGISTER_HEIGHT)};
}

double ControlServer::exposure() const {
  return get(ARV_FAKE_CAMERA_REGISTER_EXPOSURE_TIME_US) * kMicrosecond;
}

double ControlServer::gain() const {
  constexpr double kTenthsOfDecibel = 10, kAmplitude = 20;  // in a decibel; decibels in a decade
  return std::pow(10, get(ARV_FAKE_CAMERA_REGISTER_GAIN_RAW) / kTenthsOfDecibel / kAmplitude);
}

double ControlServer::period() const {
  constexpr std::uint32_t kShortest = 1000;  // [us] chosen
  return std::max(get(ARV_FAKE_CAMERA_REGISTER_ACQUISITION_FRAME_PERIOD_US), kShortest) *
         kMicrosecond;
}

bool ControlServer::take_software_trigger() {
  if (get(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOFTWARE) == 0) return false;
  set_register(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOFTWARE, 0);
  return true;
}

std::uint32_t ControlServer::packet_size() const {
  return get(kPacketSize) & 0xffffU;
}

Endpoint ControlServer::stream_peer() const {
  return {get(kStreamAddress), static_cast<std::uint16_t>(get(kStreamPort))};
}

}  // namespace scan_cell_sim::gige
