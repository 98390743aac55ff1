// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors.h"
#include "tecnogamma_camera/frame_numbering.h"

using namespace tecnogamma_camera;

namespace {

constexpr Nanoseconds kMillisecond = 1'000'000;

/// Of a camera whose clock is the host's.
class SynchronisedCamera : public testing::Test {
 protected:
  /// The next frame, received `late` [ns] after its exposure.
  FramePlace receive(Nanoseconds late) {
    Frame frame;
    frame.counter = ++counter_;
    frame.device_time = exposed_ += 10 * kMillisecond;
    frame.host_time = exposed_ + late;
    return numbering_.place(frame);
  }

  FrameNumbering numbering_{kGigEVisionBlockId, {10, true}};
  std::uint64_t counter_ = 0;
  Nanoseconds exposed_ = 1'700'000'000'000 * kMillisecond;
};

}  // namespace

TEST_F(SynchronisedCamera, IsRefusedWhereItsClockIsNotTheHosts) {
  EXPECT_THROW(receive(1100 * kMillisecond), scan_cell_common::UnusableInput);
  EXPECT_THROW(receive(-1100 * kMillisecond), scan_cell_common::UnusableInput);
}

TEST_F(SynchronisedCamera, IsStillBelievedWhereABusyHostReceivesItsFramesLate) {
  EXPECT_EQ(receive(2 * kMillisecond).time, exposed_);
  for (int late = 1500; late > 1000; late -= 10)
    EXPECT_EQ(receive(late * kMillisecond).time, exposed_);
  EXPECT_EQ(receive(2 * kMillisecond).time, exposed_);
}

TEST_F(SynchronisedCamera, IsRefusedWhereItsClockStaysBehind) {
  receive(2 * kMillisecond);
  const auto receive_many = [this] {
    for (int i = 0; i < 2000; ++i)
      receive(1500 * kMillisecond);
  };
  EXPECT_THROW(receive_many(), scan_cell_common::UnusableInput);
}
