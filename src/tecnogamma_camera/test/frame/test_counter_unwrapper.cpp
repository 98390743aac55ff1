// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tecnogamma_camera/counter_unwrapper.h"

using tecnogamma_camera::CounterRule;
using tecnogamma_camera::CounterStep;
using tecnogamma_camera::CounterUnwrapper;
using Kind = CounterStep::Kind;

namespace {

void expect_step(const CounterStep& step, Kind kind, std::uint64_t count, std::uint64_t lost = 0) {
  EXPECT_EQ(step.kind, kind);
  EXPECT_EQ(step.count, count);
  EXPECT_EQ(step.lost, lost);
}

}  // namespace

TEST(CounterUnwrapper, KnowsThatGigEVisionLeavesOutZero) {
  CounterUnwrapper unwrapper(tecnogamma_camera::kGigEVisionBlockId);
  expect_step(unwrapper.unwrap(65534), Kind::kFirst, 65534);
  expect_step(unwrapper.unwrap(65535), Kind::kNext, 65535);
  expect_step(unwrapper.unwrap(1), Kind::kNext, 65536);
  expect_step(unwrapper.unwrap(2), Kind::kNext, 65537);
  expect_step(unwrapper.unwrap(0), Kind::kInvalid, 0);
  expect_step(unwrapper.unwrap(65536), Kind::kInvalid, 0);
}

TEST(CounterUnwrapper, CountsOnThroughThousandsOfTurns) {
  for (const CounterRule& rule :
       {tecnogamma_camera::kGigEVisionBlockId, tecnogamma_camera::kCounter16}) {
    CounterUnwrapper unwrapper(rule);
    const std::uint64_t period = rule.last - rule.first + 1;
    std::uint64_t raw = rule.last - 3;
    const std::uint64_t start = raw;
    unwrapper.unwrap(raw);
    for (std::uint64_t i = 1; i < 20 * period; ++i) {
      raw = raw == rule.last ? rule.first : raw + 1;
      const CounterStep step = unwrapper.unwrap(raw);
      ASSERT_EQ(step.kind, Kind::kNext);
      ASSERT_EQ(step.count, start + i);
    }
  }
}

TEST(CounterUnwrapper, SaysHowManyFramesAGapLostAlsoAcrossTheTurn) {
  CounterUnwrapper gige(tecnogamma_camera::kGigEVisionBlockId);
  gige.unwrap(65530);
  expect_step(gige.unwrap(65533), Kind::kGap, 65533, 2);
  expect_step(gige.unwrap(3), Kind::kGap, 65538, 4);  // 65534, 65535, 1, 2
  CounterUnwrapper sixteen(tecnogamma_camera::kCounter16);
  sixteen.unwrap(65533);
  expect_step(sixteen.unwrap(3), Kind::kGap, 65539, 5);  // 65534, 65535, 0, 1, 2
  CounterUnwrapper photonfocus(tecnogamma_camera::kCounter24);
  photonfocus.unwrap(0xFFFFFF);
  expect_step(photonfocus.unwrap(0), Kind::kNext, 0x1000000);
}

TEST(CounterUnwrapper, TellsRepeatedAndEarlierFramesAndStaysWhereItWas) {
  CounterUnwrapper unwrapper(tecnogamma_camera::kCounter16);
  unwrapper.unwrap(100);
  expect_step(unwrapper.unwrap(100), Kind::kRepeated, 100);
  expect_step(unwrapper.unwrap(98), Kind::kBackward, 98);
  expect_step(unwrapper.unwrap(101), Kind::kNext, 101);
  unwrapper.reset();
  expect_step(unwrapper.unwrap(5), Kind::kFirst, 5);
}

TEST(CounterUnwrapper, TellsAnEarlierFrameAcrossTheTurn) {
  CounterUnwrapper unwrapper(tecnogamma_camera::kGigEVisionBlockId);
  unwrapper.unwrap(65535);
  unwrapper.unwrap(1);
  expect_step(unwrapper.unwrap(65535), Kind::kBackward, 65535);
}

TEST(CounterUnwrapper, NeverWrapsACounterOf64Bits) {
  CounterUnwrapper unwrapper(tecnogamma_camera::kCounter64);
  unwrapper.unwrap(65535);
  expect_step(unwrapper.unwrap(65536), Kind::kNext, 65536);
  expect_step(unwrapper.unwrap(1), Kind::kBackward, 1);
}
