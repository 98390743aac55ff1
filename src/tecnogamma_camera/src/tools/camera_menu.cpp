// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "open_camera.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tecnogamma_camera/peak_detector.h"
#include "tecnogamma_camera/peak_file.h"

namespace {

using tecnogamma_camera::Camera;
using tecnogamma_camera::Frame;

constexpr const char* kMenu = R"(
1. Scan for cameras
2. Connect
3. Camera info
4. Grab an image
5. Grab peaks
6. Exit
> )";

/// The test menu of the acquisition module (thesis, section 3.5).
class Menu {
 public:
  Menu(std::string camera, const std::string& detector, tecnogamma_camera::CameraOptions options)
      : name_(std::move(camera)),
        detector_(tecnogamma_camera::make_detector(detector, {})),
        options_(std::move(options)) {}

  void run() {
    std::string choice;
    while (std::cout << kMenu << std::flush, std::getline(std::cin, choice) && choice != "6") {
      try {
        choose(choice);
      } catch (const scan_cell_common::Error& error) {
        std::cout << error.what() << "\n";
      }
    }
  }

 private:
  void choose(const std::string& choice) {
    if (choice == "1") return scan();
    if (choice == "2") return connect();
    if (choice == "3") return info();
    if (choice == "4") return grab_image();
    if (choice == "5") return grab_peaks();
    std::cout << "give a number from 1 to 6\n";
  }

  void scan() {
    const auto cameras = tecnogamma_camera::list_aravis_cameras();
    std::cout << cameras.size() << (cameras.size() == 1 ? " camera\n" : " cameras\n");
    for (const auto& camera : cameras) {
      std::cout << "  " << camera.id << "  " << camera.vendor << " " << camera.model << ", serial "
                << camera.serial << ", " << camera.transport << " at " << camera.address << "\n";
    }
  }

  void connect() {
    camera_.reset();
    camera_ = tecnogamma_camera::open_camera(name_, options_);
    std::cout << "connected to " << camera_->describe().id << "\n";
  }

  Camera& camera() {
    if (!camera_) throw scan_cell_common::Refused("camera", "not connected", "connect (2) first");
    return *camera_;
  }

  void info() {
    const auto description = camera().describe();
    const auto& region = description.region;
    std::cout << description.vendor << " " << description.model << ", serial " << description.serial
              << ", " << description.transport << "\nsensor " << description.sensor_columns << " x "
              << description.sensor_rows << ", region " << region.width << " x " << region.height
              << " at " << region.x << ", " << region.y << "\nexposure " << description.exposure
              << " s, packets of " << description.packet_size << " bytes\n";
  }

  struct StopAtEnd {
    Camera& camera;
    ~StopAtEnd() { camera.stop(); }
  };

  /// Grabs one whole frame in free run and hands it to `use`.
  template <class Use>
  void grab(const Use& use) {
    camera().start(tecnogamma_camera::Trigger::kFreeRun);
    const StopAtEnd stop{camera()};
    constexpr int kTries = 5;  // of a second each; chosen
    for (int i = 0; i < kTries; ++i) {
      const auto frame = camera().grab(std::chrono::seconds(1));
      if (!frame || frame->packets_lost > 0) continue;
      if (!frame->fault.empty()) {
        throw scan_cell_common::UnusableInput("frame", frame->fault, "check payload and camera");
      }
      return use(*frame);
    }
    throw scan_cell_common::ConnectionError("camera", "no complete frame in five seconds",
                                            "check its rate and the network");
  }

  void grab_image() {
    grab([](const Frame& frame) {
      const auto& image = frame.image;
      if (!image.pixels) {
        throw scan_cell_common::UnusableInput("frame", "peaks without an image",
                                              "set the camera to send images, or grab peaks");
      }
      const cv::Mat pixels(image.rows, image.columns,
                           image.bytes_per_pixel() == 2 ? CV_16UC1 : CV_8UC1,
                           const_cast<void*>(image.pixels),
                           static_cast<std::size_t>(image.stride * image.bytes_per_pixel()));
      constexpr const char* kPath = "image.png";
      if (!cv::imwrite(kPath, pixels)) {
        throw scan_cell_common::FileError(kPath, "cannot be written",
                                          "run this in a folder you can write to");
      }
      std::cout << "frame " << frame.counter << " at " << frame.device_time
                << " ns: " << image.columns << " x " << image.rows << " pixels in " << kPath
                << "\n";
    });
  }

  void grab_peaks() {
    grab([this](const Frame& frame) {
      tecnogamma_camera::PeakProfile profile;
      if (frame.peaks) {
        profile = *frame.peaks;
      } else {
        detector_->detect(frame.image, profile);
      }
      int peaks = 0;
      for (const float position : profile.position)
        peaks += std::isnan(position) ? 0 : 1;
      constexpr const char* kPath = "peaks.csv";
      tecnogamma_camera::save_peaks(kPath, profile);
      std::cout << "frame " << frame.counter << " at " << frame.device_time << " ns: " << peaks
                << " peaks in " << profile.rows() << " rows in " << kPath << "\n";
    });
  }

  std::string name_;
  std::unique_ptr<tecnogamma_camera::PeakDetector> detector_;
  tecnogamma_camera::CameraOptions options_;
  std::unique_ptr<Camera> camera_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tries a camera by hand, without ROS");
  app.option_defaults()->always_capture_default();
  std::string camera, detector = "fir_derivative";
  tecnogamma_camera::CameraOptions options;
  options.playback.speed = 0;
  app.add_option("--camera", camera,
                 "id, serial number, address or folder:PATH; without: the only one");
  app.add_option("--payload", options.payload.format,
                 "image, tecnogamma_relief or photonfocus_3d03");
  app.add_option("--detector", detector, "threshold, center_of_gravity or fir_derivative");
  return scan_cell_common::tool_main("camera_menu", app, argc, argv, [&] {
    Menu(camera, detector, options).run();
    return 0;
  });
}
