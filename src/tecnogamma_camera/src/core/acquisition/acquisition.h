// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "acquisition/frame_numbering.h"
#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

/// The thesis' modes (section 3.2).
enum class AcquisitionMode { kStop, kLiveOnly, kReliefOnly, kReliefLive };

/// How a camera is found, started and monitored.
struct AcquisitionParameters {
  CameraSettings camera;                          //!< set before each start
  AcquisitionMode mode = AcquisitionMode::kStop;  //!< once the camera is first found
  Trigger trigger = Trigger::kExternal;           //!< of `mode`
  double retry_period = 1.0;     //!< [s] from a lost camera to the next try, and between tries
  double start_timeout = 5.0;    //!< [s] for the camera to be found and stream
  double arming_time = 0.2;      //!< [s] time after a start in which a camera may miss pulses
  double silence_timeout = 2.0;  //!< [s] without a frame in free run: the camera is lost
  ClockSettings clock;           //!< how device times become host times
};

/// Changes of the camera settings by set(): all are made, or none.
struct CameraChange {
  double exposure = 0;  //!< [s] 0: the camera's own
  Region region;
  std::optional<double> gain{};      //!< [dB], or the camera's own unit; none: as it is
  std::optional<double> rate{};      //!< [Hz] of free run; none: as it is
  std::function<void()> on_taken{};  //!< called before the start, once the camera has taken them
};

/// A frame with its place in the sequence.
struct NumberedFrame {
  AcquisitionMode mode;             //!< of the acquisition
  std::uint32_t acquisition;        //!< which start of acquisition it belongs to; the first is 1
  std::uint64_t counter;            //!< unwrapped
  Nanoseconds time;                 //!< [ns] of the exposure, on the host's clock
  const Frame& frame;               //!< as the camera sent it
  const CameraDescription& camera;  //!< that took it
};

/// Counts since the acquisition was made.
struct FrameCounts {
  std::uint64_t received = 0;    //!< frames
  std::uint64_t incomplete = 0;  //!< of them, with packets missing; delivered without pixels
  std::uint64_t lost = 0;        //!< missing in the frame counter
  std::uint64_t repeated = 0;    //!< dropped
  std::uint64_t late = 0;        //!< came after a later frame, or with a garbled number
  std::uint64_t garbled = 0;     //!< with a number that is too high, as later frames show
  std::uint64_t restarts = 0;    //!< the counter jumped back: the camera was restarted
  std::uint64_t invalid = 0;     //!< number lost with its packets: dropped, and in lost as well
  std::uint64_t unusable = 0;    //!< damaged, or without what the mode needs: dropped
  std::uint64_t impossible_peaks = 0;  //!< sent by the camera, but not on the sensor: left out
};

/// How an acquisition is doing.
struct AcquisitionState {
  bool connected = false;  //!< to a camera
  std::string message;     //!< why it is not connected, or stopped without a command
  std::string fault;       //!< of the last frame that could not be used
  AcquisitionMode mode = AcquisitionMode::kStop;  //!< as it is now
  Trigger trigger = Trigger::kExternal;           //!< of `mode`
  std::uint32_t acquisition = 0;                  //!< number of the latest start
  CameraDescription camera;                       //!< the last one that was connected
  CameraSettings settings;       //!< as requested; also for a camera that is found later
  StreamStatistics stream;       //!< of the transport
  FrameCounts frames;            //!< since the acquisition was made
  std::uint64_t times_lost = 0;  //!< how often the camera was lost
};

/// Events of an acquisition; called from its thread.
class AcquisitionListener {
 public:
  virtual ~AcquisitionListener() = default;
  virtual void on_frame(const NumberedFrame& frame) = 0;           //!< in the acquisition's thread
  virtual void on_connected(const CameraDescription& camera) = 0;  //!< in the acquisition's thread
  /// A recording was played to its end and is in STOP.
  virtual void on_ended(const std::string& recording) = 0;
  /// Called once for each reason: the camera cannot be opened, was lost, or did not start. Called
  /// once an acquisition if a frame cannot be used.
  virtual void on_trouble(const std::string& reason) = 0;
};

/// Runs a camera in its own thread: opens it, keeps it in the requested mode, numbers its frames,
/// maps their times to the host's clock, and reconnects when it is lost.
///
/// A restart of the camera's counter begins a new acquisition.
///
/// After a loss, an acquisition in external trigger resumes with a new number: nothing happens
/// until the next pulse. One in free run does not resume, since the camera would run, and drive its
/// strobe outputs, without a command; it stays in STOP until set() is called.
class Acquisition {
 public:
  /// Opens the camera; throws if it does not answer.
  using Open = std::function<std::unique_ptr<Camera>()>;

  /// @param listener must outlive it
  Acquisition(const AcquisitionParameters& parameters, Open open, AcquisitionListener& listener);
  ~Acquisition();
  Acquisition(const Acquisition&) = delete;
  Acquisition& operator=(const Acquisition&) = delete;

  /// Stops the camera, and starts it in another mode. Returns once it streams: in free run with
  /// the first frame, in external trigger `arming_time` after the start.
  /// @param change written after the stop. If it is refused, the camera stays stopped and keeps its
  /// settings
  /// @return number of the acquisition; 0 for STOP
  /// @throw scan_cell_common::ConnectionError if the camera is not found, or no frame comes,
  /// within start_timeout
  /// @throw scan_cell_common::Refused if the change asks for the camera's own exposure, which was
  /// overwritten
  /// @throw scan_cell_common::Error as Camera::configure and Camera::start
  std::uint32_t set(AcquisitionMode mode, Trigger trigger,
                    const std::optional<CameraChange>& change = std::nullopt);

  /// Safe in every mode. Also applies after the camera is found again. [s]
  /// @throw scan_cell_common::Error as Camera::set_exposure; the last exposure stays
  void set_exposure(double exposure);

  /// @throw scan_cell_common::Refused unless in STOP
  /// @throw scan_cell_common::Error as Camera::configure; the last region stays
  void set_region(const Region& region);

  AcquisitionState state() const;  //!< of this moment

 private:
  struct Command {
    std::function<std::uint32_t()> action;
    bool needs_camera;
    std::promise<std::uint32_t> result{};
  };
  using CommandPtr = std::shared_ptr<Command>;

  std::uint32_t execute(std::function<std::uint32_t()> action, bool needs_camera);
  CommandPtr take_command();
  void perform(Command& command);
  void wait_for_command(double seconds);

  void run();
  void run_once();
  void connect();
  void lose(const std::string& reason);
  void report(const std::string& reason);
  void change(const CameraChange& change);
  void write(const CameraSettings& settings);
  void start(AcquisitionMode mode, Trigger trigger);
  void stop();
  void finish(const std::string& recording);
  bool deliver_next(double timeout);
  bool deliver(const Frame& frame);
  void drop(const std::string& fault);
  void count_restart();
  void count(const Frame& frame, const FramePlace& place);
  void throw_if_silent() const;

  template <class Change>
  void change_state(const Change& change) {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    change(state_);
  }

  AcquisitionParameters parameters_;
  Open open_;
  AcquisitionListener& listener_;

  // Used only by the thread.
  std::unique_ptr<Camera> camera_;
  CameraDescription description_;
  AcquisitionMode mode_ = AcquisitionMode::kStop;
  AcquisitionMode wanted_;      // the mode to resume when the camera is found again
  bool ended_by_loss_ = false;  // wanted_ became STOP because the camera was lost
  Trigger trigger_;
  std::uint32_t acquisition_ = 0;
  FrameNumbering numbering_;
  std::uint32_t fault_told_ = 0;  // the acquisition in which a fault was last told
  std::chrono::steady_clock::time_point last_frame_;
  std::string reported_;

  mutable std::mutex state_mutex_;
  AcquisitionState state_;

  std::mutex command_mutex_;
  std::condition_variable command_arrived_;
  std::deque<CommandPtr> commands_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace tecnogamma_camera
