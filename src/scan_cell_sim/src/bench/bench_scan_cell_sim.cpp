// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <chrono>
#include <cstdio>
#include <cstring>

#include "scan_cell_sim/laser_line_renderer.h"

namespace {

using namespace scan_cell_sim;

constexpr int kFrames = 300;

/// Median-free and plain: seconds a call, over kFrames calls.
template <class Call>
double seconds(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 0; frame < kFrames; ++frame)
    call(frame);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return time.count() / kFrames;
}

}  // namespace

/// Prints what rendering a frame costs beside one plain copy of a frame, in the same run.
int main(int argc, char** argv) {
  const std::string config = argc > 1 ? argv[1] : CONFIG_FOLDER;
  const LaserLineRenderer renderer(
      laser_triangulation::load_scanner_model(config + "/scanner.yaml"), Optics{});
  const Scene scene(load_world(config + "/object_frame.yaml"));
  const Region region = {336, 599, 1024, 512};
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(region.width * region.height));
  std::vector<std::uint8_t> copy(pixels.size());

  Exposure exposure;
  exposure.camera.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto render = [&](int frame) {
    exposure.camera.translation() << -0.14 + 0.28 * frame / kFrames, 0, 0.5;
    exposure.frame = static_cast<std::uint64_t>(frame);
    renderer.render(scene, exposure, region, pixels.data());
  };
  const double plain = seconds([&](int frame) {
    pixels[0] = static_cast<std::uint8_t>(frame);
    std::memcpy(copy.data(), pixels.data(), pixels.size());
  });
  for (const std::uint8_t lasers : {1, 3}) {
    exposure.lasers = lasers;
    const double time = seconds(render);
    std::printf(
        "render 1024 x 512, %d laser(s): %.3f ms a frame; copying it: %.3f ms; ratio %.1f\n",
        lasers == 1 ? 1 : 2, time * 1e3, plain * 1e3, time / plain);
  }
}
