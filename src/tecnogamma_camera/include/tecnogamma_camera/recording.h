// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

/// Recorded frames, in their order.
class Recording {
 public:
  virtual ~Recording() = default;

  /// The recorded camera, as far as the recording describes it.
  virtual CameraDescription describe() = 0;

  /// The next frame; none at the end. Its pixels are valid until the next call; host_time is 0: it
  /// is set when the frame is played. A frame that cannot be read has a fault.
  virtual std::optional<Frame> next() = 0;

  /// Goes back to the first frame.
  virtual void rewind() = 0;
};

/// Opens a recording at a path.
/// @throw scan_cell_common::Error if it cannot be used
using OpenRecording = std::function<std::unique_ptr<Recording>(const std::string& path)>;

/// Openers of recordings, by the word before the colon in a camera's name, such as "folder".
using RecordingKinds = std::map<std::string, OpenRecording>;

/// How a recording is played.
struct PlaybackOptions {
  double speed = 1;   //!< factor of the recorded speed; 0: as fast as frames are grabbed
  bool loop = false;  //!< starts again at the end, like a camera that was restarted
};

/// Plays a recording as a camera. Each start begins at the first frame. Both triggers play the
/// recorded pulses. Frames come at the rate in the settings, or at their recorded times with pauses
/// shortened to a second. The region can be made smaller. Exposure and gain are missing features,
/// since recorded frames cannot be exposed again.
class RecordedCamera : public Camera {
 public:
  /// @param is_payload the frames are not images: they cannot be cut
  /// @throw scan_cell_common::InvalidParameter naming the option that is out of range
  RecordedCamera(std::unique_ptr<Recording> recording, const PlaybackOptions& options,
                 bool is_payload);

  CameraDescription describe() override;  //!< of the camera that was recorded
  void configure(const CameraSettings& settings) override;
  void set_exposure(double exposure) override;
  /// @throw scan_cell_common::InvalidParameter if the frames have no times and no rate was given
  void start(Trigger trigger) override;
  void stop() override { running_ = false; }
  std::optional<Frame> grab(std::chrono::microseconds timeout) override;
  void software_trigger() override;
  StreamStatistics statistics() override { return statistics_; }  //!< of the playback
  void throw_if_lost() override {}

 private:
  using Clock = std::chrono::steady_clock;

  void refuse_while_running(const std::string& what) const;
  void advance();
  void schedule();
  void shift_times(Frame& frame) const;
  void cut(GreyImage& image) const;

  std::unique_ptr<Recording> recording_;
  PlaybackOptions options_;
  bool is_payload_;
  Region region_;  // that was recorded
  Region wanted_;
  std::optional<double> rate_;
  bool running_ = false;
  StreamStatistics statistics_;

  std::optional<Frame> next_;
  bool handed_out_ = false;  // next_ was, and is replaced at the next grab
  Clock::time_point due_;    // when next_ is handed out
  std::optional<Frame> first_;
  Nanoseconds last_step_ = 0;
  Nanoseconds shift_ = 0;  // of the times in this turn of the loop
};

}  // namespace tecnogamma_camera
