// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wire/wire_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <limits>

#include "scan_cell_sim/controller/refusal.h"

namespace scan_cell_sim {

using nlohmann::json;
using Code = ControllerErrorCode;

namespace {

/// The last entry of a datagram that begins with `text`, and its closing brace.
std::string crc_entry(const std::string& text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format(",\"crc\":{}}}", crc.checksum());
}

}  // namespace

std::string sealed(const json& packet) {
  std::string text = packet.dump();
  text.pop_back();
  return text + crc_entry(text);
}

std::optional<json> unsealed(const std::string& datagram) {
  const std::size_t comma = std::min(datagram.rfind(','), datagram.size());
  if (datagram.substr(comma) != crc_entry(datagram.substr(0, comma))) return {};
  json packet = json::parse(datagram, nullptr, false);
  if (!packet.is_object()) return {};
  return packet;
}

double number(const json& value, const std::string& name, double least, double most) {
  if (!value.is_number()) throw ControllerRefusal(Code::kMalformed, name + " is not a number");
  const auto result = value.get<double>();
  if (result >= least && result <= most) return result;
  throw ControllerRefusal(Code::kOutOfRange,
                          name + " is outside " + json(least).dump() + " .. " + json(most).dump());
}

const json& entry(const json& request, const std::string& name) {
  const auto found = request.find(name);
  if (found == request.end()) throw ControllerRefusal(Code::kMalformed, name + " is missing");
  return *found;
}

std::string text(const json& value, const std::string& name) {
  if (!value.is_string()) throw ControllerRefusal(Code::kMalformed, name + " is not a string");
  return value.get<std::string>();
}

WireSix six(const json& value, const std::string& name) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  if (!value.is_array() || value.size() != 6) {
    throw ControllerRefusal(Code::kMalformed, name + " is not six numbers");
  }
  WireSix result{};
  for (std::size_t i = 0; i < 6; ++i)
    result[i] = number(value[i], name, -kAny, kAny);
  return result;
}

WireSix pose(const json& value, const std::string& name) {
  constexpr double kFar = 1e5;  // [mm] chosen
  struct Range {
    const char* name;
    double least, most;
  };
  constexpr std::array<Range, 6> kRanges = {{{" x", -kFar, kFar},
                                             {" y", -kFar, kFar},
                                             {" z", -kFar, kFar},
                                             {" A", -180, 180},
                                             {" E", 0, 180},
                                             {" R", -180, 180}}};
  const WireSix result = six(value, name);
  for (std::size_t i = 0; i < 6; ++i)
    number(value[i], name + kRanges[i].name, kRanges[i].least, kRanges[i].most);
  return result;
}

bool truth(const json& value, const std::string& name) {
  if (!value.is_boolean())
    throw ControllerRefusal(Code::kMalformed, name + " is not true or false");
  return value.get<bool>();
}

std::uint64_t whole(const json& value, const std::string& name) {
  if (!value.is_number_unsigned()) {
    throw ControllerRefusal(Code::kMalformed, name + " is not a whole number");
  }
  return value.get<std::uint64_t>();
}

}  // namespace scan_cell_sim
