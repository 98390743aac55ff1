// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/path_loader.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"
#include "wire/path_pieces.h"

namespace c4g_driver {
namespace {

/// Sends one datagram after the other and checks each confirmation.
class Loader {
 public:
  explicit Loader(Link& link) : link_(link) {}

  void send(const Request& request, std::size_t waypoints) {
    std::string datagram;
    const Acknowledgement answer = link_.request(request, nullptr, &datagram);
    checksum_.add(datagram);
    const std::string expected = checksum_.confirmation(waypoints);
    if (answer.value == expected) return;
    throw scan_cell_common::ProtocolError(
        name_of(request), fmt::format("confirmed as {} instead of {}", answer.value, expected),
        "see c4g_protocol.md: the controller has another path");
  }

  std::uint32_t checksum() const { return checksum_.value(); }

 private:
  Link& link_;
  PathChecksum checksum_;
};

}  // namespace

FollowPath load_path(Link& link, const ToolMotion& motion, std::uint64_t path, std::uint64_t from,
                     const std::function<bool()>& go_on) {
  const std::vector<PathPiece> pieces = pieces_of(motion, path);
  Loader loader(link);
  loader.send(LoadPath{path, motion.waypoints.size(), motion.flange_to_tip}, 0);
  for (const PathPiece& piece : pieces) {
    if (go_on && !go_on()) {
      throw scan_cell_common::Refused("path", "cancelled while it was being loaded",
                                      "send it again");
    }
    loader.send(piece, piece.first + piece.waypoints.size());
  }
  return {path, from, loader.checksum()};
}

}  // namespace c4g_driver
