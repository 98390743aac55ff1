// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tecnogamma_camera {

/// A Gaussian stripe's light, and what the sensor adds to it.
struct StripeLight {
  double height = 0;      //!< [grey value] above the background
  double background = 0;  //!< [grey value]
  double noise = 0;       //!< [grey value] standard deviation of a pixel without light
  double shot = 0;        //!< standard deviation of a pixel's light over the root of its grey value
};

/// Least standard deviation [px] of any unbiased estimate of a Gaussian stripe's position
/// (Cramer-Rao bound), with height, sigma and background known.
///
/// A pixel i collects I_i(p) = height * integral over [i - 1/2, i + 1/2] of exp(-(x - p)^2 / (2
/// sigma^2)). With normal noise of variance v_i, the Fisher information of p is sum_i (dI_i/dp)^2 /
/// v_i (Kay, "Fundamentals of Statistical Signal Processing: Estimation Theory", section 3.5; the
/// little that the change of v_i says about p is left out), and dI_i/dp is the difference of the
/// integrand at the pixel's two edges. v_i is noise^2 + shot^2 I_i + 1/12, where rounding to whole
/// grey values counts as white noise of its variance. A pixel that is saturated in 8 bits says
/// nothing. For a wide stripe in white noise the bound is noise / height * sqrt(2 sigma /
/// sqrt(pi)). If height, sigma and background are not known, the bound is the same as long as the
/// pixels lie symmetrically about p: the derivatives with respect to them are even there, and that
/// with respect to p is odd.
double cramer_rao_bound(double position, double sigma, const StripeLight& light);

/// Prints, for each detector, the root mean square error beside the bound, and the bias over the
/// sub-pixel phase. The stripes have several widths and signal-to-noise ratios in white noise, and
/// several heights, up to saturation, in the noise of the simulated camera.
void print_peak_accuracy();

}  // namespace tecnogamma_camera
