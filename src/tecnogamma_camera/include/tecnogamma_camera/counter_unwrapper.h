// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tecnogamma_camera {

/// The values a device's frame counter runs through: first .. last, then first again.
struct CounterRule {
  std::uint64_t first;  //!< value after `last`
  std::uint64_t last;   //!< greatest value
};

constexpr CounterRule kGigEVisionBlockId{1, 65535};  //!< 0 is never sent with an image
constexpr CounterRule kCounter16{0, 0xFFFF};         //!< Tecnogamma (thesis, section 3.2)
constexpr CounterRule kCounter24{0, 0xFFFFFF};       //!< Photonfocus
constexpr CounterRule kCounter32{0, 0xFFFFFFFF};     //!< clocks of smart cameras
constexpr CounterRule kCounter64{0, INT64_MAX};      //!< never wraps: GigE Vision 2, USB3 Vision

/// What one counter value says about the frames before it.
struct CounterStep {
  /// How the value follows the one before.
  enum class Kind {
    kFirst,     //!< the first frame
    kNext,      //!< the one after the last
    kGap,       //!< `lost` frames before it never came
    kRepeated,  //!< the same frame once more
    kBackward,  //!< an earlier frame: late, or the device was restarted. Nothing is guessed
    kInvalid    //!< outside this counter's range
  };

  Kind kind;                //!< how it follows
  std::uint64_t count = 0;  //!< unwrapped: starts at the first value, never wraps; 0 for INVALID
  std::uint64_t lost = 0;   //!< of a GAP
};

/// Turns a counter that wraps into one that does not. A step of up to half the counter's range is
/// forward, a larger one is backward. A step backward does not change the unwrapper; call reset()
/// if the device was restarted.
class CounterUnwrapper {
 public:
  /// @param rule the values that the counter runs through
  explicit CounterUnwrapper(const CounterRule& rule) : rule_(rule) {}

  /// Takes the device's next value.
  CounterStep unwrap(std::uint64_t raw);

  /// The next value is the first again.
  void reset() { started_ = false; }

 private:
  CounterRule rule_;
  bool started_ = false;
  std::uint64_t last_raw_ = 0;
  std::uint64_t last_count_ = 0;
};

}  // namespace tecnogamma_camera
