// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "scan_cell_sim/laser_line_renderer.h"
#include "scan_cell_sim/trigger_circuit.h"

namespace scan_cell_sim {

/// Address and limits of the camera.
struct CameraOptions {
  std::string address =
      "127.0.0.1";  //!< IPv4 of the interface to serve on; GigE Vision's port is fixed
  std::string serial = "SIM001";          //!< by which a client may name it
  std::string genicam_file;               //!< config/gige_camera.xml
  int sensor_width = 1696;                //!< [px]
  int sensor_height = 1710;               //!< [px]
  Region region = {336, 599, 1024, 512};  //!< at power-up
  double min_period = 0.002;  //!< [s] of the sensor: an earlier pulse after the last one is lost
  double wire_rate = 125e6;   //!< [bytes/s] Gigabit Ethernet
  int max_pending = 1000;     //!< shots to be drawn and sent; a pulse beyond them is lost
};

/// Injected faults.
struct CameraFaults {
  double lost_frames = 0;        //!< share of the pulses whose frame never leaves the camera
  double lost_packets = 0;       //!< share of the packets that never arrive, even if sent again
  double packets_lost_once = 0;  //!< share that arrives only on a second request
  unsigned seed = 1;             //!< decides which frames and packets are lost
};

/// A GigE Vision camera with Aravis' registers and features (gige/control_server.h). A function
/// renders its sensor's image. It runs freely or, in trigger mode with the source Line0, makes one
/// frame for each pulse, rendered once its exposure is over. A frame's device time is the instant
/// of its pulse on the host's clock. Frames go out at the pace of a real wire, and lost packets are
/// sent again on request. All methods are safe to call from any thread.
class GigeCamera {
 public:
  /// What to render: the instant and the lasers.
  struct Shot {
    scan_cell_common::Nanoseconds time = 0;  //!< host time
    std::uint8_t lasers = 0;                 //!< mask of those that are on at `time`
    double exposure = 0;                     //!< [s]
    double gain = 1;                         //!< factor
    std::uint64_t frame = 0;                 //!< from 1, never wraps
  };
  /// Draws a frame: region.width x region.height grey values, row by row.
  using Render = std::function<void(const Shot&, const Region&, std::uint8_t* pixels)>;

  /// Counts of what happened to the pulses.
  struct Counts {
    std::uint64_t pulses = 0;           //!< all
    std::uint64_t ignored = 0;          //!< not acquiring, or not in trigger mode
    std::uint64_t too_soon = 0;         //!< lost: less than min_period after the one before
    std::uint64_t queue_full = 0;       //!< lost: max_pending frames were to be sent
    std::uint64_t lost_on_purpose = 0;  //!< by CameraFaults
    std::uint64_t discarded = 0;        //!< pending when acquisition stopped
    std::uint64_t frames = 0;           //!< sent, free-running ones included
  };

  /// Starts to serve at once.
  /// @param lasers_now bit mask of the lasers that are on, for frames without a pulse
  /// @throw scan_cell_common::InvalidParameter if the region does not fit the sensor
  /// @throw scan_cell_common::FileError if the GenICam file cannot be read
  /// @throw scan_cell_common::ConnectionError if the address cannot be served
  GigeCamera(const CameraOptions& options, Render render, std::function<std::uint8_t()> lasers_now);
  ~GigeCamera();

  GigeCamera(const GigeCamera&) = delete;
  GigeCamera& operator=(const GigeCamera&) = delete;

  void pulse(const TriggerCircuit::Pulse& pulse);  //!< of the trigger circuit
  void set_faults(const CameraFaults& faults);     //!< they replace the previous ones

  /// Without power the camera does not answer; powered up again, it has forgotten its settings.
  /// @throw scan_cell_common::ConnectionError if the address cannot be served
  void set_power(bool on);
  bool has_power() const;  //!< see set_power()

  Counts counts() const;  //!< since its start

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell_sim
