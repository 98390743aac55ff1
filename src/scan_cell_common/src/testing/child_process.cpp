// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/testing/child_process.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

ChildProcess::ChildProcess(const std::vector<std::string>& command, bool quiet) {
  std::vector<char*> arguments;
  for (const std::string& word : command)
    arguments.push_back(const_cast<char*>(word.c_str()));  // as execvp() requires
  arguments.push_back(nullptr);
  id_ = fork();
  if (id_ < 0) {
    throw Refused(command.front(), "cannot be started", "end other programs");
  }
  if (id_ > 0) return;
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (quiet) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  execvp(arguments.front(), arguments.data());
  constexpr int kNotFound = 127;
  _exit(kNotFound);
}

ChildProcess::~ChildProcess() {
  if (id_ < 0) return;
  kill(id_, SIGTERM);
  wait();
}

int ChildProcess::wait() {
  constexpr int kSignalled = 128;
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
}

Usage usage_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(text.rfind(')') + 1));  // the name may contain anything
  constexpr int kBeforeTimes = 11;                              // fields from the state on
  constexpr int kBetween = 8;                                   // fields from the times to the size
  std::string skipped;
  double user = 0, system = 0, pages = 0;
  for (int i = 0; i < kBeforeTimes; ++i)
    fields >> skipped;
  fields >> user >> system;
  for (int i = 0; i < kBetween; ++i)
    fields >> skipped;
  fields >> pages;
  constexpr double kMegabyte = 1e6;
  return {(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK)),
          pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMegabyte};
}

double cpu_of_this_thread() {
  constexpr double kNanosecond = 1e-9;
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + kNanosecond * static_cast<double>(time.tv_nsec);
}

int free_port() {
  const int line = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  const bool found = bind(line, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(line, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(line);
  if (!found) throw Refused("a port of 127.0.0.1", "none free", "see ss -lt");
  return ntohs(address.sin_port);
}

}  // namespace scan_cell_common
