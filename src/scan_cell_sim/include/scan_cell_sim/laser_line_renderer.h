// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"
#include "scan_cell_sim/exposure.h"
#include "scan_cell_sim/scene.h"

namespace scan_cell_sim {

class AmbientLight;
class SensorNoise;

/// Renders the laser lines as the camera sees them. Each fan of light is followed from its
/// projector to the first surface; the lit point is drawn where the lens projects it, if nothing is
/// between it and the camera. In each image row a line is centred on its exact sub-pixel column.
/// Ambient light is added below the lines. The same frame number gives the same image. Safe to use
/// from several threads at once.
class LaserLineRenderer {
 public:
  /// @param scanner as it truly is
  LaserLineRenderer(const scan_cell_common::ScannerModel& scanner, const Optics& optics);

  /// Fills `pixels` (width x height of the region, row by row).
  void render(const Scene& scene, const Exposure& exposure, const Region& region,
              std::uint8_t* pixels) const;

  const scan_cell_common::ScannerModel& scanner() const { return scanner_; }  //!< as it truly is

 private:
  /// Fan of one laser: directions axis + t * across, where t is the tangent of the angle in the
  /// fan.
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
  std::pair<double, double> reach(const Fan& fan, const Region& region) const;

  scan_cell_common::ScannerModel scanner_;
  Optics optics_;
  std::shared_ptr<const SensorNoise> noise_;
  std::shared_ptr<const AmbientLight> ambient_;
  std::vector<Fan> fans_;
};

}  // namespace scan_cell_sim
