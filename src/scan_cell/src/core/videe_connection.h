// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace scan_cell {

/// One client's TCP connection, a line at a time. Does not own the socket.
class VideeConnection {
 public:
  /// @param idle_time [s] in which a whole line must come
  VideeConnection(int socket, double idle_time);

  /// The next line without its end. Tells the client why it will be hung up on where its line is
  /// too long or does not come in time.
  /// @return none to hang up
  std::optional<std::string> next_line();

  /// @return false if the client does not take it
  bool send_line(std::string text) const;

  /// Also where commands that were not read yet hide the end of the connection.
  bool is_there() const;

 private:
  bool read_more(int patience_ms);

  int socket_;
  double idle_time_;
  std::string pending_;
};

}  // namespace scan_cell
