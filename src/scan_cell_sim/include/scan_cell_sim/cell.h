// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "scan_cell_sim/flange_motion.h"
#include "scan_cell_sim/gige_camera.h"

namespace scan_cell_sim {

/// Contents and addresses of the simulated cell.
struct CellOptions {
  scan_cell_common::ScannerModel scanner;  //!< as it truly is
  Eigen::Isometry3d base_link_in_world =
      Eigen::Isometry3d::Identity();          //!< where the robot truly stands
  Optics optics;                              //!< how bright the lines are
  CameraOptions camera;                       //!< its sensor's size is taken from the scanner
  std::string trigger_address = "127.0.0.1";  //!< IPv4 to listen on for the trigger circuit
  std::uint16_t trigger_port = 5420;          //!< 0: any free one
};

/// The scanner on the robot's flange in its world: each pulse of the trigger circuit makes the
/// camera render the world from the robot's true pose at that instant. All methods are safe to call
/// from any thread.
class Cell {
 public:
  /// @param motion must outlive the cell
  /// @throw as GigeCamera, TriggerCircuit and Scene
  Cell(const CellOptions& options, const World& world, const FlangeMotion& motion);
  ~Cell();

  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  /// A frame as it was truly taken.
  struct TrueExposure {
    scan_cell_common::Nanoseconds time = 0;  //!< host time; the frame's device time
    Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0 in base_link, then

    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  };
  /// Called with each frame that is drawn; sent unless the acquisition ends.
  using Observer = std::function<void(const TrueExposure&)>;

  /// Sets the observer that is called before each frame is sent, in the drawer's thread; none if
  /// empty. When this returns, the previous observer is no longer called.
  void observe(const Observer& observer);

  /// The next frame shows this world.
  /// @throw as Scene; the old world stays
  void set_world(const World& world);

  std::shared_ptr<const Scene> scene() const;                 //!< shown by the next frame
  GigeCamera& camera() { return camera_; }                    //!< the camera on the wire
  TriggerCircuit& circuit() { return circuit_; }              //!< the circuit on the wire
  const TriggerCircuit& circuit() const { return circuit_; }  //!< the circuit on the wire

 private:
  void render(const GigeCamera::Shot& shot, const Region& region, std::uint8_t* pixels);

  const CellOptions options_;
  const FlangeMotion& motion_;
  const LaserLineRenderer renderer_;
  mutable std::mutex mutex_;  // of scene_
  std::shared_ptr<const Scene> scene_;
  std::mutex observer_mutex_;  // held while the observer is called
  Observer observer_;
  TriggerCircuit circuit_;
  GigeCamera camera_;
};

/// Pose of base_link in world, from a cell file (config/cell.yaml).
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
Eigen::Isometry3d load_base_link_in_world(const std::string& path);

}  // namespace scan_cell_sim
