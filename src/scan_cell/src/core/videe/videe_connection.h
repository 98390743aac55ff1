// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace scan_cell {

/// One client's TCP connection, a line at a time. A thread of its own reads whatever comes, so that
/// the end of the connection is seen at once, however much was sent before it. Does not own the
/// socket, which must be open for as long as this object lives.
class VideeConnection {
 public:
  /// @param idle_time [s] in which a whole line must come
  VideeConnection(int socket, double idle_time);

  /// Hangs up.
  ~VideeConnection();

  VideeConnection(const VideeConnection&) = delete;
  VideeConnection& operator=(const VideeConnection&) = delete;

  /// The next line without its end. Tells the client why it will be hung up on where a line is too
  /// long or does not come in time, or too much was sent ahead.
  /// @return none to hang up
  std::optional<std::string> next_line();

  /// @param text sent as one line of UTF-8, see one_line()
  /// @return false if the client does not take it
  bool send_line(const std::string& text) const;

  /// False from when the client closed the connection in its direction, its line went dead, or it
  /// sent what ends the connection, also while lines that came before are not read yet.
  bool is_there() const;

 private:
  void read();
  void take(std::string_view bytes);
  void leave(const std::string& farewell);

  const int socket_;
  const double idle_time_;
  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<std::string> lines_;  // that were not answered yet
  std::size_t ahead_ = 0;          // their bytes
  std::string rest_;               // the begin of the next one
  std::string farewell_;           // what the client is told before it is hung up on
  bool there_ = true;
  bool all_read_ = false;  // nothing will come any more
  bool ending_ = false;
  std::thread reader_;  // last: it uses all the rest
};

/// Tells a client that is not served why, without waiting for it.
void turn_away(int socket, const std::string& why);

}  // namespace scan_cell
