// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tecnogamma_camera/payload_decoder.h"

namespace tecnogamma_camera {

/// The peak of one column (manual MAN052, section 5.2.9, DataFormat3D 0).
struct Photonfocus3D03Peak {
  float position = 0;  //!< [px] rows below the scan area's first; 0: no peak
  int width = 0;       //!< [px]
  int height = 0;      //!< highest 4 bits of the brightest pixel
};

/// Decodes the four rows of 3D data of one column.
constexpr Photonfocus3D03Peak decode_photonfocus_peak(std::uint8_t row0, std::uint8_t row1,
                                                      std::uint8_t row2, std::uint8_t row3) {
  constexpr float kPerPixel = 64;  // [1/px] 6 of 16 bits are below the pixel; MAN052, as above
  return {static_cast<float>(row0 << 8 | row1) / kPerPixel, row2 & 0x3F, row3 >> 4};
}

/// Where the camera's scan area is, and its mode.
struct Photonfocus3D03Settings {
  int scan_first_row = -1;    //!< [px] Peak0_3DY; -1: ask the camera
  int scan_rows = -1;         //!< [px] Peak0_3DH; -1: ask the camera
  bool with_image = false;    //!< the camera is in its mode 2D&3D, not in 3Donly
  int sensor_columns = 2048;  //!< [px] of the sensor as it is made
  int sensor_rows = 1088;     //!< [px]

  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  void check() const;
};

/// Reads the frames of a Photonfocus MV1-D2048-3D03 with one peak. In 3Donly each combined frame
/// has five rows: the 2D line, and four of 3D data. In 2D&3D the scan area comes before them. The
/// filler of a combined frame that was cut short is left out.
///
/// The camera finds one peak a column, but this suite needs one peak a row, so the sensor is
/// treated as turned by a quarter. Column u of the turned sensor is the sensor's row u; row v is
/// its column sensor_columns - 1 - v (turned, not mirrored, so that a pinhole model still fits).
/// Images are turned in the same way. Intensity is the middle of the range of grey values given by
/// the height. Written from the manual, never tested on the camera.
class Photonfocus3D03Decoder : public PayloadDecoder {
 public:
  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  explicit Photonfocus3D03Decoder(const Photonfocus3D03Settings& settings);

  void adapt(const FeatureReader& feature) override;
  void describe(CameraDescription& camera) const override;
  double tick() const override { return 1000; }  // [ns] as of the 3D05 and 3D06
  std::size_t decode(const ImageView8& payload, std::vector<DecodedFrame>& frames) const override;

 private:
  void decode_block(const ImageView8& payload, int row, DecodedFrame& frame) const;
  void turn_image(const ImageView8& payload, DecodedFrame& frame) const;
  int first_row_of(const ImageView8& payload) const;

  Photonfocus3D03Settings asked_;
  Photonfocus3D03Settings settings_;  // with the values read from the camera
};

}  // namespace tecnogamma_camera
