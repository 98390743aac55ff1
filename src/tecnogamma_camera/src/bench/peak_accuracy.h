// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tecnogamma_camera {

/// Least standard deviation [px] that any unbiased estimate of a Gaussian stripe's position can
/// have (Cramer-Rao bound), with height, sigma and background known.
///
/// A pixel i collects I_i(p) = height * integral over [i - 1/2, i + 1/2] of exp(-(x - p)^2 / (2
/// sigma^2)). With white noise of variance v in each pixel, the Fisher information of p is sum_i
/// (dI_i/dp)^2 / v (Kay, "Fundamentals of Statistical Signal Processing: Estimation Theory",
/// section 3.5), and dI_i/dp is the difference of the integrand at the pixel's two edges. v is
/// noise^2 + 1/12, rounding to whole grey values being taken as white noise of its variance. For a
/// wide stripe the bound is noise / height * sqrt(2 sigma / sqrt(pi)). Not knowing height, sigma
/// and background makes no difference to it as long as the pixels lie symmetrically about p, since
/// their derivatives are even there and that of p is odd.
/// @param noise standard deviation of a pixel [grey value]
double cramer_rao_bound(double position, double sigma, double height, double noise);

/// Prints the root mean square error of each detector beside the bound, and its bias over the
/// sub-pixel phase, for stripes of several widths and signal-to-noise ratios.
void print_peak_accuracy();

}  // namespace tecnogamma_camera
