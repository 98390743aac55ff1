// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tecnogamma_camera/image_view.h"
#include "tecnogamma_camera/peak_profile.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace tecnogamma_camera {

/// Which of several spots in a row is the laser's.
enum class Choice {
  kBrightest,  //!< greatest sum of the grey values above the trigger level, the leftmost of equals
  kFirst,      //!< the leftmost
  kLast        //!< the rightmost
};

/// "brightest", "first", "last": of the values of Choice, in their order.
const std::vector<std::string>& choice_names();

/// @throw scan_cell_common::InvalidParameter if it is none of choice_names()
Choice choice_of(const std::string& name);

/// A trigger level that is determined in each frame.
constexpr int kAutomaticLevel = -1;  //!< chosen: not a grey value

/// How a detector finds the laser's spot in a row.
struct DetectorSettings {
  /// [grey value] of the image's own pixels, 0 .. 65535: a pixel above it is lit. kAutomaticLevel:
  /// found in each frame.
  int trigger_level = kAutomaticLevel;
  int permanence = 2;  //!< [px] lit pixels in a row that make a rising edge, dark ones a falling
  int window = 0;  //!< [px] most columns of the centre of gravity; 0: as the stripe's width asks
  double max_width = 0;  //!< [px] of a spot, as the profile tells it: wider ones are passed over
                         //!< before the choice; 0: any width
  Choice choice = Choice::kBrightest;  //!< among several spots in a row
};

/// With range, unit and meaning of each.
void describe(scan_cell_common::ParameterTable& table, DetectorSettings& settings);

/// Finds the laser line in a frame: it runs vertically, with one peak a row.
///
/// Spots (thesis, section 3.2). A pixel is lit above the trigger level. `permanence` consecutive
/// lit pixels are a rising edge, which stands at the first of them; after it, `permanence`
/// consecutive dark pixels are a falling edge, which stands at the first of them. Among several
/// spots in a row (reflections) `choice` decides. A spot is cut by the image's border where no dark
/// pixel lies before its rising edge, or its falling edge is not complete: where a cut spot is
/// chosen, the row has no peak, since its middle is not known and the other spots are more likely
/// reflections.
///
/// Spots wider than `max_width` (shiny objects, lamps) are left out of the choice, cut or not.
///
/// The automatic trigger level is 3.5 standard deviations of the noise above the background, both
/// measured in tiles of the frame (background.h), so that it follows a dark offset and an ambient
/// gradient, but at least three grey values above it; and a spot needs the light of 6 standard
/// deviations of its own noise (trigger_levels.h).
///
/// Stripe. What lies above half of its height over the background, about the brightest pixel of the
/// spot; dips in it are bridged that are shorter than the permanence, or than a quarter of its
/// width (speckle). Its height is not that of one pixel: it is told from the mean of the spot's
/// grey values, weighted by their light, as that of a Gaussian stripe; so half of the height of a
/// saturated one is counted a little higher. Where its foot, 15 % of the height, reaches the
/// image's border, it is cut. With the automatic level it is the stripe, and not the spot, that the
/// border cuts.
///
/// Hot pixels beside the line become the mean of their neighbours. In a spot: its brightest pixel,
/// where it stands out of both neighbours four times as far above the background, and the rest of
/// the spot lies on one side of it (in a thin line it lies on both); the row is looked at again.
/// With the automatic level also lone lit pixels, no further from the spot than its width, that are
/// four times as far above the background as the level. Not where a trigger level is given and the
/// detector needs no stripe (threshold).
///
/// Profile. Position: by the detector. Width: between the edges at the trigger level, or where that
/// is automatic at half of the height, interpolated between columns. Intensity: brightest pixel.
class PeakDetector {
 public:
  virtual ~PeakDetector() = default;

  /// Writes one element a row of the image. A trigger level above the image's greatest grey value
  /// finds no peak.
  virtual void detect(const GreyImage& image, PeakProfile& profile) const = 0;
};

/// "center_of_gravity", "fir_derivative", "threshold".
const std::vector<std::string>& detector_names();

/// threshold: the middle between the edges that make the width.
///
/// center_of_gravity: that of the grey values above the stripe's foot, over the stripe and as much
/// on each side as the flanks of a Gaussian one need (0.4 of its width), to where they reach the
/// foot; at most `window` columns, but never less than the stripe. The background is a straight
/// line between the tiles.
///
/// fir_derivative: where the row, smoothed and differentiated by one FIR filter, crosses zero
/// (Forest et al. 2004; fir_derivative.h). The filter's width follows the stripe's, which makes it
/// the maximum likelihood estimate for a Gaussian stripe in white noise.
///
/// @throw scan_cell_common::InvalidParameter if there is no such detector or a setting is bad
std::unique_ptr<PeakDetector> make_detector(const std::string& name,
                                            const DetectorSettings& settings);

}  // namespace tecnogamma_camera
