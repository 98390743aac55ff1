// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "scan_cell_sim/scene.h"
#include "scanner_views/draws.h"
#include "tool_path_stretcher/similarity.h"

namespace scanner_views {

using tool_path_stretcher::Points;

/// A camera that looks along z, with y along the lines, and a laser on either side along x whose
/// sheet of light crosses the camera's axis. About the scanner of the simulated cell
/// (scan_cell_sim's scanner.yaml), without its lens.
struct Scanner {
  double stand_off = 0.5;     //!< [m] from the camera to where the sheets cross its axis
  double baseline = 0.25;     //!< [m] from the camera to each laser
  double focal_length = 800;  //!< [px]
  /// [m] of a sheet of light on the surface: a line 1 mm wide (1/e^2), usual for a depth of field
  /// of 0.2 m
  double stripe_sigma = 0.00025;
  /// [px] of a stripe in full light: the bound at 40 times the noise (docs/tecnogamma_camera.md).
  /// The simulator's stripe is 300 x 0.7 grey values high, with 5.2 of noise.
  double peak_noise = 0.05;
  /// Speckle contrast of each part of a spot: 0.71 on a surface that depolarises (Goodman 2007),
  /// less because the scanner moves during the exposure
  double speckle = 0.5;
  /// [px] two stripes this near make one peak: two sigmas of the simulator's stripe, 2.2 px
  double window = 4.4;
  /// Share of full light below which there is no peak: trigger level 60 of 210 grey values, 73
  /// degrees
  double least_light = 0.29;
  double line_spacing = 0.0012;   //!< [m] along x
  double point_spacing = 0.0003;  //!< [m] along a line, at the stand-off
};

/// One sweep of the scanner over a scene.
struct Sweep {
  Eigen::Matrix3d head = Eigen::Matrix3d::Identity();  //!< scanner's axes in the world: x along the
                                                       //!< sweep, z along the camera's view
  Eigen::AlignedBox3d extent;                          //!< [m] of the scanned region, in these axes
  bool second_laser = false;                           //!< use both lasers, not only the first
  std::uint8_t number = 0;                             //!< pass number of its points
};

/// Points as from laser_triangulation.
struct ScanPoints {
  Points places;                     //!< [m]
  Points seen_from;                  //!< [m] camera position for each point
  std::vector<std::uint8_t> lasers;  //!< 0, 1
  std::vector<std::uint8_t> passes;  //!< number of the sweep
  std::vector<unsigned> surfaces;  //!< of the scene, from which most light came: for the truth only
};

/// Traces each sheet of light from its source to the first surface, and from there to the camera,
/// with the shadows of both. A spot is as large as the light is thick. If it lies on two surfaces,
/// or only partly in the light, the stripe's centre lies between or beside them (mixed points). The
/// centre's noise grows as the light decreases, and speckle weights the parts of a spot.
class LineScanner {
 public:
  /// @param scene must outlive it
  LineScanner(const scan_cell_sim::Scene& scene, const Scanner& scanner)
      : scene_(scene), scanner_(scanner) {}

  /// Appends the sweep's points. A wide extent takes several strips side by side.
  void scan(const Sweep& sweep, Draws& draws, ScanPoints& points) const;

 private:
  struct Exposure;
  struct Spot;
  struct Strip;

  void follow(const Strip& strip, Draws& draws, ScanPoints& points) const;

  Spot spot(const Exposure& exposure, double tangent, double offset) const;
  void measure(const Exposure& exposure, double tangent, Draws& draws, ScanPoints& points) const;

  const scan_cell_sim::Scene& scene_;
  const Scanner scanner_;
};

}  // namespace scanner_views
