// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner/scanner_model_targets.h"

#include <cmath>

#include "scan_cell_common/scanner/scanner_model.h"

namespace {

using namespace scan_cell_common;
using scan_cell_common::ScannerModel;

const char* const kTwoLasers =
    "camera:\n  width: 1696\n  height: 1710\n  fx: 801.3\n  fy: 800.6\n  cx: 851.2\n  cy: 852.7\n"
    "  distortion: [-0.081, 0.052, 0.0006, -0.0004, 0.0]\n"
    "flange_to_camera:\n  translation: [0.004, -0.003, 0.085]\n"
    "  rotation: [0.006, -0.0045, 0.0075, 0.99994]\n"
    "lasers:\n"
    "  - normal: [0.8, 0, -0.6]\n    distance: -0.2\n    origin: [-0.25, 0.0, 0.0]\n"
    "  - normal: [-0.8, 0, -0.6]\n    distance: -0.2\n    origin: [0.25, 0.0, 0.0]\n";

const char* const kFlow =
    "{camera: {width: 4, height: 3, fx: 5, fy: 5, cx: 1.5, cy: 1, distortion: [0, 0, 0, 0, 0]},\n"
    " flange_to_camera: &p {translation: [0, 0, 0], rotation: [0, 0, 0, 1]},\n"
    " lasers: [{normal: [1, 0, 0], distance: 0.1, origin: [0.1, 0, 0]}]}\n";

/// Expects that a model read keeps every promise of a model.
void expect_usable(const ScannerModel& model) {
  promise(model.camera.width > 0 && model.camera.height > 0, "a sensor");
  promise(model.camera.fx > 0 && std::isfinite(model.camera.fx), "a focal length");
  promise(model.camera.fy > 0 && std::isfinite(model.camera.fy), "a focal length");
  promise(std::isfinite(model.camera.cx + model.camera.cy), "a principal point");
  promise(model.camera.distortion.allFinite(), "a finite distortion");
  const Eigen::Matrix3d rotation = model.flange_to_camera.linear();
  promise((rotation * rotation.transpose()).isIdentity(1e-9), "a rotation");
  promise(model.flange_to_camera.translation().allFinite(), "a place");
  for (std::size_t i = 0; i < model.lasers.size(); ++i) {
    if (!model.has_laser(i)) continue;
    const scan_cell_common::LaserPlane& laser = model.laser(i);
    promise(std::abs(laser.normal.norm() - 1) <= 1e-6, "a unit normal");
    promise(std::isfinite(laser.distance) && laser.distance != 0, "a distance");
    promise(laser.origin.allFinite(), "an origin");
  }
}

}  // namespace

std::vector<FuzzTarget> scanner_model_targets() {
  FuzzTarget target;
  target.name = "scanner_model";
  target.seeds = {kTwoLasers, kFlow};
  target.words = {"camera", "width", "fx",       "distortion", "lasers", "normal", "origin",
                  "[",      "]",     "{",        "}",          "- ",     ": ",     "&p ",
                  "*p",     "<<",    "!!binary", "? ",         "|\n",    "#",      "~",
                  ".nan",   ".inf",  "0x10",     "1e-320",     "1_000",  "\"fx\"", "---\n",
                  "%YAML",  "\t",    "null",     "[[[[[["};
  target.run = [](const std::string& bytes) {
    expect_usable(scan_cell_common::parse_scanner_model(bytes, "scanner.yaml"));
  };
  return {target};
}
