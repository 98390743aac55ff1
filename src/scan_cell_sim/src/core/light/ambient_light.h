// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "light/sensor_noise.h"
#include "scan_cell_common/scanner/scanner_model.h"
#include "scan_cell_sim/exposure.h"
#include "scan_cell_sim/scene.h"

namespace scan_cell_sim {

/// The image in ambient light, which makes a calibration board visible: uniform light from all
/// sides, so that brightness is proportional to reflectance. Nothing is added in exposures so short
/// that a white surface would gain less than kMinLevel: invisible light must not slow down scans.
/// Safe to use from several threads at once.
class AmbientLight {
 public:
  static constexpr double kMinLevel = 20;  //!< [grey value] chosen

  AmbientLight(const scan_cell_common::CameraIntrinsics& camera, const Optics& optics);
  ~AmbientLight();

  /// Adds to `pixels` (width x height of the region, row by row).
  void add(const Scene& scene, const Exposure& exposure, const Region& region,
           const SensorNoise& noise, std::uint64_t seed, std::uint8_t* pixels) const;

 private:
  struct Rays;
  class Picture;

  std::shared_ptr<const Rays> rays_of(const Region& region) const;

  scan_cell_common::CameraIntrinsics camera_;
  Optics optics_;
  mutable std::mutex mutex_;                  // of rays_
  mutable std::shared_ptr<const Rays> rays_;  // of the region that was asked for last
};

}  // namespace scan_cell_sim
