// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/timed_pose.h"
#include "tecnogamma_camera/counter_unwrapper.h"
#include "tecnogamma_camera/image_view.h"
#include "tecnogamma_camera/peak_profile.h"

namespace tecnogamma_camera {

using scan_cell_common::Nanoseconds;

/// The camera lacks a feature that was asked for. value() names the feature.
class MissingFeature : public scan_cell_common::Error {
 public:
  using Error::Error;
};

/// What makes the camera take a frame.
enum class Trigger {
  kFreeRun,  //!< the camera's own clock
  kExternal  //!< one frame a pulse
};

/// Part of the sensor that is read out [px]. Width or height 0: from the offset to the sensor's
/// edge.
struct Region {
  int x = 0;       //!< [px] first column
  int y = 0;       //!< [px] first row
  int width = 0;   //!< [px] 0: to the sensor's edge
  int height = 0;  //!< [px] 0: to the sensor's edge
};

/// Whether they are the same region.
inline bool operator==(const Region& a, const Region& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}
/// Whether they are different regions.
inline bool operator!=(const Region& a, const Region& b) {
  return !(a == b);
}

/// Settings of a camera before it starts. An empty optional leaves the camera's own value.
struct CameraSettings {
  Region region;                         //!< part of the sensor to read out
  std::optional<double> exposure;        //!< [s]
  std::optional<double> gain;            //!< [dB], or the camera's own unit
  std::optional<double> rate;            //!< [Hz] of free run
  std::string trigger_source = "Line0";  //!< GenICam TriggerSource of the external trigger
  /// GenICam LineSelector of the outputs to drive, separated by commas; empty: leave all alone
  std::string strobe_line;
  std::string strobe_source = "ExposureActive";  //!< GenICam LineSource of these outputs
  std::string pixel_format = "Mono8";  //!< GenICam PixelFormat; one of pixel_format_names()
};

/// A camera's description of itself.
struct CameraDescription {
  std::string id;                            //!< to open it again
  std::string vendor;                        //!< as the camera reports it
  std::string model;                         //!< as the camera reports it
  std::string serial;                        //!< as the camera reports it
  std::string transport;                     //!< GigE Vision, USB3 Vision ...
  int sensor_columns = 0;                    //!< [px]
  int sensor_rows = 0;                       //!< [px]
  Region region;                             //!< as read back, never 0
  int grey_bits = 8;                         //!< of a grey value
  double exposure = 0;                       //!< [s] 0: the camera does not report it
  int packet_size = 0;                       //!< [bytes] of the stream; 0: no packets
  CounterRule counter{};                     //!< of its frame counter
  std::vector<std::string> lines;            //!< GenICam LineSelector: its inputs and outputs
  std::vector<std::string> trigger_sources;  //!< GenICam TriggerSource: what can trigger it
};

/// Counts since the last start.
struct StreamStatistics {
  std::uint64_t completed = 0;        //!< frames received whole
  std::uint64_t failures = 0;         //!< frames received with packets missing
  std::uint64_t underruns = 0;        //!< frames for which no buffer was free: lost
  std::uint64_t missing_packets = 0;  //!< packets that never came
  std::uint64_t resent_packets = 0;   //!< packets that came on a second request
};

/// The counter of a frame that lost its number with its packets.
constexpr std::uint64_t kNoFrameNumber = UINT64_MAX;

/// One frame. The camera owns the pixels: they are valid until the next grab(), stop() or the
/// camera's destruction. A frame with missing packets has no pixels, since some would belong to an
/// earlier frame; its image then gives only the region.
struct Frame {
  std::uint64_t counter = kNoFrameNumber;  //!< raw, as the camera counts
  Nanoseconds device_time = 0;             //!< [ns] camera's clock at the exposure; 0: not known
  Nanoseconds host_time = 0;               //!< [ns] when it was received
  std::uint32_t packets_lost = 0;          //!< packets missing from it
  GreyImage image;                         //!< without pixels where packets are missing

  Nanoseconds time = 0;    //!< [ns] of the exposure on the host's clock, if already known; or 0
  bool restarted = false;  //!< the counter and the clock start again with this frame
  const PeakProfile* peaks = nullptr;  //!< found by the camera, valid as long as the pixels
  std::uint32_t impossible_peaks = 0;  //!< left out of `peaks`: not on the sensor
  std::string fault;                   //!< why the frame cannot be used; empty: it can
};

/// Thrown when the camera will never send a frame again: its recording has ended.
class StreamEnded : public scan_cell_common::Error {
 public:
  using Error::Error;
};

/// An open camera. It is in STOP until start(). Parameters are written only in STOP, except the
/// exposure. Not safe for use from several threads at once.
///
/// Every method throws scan_cell_common::ConnectionError if the camera is lost.
class Camera {
 public:
  virtual ~Camera() = default;

  virtual CameraDescription describe() = 0;  //!< of the connected camera

  /// @throw scan_cell_common::Refused while running
  /// @throw scan_cell_common::InvalidParameter naming the setting and the camera's range
  /// @throw MissingFeature for a setting the camera does not have
  virtual void configure(const CameraSettings& settings) = 0;

  /// Safe while running; takes effect with the next frames. [s]
  /// @throw as configure
  virtual void set_exposure(double exposure) = 0;

  /// @throw scan_cell_common::Refused while running
  /// @throw MissingFeature if the camera does not support this trigger
  virtual void start(Trigger trigger) = 0;

  /// Does nothing if the camera is stopped.
  virtual void stop() = 0;

  /// The next frame, or none within the timeout.
  /// @throw StreamEnded if there will be none
  virtual std::optional<Frame> grab(std::chrono::microseconds timeout) = 0;

  /// Pulses a camera whose trigger source is "Software".
  virtual void software_trigger() = 0;

  virtual StreamStatistics statistics() = 0;  //!< since it was opened

  /// The value of a GenICam feature; none if the camera does not have it.
  virtual std::optional<std::int64_t> feature(const std::string& /*name*/) { return std::nullopt; }

  /// @throw scan_cell_common::ConnectionError if the camera is known to be lost. Never waits.
  virtual void throw_if_lost() = 0;
};

}  // namespace tecnogamma_camera
