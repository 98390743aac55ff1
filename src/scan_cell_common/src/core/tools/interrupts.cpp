// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/tools/interrupts.h"

namespace scan_cell_common {
namespace {

volatile sig_atomic_t caught = 0;

}  // namespace

std::vector<int> ending_signals() {
  std::vector<int> signals = {SIGINT, SIGTERM};
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) signals.push_back(SIGHUP);
  return signals;
}

CatchInterrupts::CatchInterrupts() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = [](int) { caught = 1; };
  action.sa_flags = SA_RESTART;
  for (const int number : ending_signals()) {
    before_.emplace_back(number, action);
    sigaction(number, &action, &before_.back().second);
  }
}

CatchInterrupts::~CatchInterrupts() {
  for (const auto& [number, action] : before_)
    sigaction(number, &action, nullptr);
}

bool CatchInterrupts::interrupted() {
  return caught != 0;
}

}  // namespace scan_cell_common
