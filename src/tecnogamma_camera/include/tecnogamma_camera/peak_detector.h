// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tecnogamma_camera/image_view.h"
#include "tecnogamma_camera/peak_profile.h"

namespace tecnogamma_camera {

/// How a detector finds the laser's spot in a row.
struct DetectorSettings {
  int trigger_level = 60;  //!< [grey value] 0 .. 255: a pixel above it is lit
  int permanence = 2;  //!< [px] lit pixels in a row that make a rising edge, dark ones a falling
  int window = 15;     //!< [px] columns that the centre of gravity is taken over

  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  void check() const;
};

/// Finds the laser line in a frame: it runs vertically, with one peak a row.
///
/// All detectors share how a row's spot is found (thesis, section 3.2). A pixel is lit above the
/// trigger level. `permanence` consecutive lit pixels are a rising edge, which stands at the first
/// of them; after it, `permanence` consecutive dark pixels are a falling edge, which stands at the
/// first of them. Among several spots in a row the one with the greatest sum of grey values wins,
/// the leftmost of equals. A spot is cut by the image's border where no dark pixel lies before its
/// rising edge, or its falling edge is not complete: where a cut spot wins, the row has no peak,
/// since its middle is not known and the other spots are more likely reflections.
class PeakDetector {
 public:
  virtual ~PeakDetector() = default;

  /// Writes one element a row of the image.
  virtual void detect(const ImageView8& image, PeakProfile& profile) const = 0;
};

/// Position is the middle between the edges, in steps of half a pixel.
class ThresholdDetector : public PeakDetector {
 public:
  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  explicit ThresholdDetector(const DetectorSettings& settings);
  void detect(const ImageView8& image, PeakProfile& profile) const override;

 private:
  DetectorSettings settings_;
};

/// Position is the centre of gravity of the grey values above the background, in a window about the
/// spot's middle: `window` columns, or the spot and one pixel either side where that is more. The
/// window stays symmetric about the spot and ends half way to the next spot and at the image's
/// border. The background is the mean of its two outermost pixels on each side (one where the
/// margin is one).
class CenterOfGravityDetector : public PeakDetector {
 public:
  /// @throw scan_cell_common::InvalidParameter naming the setting that is out of range
  explicit CenterOfGravityDetector(const DetectorSettings& settings);
  void detect(const ImageView8& image, PeakProfile& profile) const override;

 private:
  DetectorSettings settings_;
};

/// "threshold", "center_of_gravity".
const std::vector<std::string>& detector_names();

/// @throw scan_cell_common::InvalidParameter if there is no such detector or a setting is bad
std::unique_ptr<PeakDetector> make_detector(const std::string& name,
                                            const DetectorSettings& settings);

}  // namespace tecnogamma_camera
