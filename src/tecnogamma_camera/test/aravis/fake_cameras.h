// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

/// GigE Vision cameras on 127.0.0.1. Only one of them can run at a time.
namespace fake_cameras {

constexpr const char* kAddress = "127.0.0.1";

/// Waits for a condition; false after the timeout, which is for busy machines.
template <class Condition>
bool wait_until(const Condition& condition, double timeout = 60) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// Aravis' fake camera as a program of its own: the destructor pulls its plug.
class Program {
 public:
  explicit Program(std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"arv-fake-gv-camera-0.8", "-i", kAddress});
    std::vector<char*> arguments;
    for (std::string& option : options)
      arguments.push_back(option.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
      execvp(arguments[0], arguments.data());
      _exit(127);
    }
  }
  ~Program() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

 private:
  pid_t process_;
};

}  // namespace fake_cameras
