// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "scan_cell_common/clock/host_clock.h"
#include "tecnogamma_camera/recording.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

constexpr Nanoseconds kLongestPause = 1'000'000'000;  // [ns] chosen
constexpr std::chrono::seconds kLongestLag(1);        // [s] chosen

std::string to_text(const Region& region) {
  return fmt::format("{} x {} at {}, {}", region.width, region.height, region.x, region.y);
}

/// `wanted` with its width and height, if it lies in `whole`.
Region cut_region(const Region& whole, const Region& wanted) {
  Region region = wanted;
  if (wanted == Region()) return whole;
  if (region.width == 0) region.width = whole.x + whole.width - region.x;
  if (region.height == 0) region.height = whole.y + whole.height - region.y;
  if (region.x < whole.x || region.y < whole.y || region.width < 1 || region.height < 1 ||
      region.width > whole.x + whole.width - region.x ||
      region.height > whole.y + whole.height - region.y) {
    throw InvalidParameter("region", to_text(wanted), "the recording has " + to_text(whole));
  }
  return region;
}

/// Time from one frame to the next; none if they have no times of the same clock.
std::optional<Nanoseconds> recorded_step(const Frame& from, const Frame& to) {
  if (from.device_time != 0 && to.device_time != 0) return to.device_time - from.device_time;
  if (from.time != 0 && to.time != 0) return to.time - from.time;
  return std::nullopt;
}

Frame without_pixels(Frame frame) {
  frame.image.pixels = nullptr;
  return frame;
}

}  // namespace

RecordedCamera::RecordedCamera(std::unique_ptr<Recording> recording, const PlaybackOptions& options,
                               bool is_payload)
    : recording_(std::move(recording)), options_(options), is_payload_(is_payload) {
  if (!(options.speed >= 0) || std::isinf(options.speed)) {
    throw InvalidParameter("playback_speed", fmt::format("{:g}", options.speed),
                           "give a factor of the recorded speed, or 0 for as fast as possible");
  }
  region_ = wanted_ = recording_->describe().region;
}

CameraDescription RecordedCamera::describe() {
  CameraDescription description = recording_->describe();
  description.region = wanted_;
  return description;
}

void RecordedCamera::refuse_while_running(const std::string& what) const {
  if (running_) throw Refused(what, "the camera is running", "stop it first");
}

void RecordedCamera::configure(const CameraSettings& settings) {
  refuse_while_running("camera settings");
  if (settings.exposure) set_exposure(*settings.exposure);
  if (settings.gain) {
    throw MissingFeature("gain", fmt::format("{:g}", *settings.gain),
                         "a recording has the gain it was made with: unset the parameter");
  }
  if (settings.rate && !(*settings.rate > 0)) {
    throw InvalidParameter("rate", fmt::format("{:g} Hz", *settings.rate), "give a rate above 0");
  }
  if (is_payload_ && settings.region != Region()) {
    throw InvalidParameter("region", to_text(settings.region),
                           "a recorded payload cannot be cut: leave the region at 0");
  }
  wanted_ = cut_region(region_, settings.region);
  rate_ = settings.rate;
}

void RecordedCamera::set_exposure(double exposure) {
  throw MissingFeature("exposure", fmt::format("{:g} s", exposure),
                       "a recording has the exposure it was made with: unset the parameter");
}

void RecordedCamera::software_trigger() {
  throw MissingFeature("TriggerSoftware", "not available for a recording",
                       "it plays the pulses that were recorded");
}

void RecordedCamera::start(Trigger) {
  refuse_while_running("camera start");
  recording_->rewind();
  first_.reset();
  shift_ = last_step_ = 0;
  statistics_ = {};
  next_ = recording_->next();
  if (!next_) throw UnusableInput(describe().id, "holds no frames", "give a recording with some");
  const bool has_times = next_->device_time != 0 || next_->time != 0;
  if (options_.speed > 0 && !rate_ && !has_times) {
    throw InvalidParameter("rate", "not given, and the recording has no times",
                           "give it, or playback_speed 0 for as fast as possible");
  }
  due_ = Clock::now();
  handed_out_ = false;
  running_ = true;
}

std::optional<Frame> RecordedCamera::grab(std::chrono::microseconds timeout) {
  if (!running_) throw Refused("camera grab", "the camera is stopped", "start it first");
  if (handed_out_) advance();
  if (!next_) {
    throw StreamEnded(describe().id, fmt::format("ended after {} frames", statistics_.completed),
                      "start it again, or set loop");
  }
  const auto wait = due_ - Clock::now();
  if (wait > Clock::duration::zero()) {
    std::this_thread::sleep_for(std::min<Clock::duration>(wait, timeout));
    if (wait > timeout) return std::nullopt;
  }
  handed_out_ = true;
  Frame frame = *next_;
  shift_times(frame);
  if (frame.host_time == 0) frame.host_time = scan_cell_common::host_now();
  if (!is_payload_) cut(frame.image);
  const bool whole = frame.packets_lost == 0 && frame.fault.empty();
  ++(whole ? statistics_.completed : statistics_.failures);
  return frame;
}

void RecordedCamera::advance() {
  handed_out_ = false;
  if (!first_) first_ = without_pixels(*next_);
  const Frame last = without_pixels(*next_);
  next_ = recording_->next();
  if (!next_ && options_.loop) {
    const Nanoseconds span = recorded_step(*first_, last).value_or(0);
    shift_ += span + last_step_;
    recording_->rewind();
    next_ = recording_->next();
    if (next_) next_->restarted = true;
  } else if (next_) {
    last_step_ = recorded_step(last, *next_).value_or(0);
  }
  schedule();
}

void RecordedCamera::schedule() {
  const Nanoseconds step = rate_ ? scan_cell_common::from_seconds(1 / *rate_)
                                 : std::clamp<Nanoseconds>(last_step_, 0, kLongestPause);
  if (options_.speed > 0) {
    due_ += std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double, std::nano>(static_cast<double>(step) / options_.speed));
  }
  due_ = std::max(due_, Clock::now() - kLongestLag);
}

void RecordedCamera::shift_times(Frame& frame) const {
  if (frame.device_time != 0) frame.device_time += shift_;
  if (frame.time != 0) frame.time += shift_;
}

void RecordedCamera::cut(GreyImage& image) const {
  if (image.pixels) {
    visit(image, [&](const auto& view) {
      image.pixels = view.row(wanted_.y - region_.y) + (wanted_.x - region_.x);
    });
  }
  image.columns = wanted_.width;
  image.rows = wanted_.height;
  image.first_column = wanted_.x;
  image.first_row = wanted_.y;
}

}  // namespace tecnogamma_camera
