// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_sim/laser_line_renderer.h"

namespace {

using namespace scan_cell_sim;

constexpr int kFrames = 300;  // chosen

/// Mean time of a call [s].
template <class Call>
double seconds(int calls, const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i)
    call(i);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return time.count() / calls;
}

/// One image buffer, and what copying it costs.
struct Buffer {
  explicit Buffer(const Region& part) : region(part) {
    pixels.resize(static_cast<std::size_t>(region.width * region.height));
    std::vector<std::uint8_t> copy(pixels.size());
    plain = seconds(kFrames, [&](int frame) {
      pixels[0] = static_cast<std::uint8_t>(frame);
      std::memcpy(copy.data(), pixels.data(), pixels.size());
    });
  }

  void print(const char* what, double time) const {
    std::printf("render %d x %d, %s: %.3f ms a frame; copying it: %.3f ms; ratio %.1f\n",
                region.width, region.height, what, time * 1e3, plain * 1e3, time / plain);
  }

  Region region;
  std::vector<std::uint8_t> pixels;
  double plain = 0;  // [s]
};

Exposure from_above() {
  Exposure exposure;
  exposure.camera.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  exposure.camera.translation() << 0, 0, 0.5;
  return exposure;
}

/// Times the frames of a scan.
void time_lines(const LaserLineRenderer& renderer, const std::string& world) {
  const Scene scene(load_world(world));
  Buffer buffer(Region{336, 599, 1024, 512});
  Exposure exposure = from_above();
  for (const std::uint8_t lasers : {1, 3}) {
    exposure.lasers = lasers;
    const double time = seconds(kFrames, [&](int frame) {
      exposure.camera.translation().x() = -0.14 + 0.28 * frame / kFrames;
      exposure.frame = static_cast<std::uint64_t>(frame);
      renderer.render(scene, exposure, buffer.region, buffer.pixels.data());
    });
    buffer.print(lasers == 1 ? "1 laser" : "2 lasers", time);
  }
}

/// Times full images of a board in ambient light; the first one prepares the rays for the others.
void time_images(const LaserLineRenderer& renderer, const std::string& world) {
  constexpr int kImages = 10;  // chosen
  const Scene scene(load_world(world));
  Buffer buffer(Region{0, 0, 1696, 1710});
  Exposure exposure = from_above();
  exposure.duration = 0.03;  // [s] chosen
  const auto render = [&](int frame) {
    exposure.frame = static_cast<std::uint64_t>(frame);
    renderer.render(scene, exposure, buffer.region, buffer.pixels.data());
  };
  buffer.print("first image of a lit board", seconds(1, render));
  buffer.print("lit board", seconds(kImages, render));
}

}  // namespace

int main(int argc, char** argv) {
  std::string config = CONFIG_FOLDER;
  CLI::App app("What rendering a frame costs beside one plain copy of a frame, in the same run");
  app.add_option("config", config, "folder of scanner.yaml and the worlds")->capture_default_str();
  return scan_cell_common::tool_main("bench_scan_cell_sim", app, argc, argv, [&] {
    const LaserLineRenderer renderer(scan_cell_common::load_scanner_model(config + "/scanner.yaml"),
                                     Optics{});
    time_lines(renderer, config + "/object_frame.yaml");
    time_images(renderer, config + "/calibration_board.yaml");
    return 0;
  });
}
