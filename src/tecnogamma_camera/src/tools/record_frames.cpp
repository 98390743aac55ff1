// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <condition_variable>
#include <cstdio>
#include <mutex>

#include "acquisition/acquisition.h"
#include "open_camera.h"
#include "recording/folder_recorder.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using tecnogamma_camera::AcquisitionMode;
using tecnogamma_camera::NumberedFrame;
using tecnogamma_camera::Trigger;

struct Options {
  std::string camera;
  std::string output;
  std::uint64_t frames = 100;
  bool external = false;
  bool payload = false;
  tecnogamma_camera::AcquisitionParameters acquisition;
};

/// Writes the frames of the acquisition until there are enough of them or something fails.
class Writer : public tecnogamma_camera::AcquisitionListener {
 public:
  explicit Writer(const Options& options) : recorder_(options.output), wanted_(options.frames) {}

  void on_frame(const NumberedFrame& frame) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (done_) return;
    try {
      recorder_.add(frame);
      if (recorder_.frames() == wanted_) done_ = true;
    } catch (...) {
      failure_ = std::current_exception();
      done_ = true;
    }
    changed_.notify_all();
  }
  void on_connected(const tecnogamma_camera::CameraDescription& camera) override {
    std::fprintf(stderr, "recording %s\n", camera.id.c_str());
  }
  void on_ended(const std::string&) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
    changed_.notify_all();
  }
  void on_trouble(const std::string& reason) override {
    std::fprintf(stderr, "%s\n", reason.c_str());
  }

  /// Waits until there are enough frames, the camera is lost, or the user ends it.
  void wait(const tecnogamma_camera::Acquisition& acquisition) {
    std::unique_lock<std::mutex> lock(mutex_);
    constexpr std::chrono::milliseconds kLook(100);  // [ms] chosen
    while (!done_ && !scan_cell_common::CatchInterrupts::interrupted()) {
      changed_.wait_for(lock, kLook);
      const auto state = acquisition.state();
      if (done_ || state.times_lost == 0) continue;
      done_ = true;
      failure_ = std::make_exception_ptr(scan_cell_common::ConnectionError(
          "camera", fmt::format("lost after {} frames, which are kept", recorder_.frames()),
          state.message));
    }
    done_ = true;
  }

  /// @return how many frames were written
  std::uint64_t finish() {
    if (recorder_.frames() > 0) recorder_.finish();
    if (failure_) std::rethrow_exception(failure_);
    return recorder_.frames();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  tecnogamma_camera::FolderRecorder recorder_;
  std::uint64_t wanted_;
  bool done_ = false;
  std::exception_ptr failure_;
};

void record(const Options& options) {
  tecnogamma_camera::CameraOptions source;
  source.stream.is_payload = options.payload;
  source.playback.speed = 0;
  Writer writer(options);
  tecnogamma_camera::Acquisition acquisition(
      options.acquisition, [&] { return tecnogamma_camera::open_camera(options.camera, source); },
      writer);
  acquisition.set(AcquisitionMode::kReliefOnly,
                  options.external ? Trigger::kExternal : Trigger::kFreeRun);
  writer.wait(acquisition);
  const std::uint64_t written = writer.finish();  // first: the camera may be gone
  acquisition.set(AcquisitionMode::kStop, Trigger::kFreeRun);
  const auto counts = acquisition.state().frames;
  std::printf("%llu frames in %s, %llu lost, %llu incomplete\n",
              static_cast<unsigned long long>(written), options.output.c_str(),
              static_cast<unsigned long long>(counts.lost),
              static_cast<unsigned long long>(counts.incomplete));
}

}  // namespace

/// Records the frames of a camera, or the payloads it sends, into a folder. Exits 0, or 1 with the
/// reason.
int main(int argc, char** argv) {
  CLI::App app("Records frames into a folder that the camera node plays (camera folder:PATH)");
  app.option_defaults()->always_capture_default();
  Options options;
  auto& settings = options.acquisition.camera;
  app.add_option("--camera", options.camera,
                 "id, serial number or address; without: the only one that answers");
  app.add_option("--output", options.output, "a new folder")->required();
  app.add_option("--frames", options.frames, "how many; Ctrl-C ends the recording earlier")
      ->check(CLI::PositiveNumber);
  app.add_flag("--external", options.external, "one frame per pulse instead of free run");
  app.add_option("--trigger-source", settings.trigger_source, "of --external");
  app.add_flag("--payload", options.payload,
               "record the raw bytes of a camera that finds the peaks itself");
  app.add_option("--pixel-format", settings.pixel_format, "GenICam PixelFormat of grey values");
  app.add_option("--rate", settings.rate, "[Hz] of free run")->always_capture_default(false);
  app.add_option("--exposure", settings.exposure, "[s]")->always_capture_default(false);
  app.add_option("--region-x", settings.region.x, "[px]");
  app.add_option("--region-y", settings.region.y, "[px]");
  app.add_option("--region-width", settings.region.width, "[px] 0: to the sensor's edge");
  app.add_option("--region-height", settings.region.height, "[px] 0: to the sensor's edge");
  const scan_cell_common::CatchInterrupts catch_interrupts;
  return scan_cell_common::tool_main("record_frames", app, argc, argv, [&] {
    record(options);
    return 0;
  });
}
