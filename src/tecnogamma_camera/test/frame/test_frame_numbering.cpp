// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "acquisition/frame_numbering.h"
#include "scan_cell_common/errors/errors.h"

using namespace tecnogamma_camera;

namespace {

constexpr Nanoseconds kMillisecond = 1'000'000;

/// Frames of a camera whose clock is the host's.
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

using Numbers = std::vector<std::uint64_t>;

/// A camera that counts 16 bits, with a clock or without.
class CountingCamera : public testing::TestWithParam<bool> {
 protected:
  /// The numbers given to frames with these counters, one every 10 ms.
  Numbers receive(const Numbers& counters) {
    Numbers counts;
    for (const std::uint64_t counter : counters) {
      Frame frame;
      frame.counter = counter;
      exposed_ += 10 * kMillisecond;
      frame.device_time = GetParam() ? exposed_ : 0;
      frame.host_time = exposed_;
      const FramePlace place = numbering_.place(frame);
      lost_ += place.step.lost;
      lost_ -= place.found;
      garbled_ += place.was_garbled ? 1 : 0;
      restarts_ += place.restarted ? 1 : 0;
      counts.push_back(place.step.count);
    }
    return counts;
  }

  FrameNumbering numbering_{kCounter16, {}};
  Nanoseconds exposed_ = 1'700'000'000'000 * kMillisecond;
  std::uint64_t lost_ = 0;
  int garbled_ = 0;
  int restarts_ = 0;
};

INSTANTIATE_TEST_SUITE_P(, CountingCamera, testing::Bool(), [](const auto& test) {
  return std::string(test.param ? "WithClock" : "WithoutClock");
});

}  // namespace

TEST_P(CountingCamera, IsNotTakenForRestartedWhereOneNumberIsTooHigh) {
  EXPECT_EQ(receive({10, 11, 12, 30000, 14, 15, 16, 17}),
            (Numbers{10, 11, 12, 30000, 14, 15, 16, 17}));
  EXPECT_EQ(restarts_, 0);
  EXPECT_EQ(garbled_, 1);
  EXPECT_EQ(lost_, 1U) << "13, which came without its number";
}

TEST_P(CountingCamera, IsNotTakenForRestartedWhereOneNumberIsTooLow) {
  EXPECT_EQ(receive({1000, 1001, 7, 1003, 1004}), (Numbers{1000, 1001, 7, 1003, 1004}));
  EXPECT_EQ(restarts_, 0);
  EXPECT_EQ(lost_, 1U);
}

TEST_P(CountingCamera, KeepsItsCountWhereANumberIsTooHighAtTheTurnOrNextToALoss) {
  EXPECT_EQ(receive({65534, 65535, 20000, 1, 2, 3, 4}),
            (Numbers{65534, 65535, 85536, 65537, 65538, 65539, 65540}));
  EXPECT_EQ(lost_, 1U);
  EXPECT_EQ(receive({9, 500, 12, 13, 14, 15}), (Numbers{65545, 66036, 65548, 65549, 65550, 65551}));
  EXPECT_EQ(lost_, 1U + 4 + 2);
  EXPECT_EQ(garbled_, 2);
  EXPECT_EQ(restarts_, 0);
}

TEST_P(CountingCamera, CountsAGapThatTheNextFrameConfirms) {
  EXPECT_EQ(receive({10, 500, 501, 502}), (Numbers{10, 500, 501, 502}));
  EXPECT_EQ(lost_, 489U);
  EXPECT_EQ(garbled_, 0);
}

TEST_P(CountingCamera, IsRestartedWhereItCountsOnFromBefore) {
  EXPECT_EQ(receive({500, 501, 1, 2, 3, 4}), (Numbers{500, 501, 1, 2, 3, 4}));
  EXPECT_EQ(restarts_, 1);
  EXPECT_EQ(garbled_, 0);
  EXPECT_EQ(receive({200, 1, 2, 3, 4}), (Numbers{200, 1, 2, 3, 4})) << "also right after a gap";
  EXPECT_EQ(restarts_, 2);
}

TEST_P(CountingCamera, KeepsItsCountThroughManySingleGarbledNumbers) {
  std::mt19937 engine(4);
  std::uint64_t count = 0;
  std::uint64_t garbled = 0;
  const auto receive_good = [&](int frames) {
    for (int i = 0; i < frames; ++i, ++count)
      ASSERT_EQ(receive({count & 0xFFFF}), Numbers{count}) << garbled;
  };
  receive_good(5);
  for (; garbled < 5000; ++garbled) {
    constexpr int kNext = 1;  // it would be taken for the true number, and the true one repeated
    receive({(count + kNext + 1 + engine() % 65534) & 0xFFFF});
    ++count;
    receive_good(3 + static_cast<int>(engine() % 5));
  }
  EXPECT_EQ(restarts_, 0);
  EXPECT_EQ(lost_, garbled);
}

TEST_F(SynchronisedCamera, IsRefusedWhereItsClockIsNotTheHosts) {
  EXPECT_THROW(receive(10100 * kMillisecond), scan_cell_common::UnusableInput);
  EXPECT_THROW(receive(-1100 * kMillisecond), scan_cell_common::UnusableInput);
}

TEST_F(SynchronisedCamera, IsBelievedWhereABusyHostReceivesItsFirstFramesLateButNotForLong) {
  for (int frame = 0; frame < 20; ++frame)
    EXPECT_EQ(receive(1100 * kMillisecond).time, exposed_);
  FrameNumbering caught_up = numbering_;
  EXPECT_THROW(receive(1100 * kMillisecond), scan_cell_common::UnusableInput);
  numbering_ = caught_up;
  EXPECT_EQ(receive(2 * kMillisecond).time, exposed_);
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
