// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <random>

#include "scan_cell_common/errors/errors.h"
#include "trials/growth.h"

using scan_cell_demo::growth;
using scan_cell_demo::Holdings;

namespace {

/// A process of 50 MB that warms up in 20 of 90 samples and then scatters by 0.3 MB.
std::vector<Holdings> flat_process() {
  std::mt19937 random(4);
  std::normal_distribution<double> scatter(0, 0.3);
  std::vector<Holdings> samples;
  for (int i = 0; i < 90; ++i)
    samples.push_back({50 + 2.0 * std::min(i, 20) + scatter(random), 9, 20 + i % 3, 12});
  return samples;
}

}  // namespace

TEST(Growth, IsNotSeenWhereAProcessWarmsUpAndStays) {
  EXPECT_EQ(growth(flat_process()), "");
}

TEST(Growth, IsSeenOfMemoryThatLeaksAwaySlowly) {
  std::vector<Holdings> samples = flat_process();
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].memory += 0.05 * static_cast<double>(i);
  EXPECT_EQ(growth(samples).find(" memory"), 0U);
}

TEST(Growth, IsSeenOfASingleThreadFileOrSocketLeftOver) {
  for (auto what : {&Holdings::threads, &Holdings::files, &Holdings::sockets}) {
    std::vector<Holdings> samples = flat_process();
    samples.back().*what = 23;
    EXPECT_NE(growth(samples), "");
  }
}

TEST(Growth, IsNotJudgedByAFewSamples) {
  EXPECT_THROW(growth(std::vector<Holdings>(5)), scan_cell_common::Refused);
}

TEST(Holdings, CountsTheFilesAndSocketsOfAProcess) {
  const Holdings before = scan_cell_demo::holdings_of(getpid());
  const int plug = socket(AF_INET, SOCK_DGRAM, 0);
  const int file = dup(STDERR_FILENO);
  const Holdings after = scan_cell_demo::holdings_of(getpid());
  close(plug);
  close(file);
  EXPECT_EQ(after.sockets, before.sockets + 1);
  EXPECT_GE(after.files, before.files + 2);
  EXPECT_GE(after.threads, 1);
  EXPECT_GT(after.memory, 1);
}
