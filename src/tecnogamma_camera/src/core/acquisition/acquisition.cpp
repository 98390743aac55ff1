// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "acquisition/acquisition.h"

#include <fmt/format.h>

#include <algorithm>

namespace tecnogamma_camera {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;
using Clock = std::chrono::steady_clock;

constexpr double kPoll = 0.05;  // [s] longest wait before commands are checked; chosen

Clock::duration seconds(double value) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(value));
}

}  // namespace

Acquisition::Acquisition(const AcquisitionParameters& parameters, Open open,
                         AcquisitionListener& listener)
    : parameters_(parameters),
      open_(std::move(open)),
      listener_(listener),
      wanted_(parameters.mode),
      trigger_(parameters.trigger),
      numbering_(kCounter64, parameters.clock) {
  state_.message = "the camera has not been searched for yet";
  state_.trigger = trigger_;
  state_.settings = parameters.camera;
  thread_ = std::thread([this] { run(); });
}

Acquisition::~Acquisition() {
  {
    const std::lock_guard<std::mutex> lock(command_mutex_);
    ending_ = true;
  }
  command_arrived_.notify_all();
  thread_.join();
}

std::uint32_t Acquisition::set(AcquisitionMode mode, Trigger trigger,
                               const std::optional<CameraChange>& changes) {
  const bool starts = mode != AcquisitionMode::kStop;
  return execute(
      [this, mode, trigger, starts, changes] {
        wanted_ = AcquisitionMode::kStop;  // if the start fails, the caller is told
        ended_by_loss_ = false;
        stop();
        if (changes) change(*changes);
        if (!starts) return 0U;
        start(mode, trigger);
        wanted_ = mode_;  // STOP if a recording has already ended
        return acquisition_;
      },
      starts);
}

void Acquisition::change(const CameraChange& change) {
  CameraSettings changed = parameters_.camera;
  changed.region = change.region;
  if (change.exposure > 0) {
    changed.exposure = change.exposure;
  } else if (changed.exposure) {
    throw Refused("exposure", "0 s: the camera's own exposure has been overwritten",
                  "give a value above 0, or restart the camera and the node");
  }
  if (change.gain) changed.gain = change.gain;
  if (change.rate) changed.rate = change.rate;
  write(changed);
  if (change.on_taken) change.on_taken();
}

/// A camera that is not connected gets the settings when it is found.
void Acquisition::write(const CameraSettings& settings) {
  if (camera_) {
    try {
      camera_->configure(settings);
    } catch (const ConnectionError&) {
      throw;
    } catch (const scan_cell_common::Error&) {
      camera_->configure(parameters_.camera);  // some may have been written before the refusal
      throw;
    }
    description_ = camera_->describe();
  }
  parameters_.camera = settings;
  change_state([&](AcquisitionState& s) {
    s.settings = settings;
    s.camera = description_;
  });
}

void Acquisition::set_exposure(double exposure) {
  execute(
      [this, exposure] {
        if (camera_) camera_->set_exposure(exposure);
        parameters_.camera.exposure = exposure;
        if (camera_) description_ = camera_->describe();
        change_state([this](AcquisitionState& s) {
          s.settings = parameters_.camera;
          s.camera = description_;
        });
        return 0U;
      },
      false);
}

void Acquisition::set_region(const Region& region) {
  execute(
      [this, region] {
        if (mode_ != AcquisitionMode::kStop) {
          throw Refused("region", "the camera is running", "change it in mode STOP");
        }
        CameraSettings changed = parameters_.camera;
        changed.region = region;
        write(changed);
        return 0U;
      },
      false);
}

AcquisitionState Acquisition::state() const {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  return state_;
}

std::uint32_t Acquisition::execute(std::function<std::uint32_t()> action, bool needs_camera) {
  const CommandPtr command(new Command{std::move(action), needs_camera});
  std::future<std::uint32_t> result = command->result.get_future();
  {
    const std::lock_guard<std::mutex> lock(command_mutex_);
    commands_.push_back(command);
  }
  command_arrived_.notify_all();
  if (result.wait_for(seconds(parameters_.start_timeout)) == std::future_status::timeout) {
    const std::lock_guard<std::mutex> lock(command_mutex_);
    const auto waiting = std::find(commands_.begin(), commands_.end(), command);
    if (waiting != commands_.end()) {
      commands_.erase(waiting);
      throw ConnectionError("camera", "not connected: " + state().message,
                            "try again when it has been found");
    }
  }
  return result.get();  // a command that has started ends soon: the camera's time-outs limit it
}

Acquisition::CommandPtr Acquisition::take_command() {
  const std::lock_guard<std::mutex> lock(command_mutex_);
  const auto ready = std::find_if(commands_.begin(), commands_.end(), [this](const CommandPtr& c) {
    return camera_ || !c->needs_camera;
  });
  if (ready == commands_.end()) return nullptr;
  const CommandPtr command = *ready;
  commands_.erase(ready);
  return command;
}

void Acquisition::perform(Command& command) {
  try {
    command.result.set_value(command.action());
  } catch (const ConnectionError& error) {
    command.result.set_exception(std::current_exception());
    if (camera_) lose(error.what());
  } catch (const std::exception&) {
    command.result.set_exception(std::current_exception());
  }
}

void Acquisition::wait_for_command(double duration) {
  std::unique_lock<std::mutex> lock(command_mutex_);
  command_arrived_.wait_for(lock, seconds(duration), [this] {
    return ending_ || std::any_of(commands_.begin(), commands_.end(), [this](const CommandPtr& c) {
             return camera_ || !c->needs_camera;
           });
  });
}

void Acquisition::run() {
  for (;;) {
    {
      const std::lock_guard<std::mutex> lock(command_mutex_);
      if (ending_) break;
    }
    try {
      run_once();
    } catch (const std::exception& error) {
      lose(error.what());
    }
  }
  camera_.reset();
}

void Acquisition::run_once() {
  if (const CommandPtr command = take_command()) {
    perform(*command);
  } else if (!camera_) {
    connect();
  } else if (mode_ == AcquisitionMode::kStop) {
    wait_for_command(kPoll);
    camera_->throw_if_lost();
  } else {
    deliver_next(kPoll);
    throw_if_silent();
  }
}

void Acquisition::connect() {
  camera_ = open_();
  camera_->configure(parameters_.camera);
  description_ = camera_->describe();
  numbering_ = FrameNumbering(description_.counter, parameters_.clock);
  reported_.clear();
  change_state([&](AcquisitionState& s) {
    s.connected = true;
    s.camera = description_;
    if (!ended_by_loss_) s.message.clear();
  });
  listener_.on_connected(description_);
  if (wanted_ == AcquisitionMode::kStop) return;
  try {
    start(wanted_, trigger_);
  } catch (const ConnectionError&) {
    throw;
  } catch (const scan_cell_common::Error& error) {
    wanted_ = AcquisitionMode::kStop;
    report(error.what());
  }
}

void Acquisition::lose(const std::string& reason) {
  const bool was_there = state().connected;
  const bool ends = was_there && wanted_ != AcquisitionMode::kStop && trigger_ == Trigger::kFreeRun;
  if (ends) {
    wanted_ = AcquisitionMode::kStop;
    ended_by_loss_ = true;
  }
  mode_ = AcquisitionMode::kStop;
  change_state([&](AcquisitionState& s) {
    s.connected = false;
    s.mode = AcquisitionMode::kStop;
    if (was_there) ++s.times_lost;
  });
  report(ends ? reason + " (free run does not resume: start the camera again when it is found)"
              : reason);
  camera_.reset();

  const Clock::time_point next_try = Clock::now() + seconds(parameters_.retry_period);
  while (Clock::now() < next_try) {
    wait_for_command(scan_cell_common::to_seconds((next_try - Clock::now()).count()));
    const CommandPtr command = take_command();
    if (command) perform(*command);
    const std::lock_guard<std::mutex> lock(command_mutex_);
    if (ending_) return;
  }
}

void Acquisition::report(const std::string& reason) {
  change_state([&](AcquisitionState& s) { s.message = reason; });
  if (reason != reported_) listener_.on_trouble(reason);
  reported_ = reason;
}

void Acquisition::start(AcquisitionMode mode, Trigger trigger) {
  stop();
  camera_->start(trigger);
  description_ = camera_->describe();  // the packet size was found at the start
  mode_ = mode;
  trigger_ = trigger;
  ++acquisition_;
  numbering_.begin();
  last_frame_ = Clock::now();
  change_state([&](AcquisitionState& s) {
    s.message.clear();
    s.mode = mode;
    s.trigger = trigger;
    s.acquisition = acquisition_;
    s.camera = description_;
  });
  const bool free_run = trigger == Trigger::kFreeRun;
  const Clock::time_point end =
      Clock::now() + seconds(free_run ? parameters_.start_timeout : parameters_.arming_time);
  bool delivered = false;
  while (Clock::now() < end && mode_ != AcquisitionMode::kStop) {  // a recording may end
    const double left = scan_cell_common::to_seconds((end - Clock::now()).count());
    delivered |= deliver_next(std::min(kPoll, std::max(0.0, left)));
    if (delivered && free_run) return;
  }
  if (delivered || (!free_run && mode_ != AcquisitionMode::kStop)) return;
  if (fault_told_ == acquisition_) {
    const std::string fault = state().fault;
    stop();
    throw UnusableInput("camera", "no frame can be used", fault);
  }
  throw ConnectionError("camera", fmt::format("no frame within {} s", parameters_.start_timeout),
                        "check its rate, and that the firewall does not block the stream");
}

void Acquisition::stop() {
  mode_ = AcquisitionMode::kStop;
  if (camera_) camera_->stop();
  change_state([](AcquisitionState& s) {
    s.mode = AcquisitionMode::kStop;
    if (s.connected) s.message.clear();
  });
}

void Acquisition::finish(const std::string& recording) {
  wanted_ = AcquisitionMode::kStop;
  stop();
  change_state([&](AcquisitionState& s) { s.message = recording; });
  listener_.on_ended(recording);
}

bool Acquisition::deliver_next(double timeout) {
  std::optional<Frame> frame;
  try {
    frame = camera_->grab(std::chrono::duration_cast<std::chrono::microseconds>(seconds(timeout)));
  } catch (const StreamEnded& end) {
    finish(end.what());
    return false;
  }
  const StreamStatistics statistics = camera_->statistics();
  change_state([&](AcquisitionState& s) { s.stream = statistics; });
  if (!frame) return false;
  last_frame_ = Clock::now();
  return deliver(*frame);
}

void Acquisition::drop(const std::string& fault) {
  change_state([&](AcquisitionState& s) {
    ++s.frames.received;
    ++s.frames.unusable;
    s.fault = fault;
  });
  if (fault_told_ == acquisition_) return;
  fault_told_ = acquisition_;
  listener_.on_trouble("a frame cannot be used: " + fault);
}

bool Acquisition::deliver(const Frame& frame) {
  if (frame.restarted) {
    numbering_.begin();
    count_restart();
  }
  if (!frame.fault.empty()) {
    drop(frame.fault);
    return false;
  }
  if (mode_ == AcquisitionMode::kLiveOnly && frame.peaks && !frame.image.pixels) {
    drop("peaks and no image: set the camera to send images, or use a relief mode");
    return false;
  }
  const FramePlace place = numbering_.place(frame);
  if (place.restarted) count_restart();
  count(frame, place);
  if (place.step.kind == CounterStep::Kind::kInvalid) return true;
  listener_.on_frame({mode_, acquisition_, place.step.count, place.time, frame, description_});
  return true;
}

void Acquisition::count_restart() {
  ++acquisition_;
  change_state([](AcquisitionState& s) { ++s.frames.restarts; });
}

void Acquisition::count(const Frame& frame, const FramePlace& place) {
  using Kind = CounterStep::Kind;
  const Kind kind = place.step.kind;
  change_state([&](AcquisitionState& s) {
    s.acquisition = acquisition_;
    ++s.frames.received;
    s.frames.incomplete += kind != Kind::kInvalid && frame.packets_lost > 0 ? 1 : 0;
    s.frames.impossible_peaks += frame.impossible_peaks;
    s.frames.lost += place.step.lost;
    s.frames.lost -= place.found;
    s.frames.garbled += place.was_garbled ? 1 : 0;
    s.frames.repeated += kind == Kind::kRepeated ? 1 : 0;
    s.frames.late += kind == Kind::kBackward ? 1 : 0;
    s.frames.invalid += kind == Kind::kInvalid ? 1 : 0;
  });
}

void Acquisition::throw_if_silent() const {
  if (trigger_ != Trigger::kFreeRun ||
      Clock::now() - last_frame_ < seconds(parameters_.silence_timeout))
    return;
  throw ConnectionError("camera", fmt::format("no frame for {} s", parameters_.silence_timeout),
                        "check its cable and power");
}

}  // namespace tecnogamma_camera
