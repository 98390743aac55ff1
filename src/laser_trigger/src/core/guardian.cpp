// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_trigger/guardian.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

extern "C" {  // which glibc 2.36 leaves out
#include <sys/pidfd.h>
}

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>

namespace laser_trigger {

using scan_cell_common::Descriptor;

namespace {

struct Message {
  enum class Kind : std::uint8_t { kWatch, kArmed, kIdle };
  Kind kind = Kind::kIdle;
  PortAddress address;
  double hang_timeout = 0;
};

/// The guardian's answer to Watch: the text of an error, or empty.
struct Answer {
  char error[256] = "";
};

/// The guardian process.
class Watch {
 public:
  Watch(int socket, int parent) : socket_(socket), parent_(parent) {}

  void run() {
    while (true) {
      pollfd poll_for = {socket_, POLLIN, 0};
      const int ready = poll(&poll_for, 1, armed_ ? timeout_ : -1);
      if (ready < 0 && errno == EINTR) continue;
      if (ready == 0) {
        pidfd_send_signal(parent_, SIGKILL, nullptr, 0);
        armed_ = false;  // next, the socket ends
        continue;
      }
      Message message;
      if (recv(socket_, &message, sizeof(message), 0) != sizeof(message)) break;
      take(message);
    }
    if (address_) set_low();
  }

 private:
  void take(const Message& message) {
    armed_ = message.kind == Message::Kind::kArmed;
    if (message.kind != Message::Kind::kWatch) return;
    Answer answer;
    try {
      open_port(message.address);
      address_ = message.address;
      constexpr double kMilliseconds = 1e3;  // in a second
      timeout_ = static_cast<int>(std::ceil(message.hang_timeout * kMilliseconds));
    } catch (const std::exception& error) {
      std::strncpy(answer.error, error.what(), sizeof(answer.error) - 1);
    }
    send(socket_, &answer, sizeof(answer), MSG_NOSIGNAL);
  }

  /// Tries for a minute: the kernel may still be cleaning up after the dead process.
  void set_low() const {
    constexpr int kAttempts = 600;                    // a minute; chosen
    constexpr std::chrono::milliseconds kPause(100);  // [ms] chosen
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      try {
        open_port(*address_)->write(0);
        return;
      } catch (const std::exception&) {
        std::this_thread::sleep_for(kPause);
      }
    }
  }

  int socket_;
  int parent_;
  bool armed_ = false;
  int timeout_ = -1;  // [ms]
  std::optional<PortAddress> address_;
};

/// Moves a file to a descriptor above the standard streams, which detach() replaces: a node may be
/// started without streams.
int above_streams(int file) {
  if (file < 0) return file;
  const int moved = fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  close(file);
  return moved;
}

/// Leaves the terminal and the process group, and closes everything inherited.
void detach(int keep_a, int keep_b) {
  setsid();
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP})
    signal(number, SIG_IGN);
  prctl(PR_SET_NAME, "laser_guardian");
  const int nothing = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream)
    dup2(nothing, stream);
  const int low = std::min(keep_a, keep_b);
  const int high = std::max(keep_a, keep_b);
  if (low > 3) close_range(3, low - 1, 0);
  if (high > low + 1) close_range(low + 1, high - 1, 0);
  close_range(high + 1, ~0U, 0);
}

}  // namespace

Guardian::Guardian() {
  int ends[2];
  const int parent = above_streams(pidfd_open(getpid(), 0));
  if (parent < 0 || socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    throw scan_cell_common::ConnectionError("guardian", std::strerror(errno),
                                            "close programs that have many files open");
  }
  process_ = fork();
  if (process_ < 0) {
    throw scan_cell_common::ConnectionError("guardian", std::strerror(errno),
                                            "end other processes");
  }
  if (process_ == 0) {
    const int end = above_streams(ends[1]);
    detach(end, parent);
    Watch(end, parent).run();
    _exit(0);
  }
  close(ends[1]);
  close(parent);
  socket_ = Descriptor(ends[0]);
}

void Guardian::send(const void* message, std::size_t size) const {
  // Does not block: a guardian that does not read cannot guard.
  const ssize_t sent = ::send(socket_.number(), message, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent == static_cast<ssize_t>(size)) return;
  throw scan_cell_common::ConnectionError(
      fmt::format("guardian process {}", process_), fmt::format("gone ({})", std::strerror(errno)),
      "start this program again; without its guardian it does not switch lasers on");
}

void Guardian::watch(const PortAddress& address, double hang_timeout) {
  Message message;
  message.kind = Message::Kind::kWatch;
  message.address = address;
  message.hang_timeout = hang_timeout;
  send(&message, sizeof(message));
  Answer answer;
  constexpr int kPatience = 5000;  // [ms] chosen
  pollfd poll_for = {socket_.number(), POLLIN, 0};
  if (poll(&poll_for, 1, kPatience) != 1 ||
      recv(socket_.number(), &answer, sizeof(answer), 0) != sizeof(answer)) {
    throw scan_cell_common::ConnectionError(fmt::format("guardian process {}", process_),
                                            "does not answer", "start this program again");
  }
  if (answer.error[0] != 0) {
    throw scan_cell_common::ConnectionError("guardian process", answer.error,
                                            "see the reason given here");
  }
}

void Guardian::alive(bool armed) {
  Message message;
  message.kind = armed ? Message::Kind::kArmed : Message::Kind::kIdle;
  send(&message, sizeof(message));
}

}  // namespace laser_trigger
