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
  int permanence = 2;    //!< [px] lit pixels in a row that make a rising edge, dark ones a falling
  int window = 0;        //!< [px] most columns of the centre of gravity; 0: from the stripe's width
  double max_width = 0;  //!< [px] of a spot, as in the profile: wider ones are left out
                         //!< before the choice; 0: any width
  Choice choice = Choice::kBrightest;  //!< among several spots in a row
};

/// Describes each setting: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, DetectorSettings& settings);

/// Finds the laser line in a frame. The line runs vertically, with one peak a row.
///
/// Spots (thesis, section 3.2). A pixel above the trigger level is lit. `permanence` consecutive
/// lit pixels make a rising edge, at the first of them; after it, `permanence` consecutive dark
/// pixels make a falling edge, at the first of them. `choice` decides among several spots in a row
/// (reflections). The image's border cuts a spot if no dark pixel lies before its rising edge, or
/// its falling edge is not complete. If the chosen spot is cut, the row has no peak: the spot's
/// middle is not known, and the other spots are more likely reflections.
///
/// Spots wider than `max_width` (shiny objects, lamps) are left out of the choice, cut or not.
///
/// The automatic trigger level is 3.5 standard deviations of the noise above the background, but at
/// least three grey values above it. Noise and background are measured in tiles of the frame
/// (background.h), so the level follows a dark offset and an ambient gradient. A spot also needs
/// the light of 6 standard deviations of its own noise (trigger_levels.h).
///
/// Stripe: the part of the spot around its brightest pixel that is above half of its height over
/// the background. Dips shorter than the permanence, or than a quarter of the stripe's width
/// (speckle), are bridged. The height is not that of one pixel: it is computed, as for a Gaussian
/// stripe, from the mean of the spot's grey values weighted by their light. Half of the height of a
/// saturated stripe therefore comes out a little higher. A stripe is cut if its foot, at 15 % of
/// the height, reaches the image's border. With the automatic level, a row is cut if its stripe is,
/// not if its spot is.
///
/// Hot pixels beside the line are replaced by the mean of their neighbours. In a spot, this is its
/// brightest pixel, if it is four times as far above the background as both neighbours and the rest
/// of the spot lies on one side of it (in a thin line it lies on both); the row is then searched
/// again. With the automatic level, lone lit pixels are replaced, too, if they are no further from
/// the spot than its width and four times as far above the background as the level. Nothing is
/// replaced if a trigger level is given and the detector needs no stripe (threshold).
///
/// Profile. Position: from the detector. Width: between the edges, interpolated between columns, at
/// the trigger level, or at half of the height if the level is automatic. Intensity: brightest
/// pixel.
class PeakDetector {
 public:
  virtual ~PeakDetector() = default;

  /// Writes one element a row of the image. A trigger level above the image's greatest grey value
  /// finds no peak.
  virtual void detect(const GreyImage& image, PeakProfile& profile) const = 0;
};

/// "center_of_gravity", "fir_derivative", "threshold".
const std::vector<std::string>& detector_names();

/// threshold: the middle between the two edges of the width.
///
/// center_of_gravity: of the grey values above the stripe's foot. It covers the stripe and, on each
/// side, 0.4 of its width, which the flanks of a Gaussian stripe need, but not beyond the foot; at
/// most `window` columns, but never less than the stripe. The background is a straight line between
/// the tiles.
///
/// fir_derivative: where the row, smoothed and differentiated by one FIR filter, crosses zero
/// (Forest et al. 2004; fir_derivative.h). The filter's width follows the stripe's, which makes it
/// the maximum likelihood estimate for a Gaussian stripe in white noise.
///
/// @throw scan_cell_common::InvalidParameter if there is no such detector or a setting is bad
std::unique_ptr<PeakDetector> make_detector(const std::string& name,
                                            const DetectorSettings& settings);

}  // namespace tecnogamma_camera
