// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

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

/// The camera's input and outputs. If both are empty, the camera is left as it is set.
struct Wiring {
  std::string input;    //!< that triggers its frames; empty: it runs free
  std::string outputs;  //!< driven while it grabs, as CameraSettings::strobe_line
  std::string source = tecnogamma_camera::CameraSettings().strobe_source;  //!< of these outputs
};

std::string listed(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

/// The test menu of the acquisition module (thesis, section 3.5).
class Menu {
 public:
  Menu(std::string camera, const std::string& detector, tecnogamma_camera::CameraOptions options,
       Wiring wiring)
      : name_(std::move(camera)),
        detector_(tecnogamma_camera::make_detector(detector, {})),
        options_(std::move(options)),
        wiring_(std::move(wiring)) {}

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
    auto camera = tecnogamma_camera::open_camera(name_, options_);
    if (!wiring_.input.empty() || !wiring_.outputs.empty()) wire(*camera);
    camera_ = std::move(camera);
    std::cout << "connected to " << camera_->describe().id << "\n";
  }

  void wire(Camera& camera) const {
    tecnogamma_camera::CameraSettings settings;
    settings.region = camera.describe().region;
    if (!wiring_.input.empty()) settings.trigger_source = wiring_.input;
    settings.strobe_line = wiring_.outputs;
    settings.strobe_source = wiring_.source;
    camera.configure(settings);
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
              << " s, packets of " << description.packet_size << " bytes\nlines "
              << listed(description.lines) << "; triggered by "
              << listed(description.trigger_sources) << "\n";
  }

  struct StopAtEnd {
    Camera& camera;
    ~StopAtEnd() { camera.stop(); }
  };

  /// Grabs one whole frame and hands it to `use`.
  template <class Use>
  void grab(const Use& use) {
    camera().start(wiring_.input.empty() ? tecnogamma_camera::Trigger::kFreeRun
                                         : tecnogamma_camera::Trigger::kExternal);
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
    throw scan_cell_common::ConnectionError(
        "camera", "no complete frame in five seconds",
        wiring_.input.empty() ? "check its rate and the network"
                              : "pulse " + wiring_.input + ", and check its wire");
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
  Wiring wiring_;
  std::unique_ptr<Camera> camera_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tries a camera by hand, without ROS");
  app.option_defaults()->always_capture_default();
  std::string camera, detector = "fir_derivative";
  tecnogamma_camera::CameraOptions options;
  Wiring wiring;
  options.playback.speed = 0;
  app.add_option("--camera", camera,
                 "id, serial number, address or folder:PATH; without: the only one");
  app.add_option("--payload", options.payload.format,
                 "image, tecnogamma_relief or photonfocus_3d03");
  app.add_option("--detector", detector, "threshold, center_of_gravity or fir_derivative");
  app.add_option("--trigger-source", wiring.input, "input that triggers each frame; without: none");
  app.add_option("--strobe-line", wiring.outputs,
                 "outputs to drive while it grabs, such as Line1,Line2; without: none");
  app.add_option("--strobe-source", wiring.source, "GenICam LineSource of these outputs");
  return scan_cell_common::tool_main("camera_menu", app, argc, argv, [&] {
    Menu(camera, detector, options, wiring).run();
    return 0;
  });
}
