// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "laser_triangulation/scanner_model.h"
#include "scan_cell_sim/scene.h"

namespace scan_cell_sim {

/// Part of the sensor that is read out [px].
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// How light becomes grey values.
struct Optics {
  double stripe_sigma = 2.2;  //!< [px] Gaussian cross-section of the line on the sensor
  /// [grey value] peak on a white surface 0.5 m from the projector, met head on, at `exposure`
  double brightness = 300;
  double exposure = 0.001;   //!< [s] that `brightness` is meant for
  double background = 6;     //!< [grey value] ambient light and dark level
  double read_noise = 1.2;   //!< [grey value] standard deviation
  double shot_noise = 0.35;  //!< standard deviation over the root of the stripe's grey value
  std::uint64_t seed = 1;
};

/// What the camera looks at in one frame.
struct Exposure {
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();  //!< camera_optical_frame in world
  std::uint8_t lasers = 0;                                   //!< bit mask: 1 laser_0, 2 laser_1
  double duration = 0.001;                                   //!< [s]
  double gain = 1;                                           //!< factor
  std::uint64_t frame = 0;                                   //!< number that seeds the noise
};

/// Renders the laser lines as the camera sees them: each fan of light is followed from its
/// projector to the first surface, and what is lit there is drawn where the lens puts it, if
/// nothing stands between it and the camera. In each image row a line is centred on its exact
/// sub-pixel column. The same frame number gives the same image. Safe to use from several threads
/// at once.
class LaserLineRenderer {
 public:
  LaserLineRenderer(const laser_triangulation::ScannerModel& scanner, const Optics& optics);

  /// Fills `pixels` (width x height of the region, row by row).
  void render(const Scene& scene, const Exposure& exposure, const Region& region,
              std::uint8_t* pixels) const;

  const laser_triangulation::ScannerModel& scanner() const { return scanner_; }

 private:
  /// Fan of one laser: directions axis + t * across, t being the tangent of the angle in the fan.
  struct Fan {
    Eigen::Vector3d origin, axis, across;  // in camera_optical_frame
  };
  struct Spot;
  struct Drawing;

  Spot spot(const Drawing& drawing, const Fan& fan, double tangent) const;
  void connect(const Drawing& drawing, const Fan& fan, const Spot& from, const Spot& to,
               int depth) const;
  void draw(const Drawing& drawing, const Spot& from, const Spot& to) const;
  void draw_row(const Drawing& drawing, int row, double column, double sigma, double peak) const;
  void fill_background(const Drawing& drawing) const;
  std::pair<double, double> reach(const Fan& fan, const Region& region) const;

  laser_triangulation::ScannerModel scanner_;
  Optics optics_;
  std::vector<Fan> fans_;
  std::vector<std::uint8_t> dark_;  // background with read noise, drawn from at random offsets
  std::vector<float> unit_noise_;   // standard normal
};

}  // namespace scan_cell_sim
