// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "scan_cell_common/tools/interrupts.h"

using scan_cell_common::CatchInterrupts;
using scan_cell_common::ending_signals;

namespace {

struct sigaction action_of(int number) {
  struct sigaction action {};
  sigaction(number, nullptr, &action);
  return action;
}

}  // namespace

TEST(CatchInterrupts, RemembersEachSignalThatWouldEndTheProcess) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    signal(number, SIG_DFL);
    const CatchInterrupts catch_interrupts;
    EXPECT_FALSE(CatchInterrupts::interrupted());
    raise(number);
    EXPECT_TRUE(CatchInterrupts::interrupted());
  }
}

TEST(CatchInterrupts, LeavesTheHandlersAsTheyWere) {
  signal(SIGTERM, SIG_IGN);
  { const CatchInterrupts catch_interrupts; }
  EXPECT_EQ(action_of(SIGTERM).sa_handler, SIG_IGN);
  signal(SIGTERM, SIG_DFL);
  { const CatchInterrupts catch_interrupts; }
  EXPECT_EQ(action_of(SIGTERM).sa_handler, SIG_DFL);
}

TEST(CatchInterrupts, LetsAProgramUnderNohupGoOn) {
  signal(SIGHUP, SIG_IGN);
  const CatchInterrupts catch_interrupts;
  raise(SIGHUP);
  EXPECT_FALSE(CatchInterrupts::interrupted());
  const std::vector<int> ending = ending_signals();
  EXPECT_EQ(std::count(ending.begin(), ending.end(), SIGHUP), 0);
  signal(SIGHUP, SIG_DFL);
}
