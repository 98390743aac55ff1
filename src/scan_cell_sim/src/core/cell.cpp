// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/cell.h"

#include <algorithm>

#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell_sim {

using scan_cell_common::Nanoseconds;

namespace {

CameraOptions on_the_scanners_sensor(CameraOptions options,
                                     const scan_cell_common::ScannerModel& scanner) {
  options.sensor_width = scanner.camera.width;
  options.sensor_height = scanner.camera.height;
  return options;
}

}  // namespace

Cell::Cell(const CellOptions& options, const World& world, const FlangeMotion& motion)
    : options_(options),
      motion_(motion),
      renderer_(options.scanner, options.optics),
      scene_(std::make_shared<const Scene>(world)),
      circuit_(options.trigger_address, options.trigger_port),
      camera_(
          on_the_scanners_sensor(options.camera, options.scanner),
          [this](const GigeCamera::Shot& shot, const Region& region, std::uint8_t* pixels) {
            render(shot, region, pixels);
          },
          [this] { return circuit_.state().lasers; }) {
  circuit_.observe([this](const TriggerCircuit::Pulse& pulse) { camera_.pulse(pulse); });
}

Cell::~Cell() {
  circuit_.observe(nullptr);
}

void Cell::set_world(const World& world) {
  auto scene = std::make_shared<const Scene>(world);
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_ = std::move(scene);
}

std::shared_ptr<const Scene> Cell::scene() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return scene_;
}

void Cell::observe(const Observer& observer) {
  const std::lock_guard<std::mutex> lock(observer_mutex_);
  observer_ = observer;
}

void Cell::render(const GigeCamera::Shot& shot, const Region& region, std::uint8_t* pixels) {
  const TrueExposure truth{shot.time, motion_.flange_at(shot.time)};
  Exposure exposure;
  exposure.camera = options_.base_link_in_world * truth.flange * options_.scanner.flange_to_camera;
  exposure.duration = shot.exposure;
  // An exposure without duration sees what is on at its instant.
  const Nanoseconds length =
      std::max<Nanoseconds>(scan_cell_common::from_seconds(shot.exposure), 1);
  exposure.light = circuit_.lit(shot.time, shot.time + length);
  for (std::size_t laser = 0; laser < exposure.light.size(); ++laser)
    if (exposure.light[laser] > 0)
      exposure.lasers = static_cast<std::uint8_t>(exposure.lasers | 1U << laser);
  exposure.gain = shot.gain;
  exposure.frame = shot.frame;
  renderer_.render(*scene(), exposure, region, pixels);
  const std::lock_guard<std::mutex> lock(observer_mutex_);
  if (observer_) observer_(truth);
}

Eigen::Isometry3d load_base_link_in_world(const std::string& path) {
  return scan_cell_common::YamlEntry::load(path)["base_link_in_world"].pose();
}

}  // namespace scan_cell_sim
