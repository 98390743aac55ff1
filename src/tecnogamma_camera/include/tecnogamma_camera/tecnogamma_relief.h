// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tecnogamma_camera/payload_decoder.h"

namespace tecnogamma_camera {

/// What a Tecnogamma camera reports about a frame (thesis, section 3.2, TCamFrameInfo).
struct TecnogammaFrameInfo {
  std::uint32_t time_counter = 0;   //!< in units of payload_tick
  std::uint16_t frame_counter = 0;  //!< wraps 65535 to 0
  std::uint8_t first_kernel = 0;    //!< of the region, in kernels of 32 columns
  std::uint8_t kernels = 0;         //!< of the region
  std::uint16_t first_row = 0;      //!< of the region
  std::uint16_t last_row = 0;       //!< of the region, included
  std::uint8_t decimation = 0;      //!< of live images only: every n-th pixel
  std::uint32_t packets_lost = 0;   //!< above 0: the frame has no peaks
  std::uint32_t offset = 0;         //!< [bytes] of the payload in the memory that follows
  std::uint32_t size = 0;           //!< [bytes] of the payload
};

/// What the camera does not publish.
struct TecnogammaSettings {
  double tick = 0;  //!< [s] of the time counter; 0: not known, the frames are stamped on receipt
  int sensor_columns = 1696;  //!< [px] LUPA3000
  int sensor_rows = 1710;     //!< [px]

  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  void check() const;
};

/// Reads relief and live frames: the frame information, followed by the memory with the payload.
/// All numbers are little-endian, and the frame information is laid out as the Windows compiler
/// does it (docs/tecnogamma_camera.md has the table). The payload has one element a row of the
/// region:
///
/// * threshold: 16 bits the first column of the spot, 16 bits its width; width 0: no spot
/// * centre of gravity: the same, and 32 bits of the centre's column in 1/65536 px
/// * live: one byte a pixel of the region
///
/// Columns count from the region's first. The size of the payload tells the three apart. Peaks have
/// no intensity (NaN): the camera does not send it. Never tested on the camera.
class TecnogammaDecoder : public PayloadDecoder {
 public:
  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  explicit TecnogammaDecoder(const TecnogammaSettings& settings);

  void adapt(const FeatureReader&) override {}
  void describe(CameraDescription& camera) const override;
  double tick() const override { return settings_.tick * 1e9; }  // [s] to [ns]
  std::size_t decode(const ImageView8& payload, std::vector<DecodedFrame>& frames) const override;

  static constexpr std::size_t kInfoSize = 32;  //!< [bytes] chosen, as the packing

  /// @param bytes at least kInfoSize
  static TecnogammaFrameInfo read_info(const std::uint8_t* bytes);

 private:
  Region region_of(const TecnogammaFrameInfo& info) const;

  TecnogammaSettings settings_;
};

}  // namespace tecnogamma_camera
