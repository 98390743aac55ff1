// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "tecnogamma_camera/recording.h"

using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;
using tecnogamma_camera::CameraDescription;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::Frame;
using tecnogamma_camera::MissingFeature;
using tecnogamma_camera::PlaybackOptions;
using tecnogamma_camera::RecordedCamera;
using tecnogamma_camera::Region;
using tecnogamma_camera::StreamEnded;
using tecnogamma_camera::Trigger;

namespace {

constexpr Nanoseconds kMillisecond = 1000000;

/// Images of 8 x 6 pixels at 100, 50; each pixel encodes its place.
class Recording : public tecnogamma_camera::Recording {
 public:
  explicit Recording(std::vector<Nanoseconds> device_times) : times_(std::move(device_times)) {
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 8; ++column)
        pixels_.push_back(static_cast<std::uint8_t>(16 * row + column));
  }
  CameraDescription describe() override {
    CameraDescription description;
    description.id = "recording";
    description.region = {100, 50, 8, 6};
    description.counter = tecnogamma_camera::kCounter64;
    return description;
  }
  std::optional<Frame> next() override {
    if (next_ == times_.size()) return std::nullopt;
    Frame frame;
    frame.counter = next_ + 1;
    frame.device_time = times_[next_];
    if (frame.device_time != 0) frame.time = 1'000'000'000 + frame.device_time;
    frame.image = tecnogamma_camera::ImageView8{pixels_.data(), 8, 6, 8, 100, 50};
    ++next_;
    return frame;
  }
  void rewind() override { next_ = 0; }

 private:
  std::vector<Nanoseconds> times_;
  std::vector<std::uint8_t> pixels_;
  std::size_t next_ = 0;
};

RecordedCamera camera(std::vector<Nanoseconds> device_times, double speed = 0, bool loop = false,
                      bool is_payload = false) {
  PlaybackOptions options;
  options.speed = speed;
  options.loop = loop;
  return {std::make_unique<Recording>(std::move(device_times)), options, is_payload};
}

std::optional<Frame> grab(RecordedCamera& recorded) {
  return recorded.grab(std::chrono::seconds(60));
}

std::vector<Nanoseconds> times(int frames, Nanoseconds step) {
  std::vector<Nanoseconds> result;
  for (int i = 1; i <= frames; ++i)
    result.push_back(i * step);
  return result;
}

}  // namespace

TEST(RecordedCamera, GivesEachFrameOnceWithItsNumberAndTimesThenSaysThatItEnded) {
  RecordedCamera recorded = camera(times(3, kMillisecond));
  recorded.start(Trigger::kFreeRun);
  for (std::uint64_t i = 1; i <= 3; ++i) {
    const auto frame = grab(recorded);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->counter, i);
    EXPECT_EQ(frame->device_time, static_cast<Nanoseconds>(i) * kMillisecond);
    EXPECT_EQ(frame->time, 1'000'000'000 + frame->device_time);
    EXPECT_GT(frame->host_time, 0);
    EXPECT_FALSE(frame->restarted);
  }
  EXPECT_THROW(grab(recorded), StreamEnded);
  EXPECT_EQ(recorded.statistics().completed, 3U);
}

TEST(RecordedCamera, BeginsAnewWithEachStart) {
  RecordedCamera recorded = camera(times(3, kMillisecond));
  EXPECT_THROW(grab(recorded), Refused);
  for (int i = 0; i < 2; ++i) {
    recorded.start(Trigger::kExternal);
    EXPECT_EQ(grab(recorded)->counter, 1U);
    EXPECT_EQ(grab(recorded)->counter, 2U);
    EXPECT_THROW(recorded.start(Trigger::kExternal), Refused);
    recorded.stop();
  }
}

TEST(RecordedCamera, LoopsAsACameraThatWasRestartedWithTimesThatGoOn) {
  RecordedCamera recorded = camera(times(3, kMillisecond), 0, true);
  recorded.start(Trigger::kFreeRun);
  Nanoseconds last = 0;
  for (int i = 0; i < 9; ++i) {
    const auto frame = grab(recorded);
    EXPECT_EQ(frame->counter, static_cast<std::uint64_t>(i % 3 + 1));
    EXPECT_EQ(frame->restarted, i > 0 && i % 3 == 0) << i;
    EXPECT_EQ(frame->device_time, last + kMillisecond);
    EXPECT_EQ(frame->time, 1'000'000'000 + frame->device_time);
    last = frame->device_time;
  }
}

TEST(RecordedCamera, KeepsTheRecordedPaceTimesTheSpeed) {
  using Clock = std::chrono::steady_clock;
  RecordedCamera recorded = camera(times(5, 10 * kMillisecond), 0.5);
  recorded.start(Trigger::kFreeRun);
  const auto begin = Clock::now();
  for (int i = 0; i < 5; ++i)
    ASSERT_TRUE(grab(recorded));
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(80));  // four steps, doubled
}

TEST(RecordedCamera, HandsOutNothingBeforeItsTime) {
  RecordedCamera recorded = camera({kMillisecond, 3'600'000 * kMillisecond}, 1);
  recorded.start(Trigger::kFreeRun);
  ASSERT_TRUE(grab(recorded));
  EXPECT_FALSE(recorded.grab(std::chrono::milliseconds(1)));
  EXPECT_TRUE(grab(recorded)) << "a pause of an hour is shortened";
}

TEST(RecordedCamera, AsksForARateWhereTheFramesHaveNoTimes) {
  RecordedCamera recorded = camera({0, 0}, 1);
  EXPECT_THROW(recorded.start(Trigger::kFreeRun), InvalidParameter);
  CameraSettings settings;
  settings.rate = 1000;
  recorded.configure(settings);
  recorded.start(Trigger::kFreeRun);
  EXPECT_TRUE(grab(recorded));
  EXPECT_TRUE(grab(recorded));
  RecordedCamera fast = camera({0, 0});
  fast.start(Trigger::kFreeRun);
  EXPECT_TRUE(grab(fast));
}

TEST(RecordedCamera, CutsTheRegionOutOfWhatWasRecorded) {
  RecordedCamera recorded = camera(times(2, kMillisecond));
  CameraSettings settings;
  settings.region = {102, 51, 4, 0};
  recorded.configure(settings);
  EXPECT_EQ(recorded.describe().region, (Region{102, 51, 4, 5}));
  recorded.start(Trigger::kFreeRun);
  const auto frame = grab(recorded);
  const auto image = frame->image.as<std::uint8_t>();
  EXPECT_EQ(image.columns, 4);
  EXPECT_EQ(image.rows, 5);
  EXPECT_EQ(image.first_column, 102);
  EXPECT_EQ(image.first_row, 51);
  EXPECT_EQ(image.row(0)[0], 16 * 1 + 2);
  EXPECT_EQ(image.row(4)[3], 16 * 5 + 5);
}

TEST(RecordedCamera, RefusesRegionsThatWereNotRecordedAndCutsNoPayload) {
  RecordedCamera recorded = camera(times(2, kMillisecond));
  for (const Region& region : {Region{99, 50, 4, 4}, Region{100, 50, 9, 4}, Region{100, 56, 0, 0},
                               Region{0, 0, 8, 6}, Region{104, 0, 0, 0}}) {
    CameraSettings settings;
    settings.region = region;
    EXPECT_THROW(recorded.configure(settings), InvalidParameter) << region.x << " " << region.y;
  }
  RecordedCamera payload = camera(times(2, kMillisecond), 0, false, true);
  CameraSettings settings;
  settings.region = {100, 50, 8, 6};
  EXPECT_THROW(payload.configure(settings), InvalidParameter);
}

TEST(RecordedCamera, SaysThatARecordingCannotBeExposedAnew) {
  RecordedCamera recorded = camera(times(2, kMillisecond));
  EXPECT_THROW(recorded.set_exposure(0.001), MissingFeature);
  CameraSettings settings;
  settings.gain = 3;
  EXPECT_THROW(recorded.configure(settings), MissingFeature);
  EXPECT_THROW(recorded.software_trigger(), MissingFeature);
  EXPECT_THROW(camera({1}, -1), InvalidParameter);
}
