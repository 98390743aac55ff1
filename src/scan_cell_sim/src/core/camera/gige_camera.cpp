// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/gige_camera.h"

#include <arv.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <fstream>
#include <mutex>
#include <random>
#include <thread>

#include "camera/frame_drawer.h"
#include "camera/frame_sender.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {
namespace {

using gige::ControlServer;
using gige::FrameSender;
using scan_cell_common::from_seconds;
using scan_cell_common::host_now;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;

/// The counter starts where that of Aravis' own fake camera does, so that it wraps soon.
constexpr std::uint16_t kFirstBlock = 65400;  // as in Aravis

/// 16 bits without 0.
std::uint16_t block_of(std::uint64_t frame) {
  constexpr std::uint64_t kBlocks = 65535;  // GVSP: 16 bits without 0
  return static_cast<std::uint16_t>((kFirstBlock + frame - 2) % kBlocks + 1);
}

void check(const CameraOptions& options) {
  const Region& r = options.region;
  if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.width > options.sensor_width - r.x ||
      r.height > options.sensor_height - r.y) {
    throw InvalidParameter(
        "camera region", fmt::format("{} x {} at {}, {}", r.width, r.height, r.x, r.y),
        fmt::format("the sensor has {} x {} pixels", options.sensor_width, options.sensor_height));
  }
  if (!(options.wire_rate > 0)) {
    throw InvalidParameter("camera wire rate", fmt::format("{:g} bytes/s", options.wire_rate),
                           "give a rate above 0");
  }
  if (!std::ifstream(options.genicam_file)) {
    throw scan_cell_common::FileError(options.genicam_file, "cannot be read",
                                      "give the path of gige_camera.xml");
  }
}

void power_up(ControlServer& server, const CameraOptions& options) {
  const auto set = [&server](std::uint32_t address, int value) {
    server.set_register(address, static_cast<std::uint32_t>(value));
  };
  constexpr int kExposure = 1000;  // [us] chosen
  set(ARV_FAKE_CAMERA_REGISTER_SENSOR_WIDTH, options.sensor_width);
  set(ARV_FAKE_CAMERA_REGISTER_SENSOR_HEIGHT, options.sensor_height);
  set(ARV_FAKE_CAMERA_REGISTER_WIDTH, options.region.width);
  set(ARV_FAKE_CAMERA_REGISTER_HEIGHT, options.region.height);
  set(ARV_FAKE_CAMERA_REGISTER_X_OFFSET, options.region.x);
  set(ARV_FAKE_CAMERA_REGISTER_Y_OFFSET, options.region.y);
  set(ARV_FAKE_CAMERA_REGISTER_EXPOSURE_TIME_US, kExposure);
}

/// Wakes a thread that waits in poll().
class Bell {
 public:
  Bell() : handle_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

  int handle() const { return handle_.number(); }
  void ring() const { eventfd_write(handle(), 1); }
  void quiet() const {
    eventfd_t value = 0;
    eventfd_read(handle(), &value);
  }

 private:
  scan_cell_common::Descriptor handle_;
};

}  // namespace

/// Pulses arrive in any thread; the camera's own thread answers its client and sends, while the
/// drawer's thread draws the next frame.
class GigeCamera::Implementation {
 public:
  Implementation(const CameraOptions& options, Render render,
                 std::function<std::uint8_t()> lasers_now)
      : options_(options), render_(std::move(render)), lasers_now_(std::move(lasers_now)) {
    check(options_);
    set_power(true);
  }

  ~Implementation() { set_power(false); }

  void pulse(const TriggerCircuit::Pulse& pulse) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.pulses;
    if (!waits_for_pulses_) {
      ++counts_.ignored;
      return;
    }
    if (pulse.time - last_pulse_ < from_seconds(options_.min_period)) {
      ++counts_.too_soon;
      return;
    }
    if (pending_.size() >= static_cast<std::size_t>(options_.max_pending)) {
      ++counts_.queue_full;
      return;
    }
    last_pulse_ = pulse.time;
    Shot shot;
    shot.time = pulse.time;
    shot.lasers = pulse.lasers;
    shot.frame = ++frames_;
    if (std::uniform_real_distribution<double>()(random_) < faults_.lost_frames) {
      ++counts_.lost_on_purpose;
      return;
    }
    pending_.push_back(shot);
    bell_.ring();
  }

  void set_faults(const CameraFaults& faults) {
    const std::lock_guard<std::mutex> lock(mutex_);
    faults_ = faults;
    random_.seed(faults.seed);
  }

  void set_power(bool on) {
    const std::lock_guard<std::mutex> power_lock(power_mutex_);
    if (on == powered_) return;
    if (on) {
      auto server =
          std::make_unique<ControlServer>(options_.address, options_.serial, options_.genicam_file);
      power_up(*server, options_);
      auto sender = std::make_unique<FrameSender>(options_.address, options_.wire_rate);
      frames_ = 0;
      powered_ = true;
      thread_ = std::thread([this, s = std::move(server), f = std::move(sender)] { run(*s, *f); });
    } else {
      powered_ = false;
      bell_.ring();
      thread_.join();
    }
  }

  bool has_power() const { return powered_; }

  Counts counts() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
  }

 private:
  void run(ControlServer& server, FrameSender& sender) {
    FrameDrawer drawer(render_, [this] { bell_.ring(); });
    Nanoseconds next_free = 0;  // frame of the free run
    while (powered_) {
      const Nanoseconds now = host_now();
      server.serve(now, [&sender](const auto& request) { sender.request(request); });
      follow(server, drawer, sender);
      if (!sender.busy()) {
        if (std::optional<gige::Frame> frame = drawer.take()) {
          sender.begin(std::move(*frame), server.packet_size(), count_frame());
        }
      }
      if (drawer.idle()) {
        if (const std::optional<Shot> shot = next_shot(server, now, next_free)) {
          expose(*shot, server, drawer, sender.spare_pixels());
        }
      }
      if (sender.busy()) sender.send(host_now(), server.stream_peer());
      Nanoseconds until = now + kIdle;
      if (sender.busy()) until = sender.next();
      if (drawer.idle()) until = std::min(until, next_exposed(server, now, next_free));
      wait(server, until);
    }
    stop(drawer, sender);
  }

  /// Frames of an acquisition that has ended are not sent in the next.
  void follow(const ControlServer& server, FrameDrawer& drawer, FrameSender& sender) {
    if (!server.acquires()) stop(drawer, sender);
    const std::lock_guard<std::mutex> lock(mutex_);
    waits_for_pulses_ = server.acquires() && server.in_trigger_mode() && server.triggered_by_line();
  }

  void stop(FrameDrawer& drawer, FrameSender& sender) {
    sender.abort();
    const bool dropped = drawer.drop();
    const std::lock_guard<std::mutex> lock(mutex_);
    waits_for_pulses_ = false;
    counts_.discarded += pending_.size() + (dropped ? 1 : 0);
    pending_.clear();
    last_pulse_ = 0;
  }

  std::optional<Shot> next_shot(ControlServer& server, Nanoseconds now, Nanoseconds& next_free) {
    if (!server.acquires()) return std::nullopt;
    if (!server.in_trigger_mode()) {
      if (now < next_free) return std::nullopt;
      const Nanoseconds period = from_seconds(server.period());
      next_free = std::max(next_free + period, now);
      return shot_now();
    }
    if (server.take_software_trigger()) return shot_now();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (pending_.empty() || now < end_of_exposure(pending_.front(), server)) return std::nullopt;
    const Shot shot = pending_.front();
    pending_.pop_front();
    return shot;
  }

  static Nanoseconds end_of_exposure(const Shot& shot, const ControlServer& server) {
    return shot.time + from_seconds(server.exposure());
  }

  /// When the exposure of the next frame ends.
  Nanoseconds next_exposed(const ControlServer& server, Nanoseconds now,
                           Nanoseconds next_free) const {
    if (server.acquires() && !server.in_trigger_mode()) return next_free;
    const std::lock_guard<std::mutex> lock(mutex_);
    return pending_.empty() ? now + kIdle : end_of_exposure(pending_.front(), server);
  }

  Shot shot_now() {
    Shot shot;
    shot.time = host_now();
    shot.lasers = lasers_now_();
    const std::lock_guard<std::mutex> lock(mutex_);
    shot.frame = ++frames_;
    return shot;
  }

  /// @return the faults of its packets
  gige::PacketFaults count_frame() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.frames;
    return {faults_.lost_packets, faults_.packets_lost_once, faults_.seed};
  }

  void expose(Shot shot, const ControlServer& server, FrameDrawer& drawer,
              std::vector<std::uint8_t> pixels) const {
    shot.exposure = server.exposure();
    shot.gain = server.gain();
    gige::Frame frame;
    frame.block = block_of(shot.frame);
    frame.time = shot.time;
    frame.region = on_sensor(server.region());
    frame.pixels = std::move(pixels);
    frame.pixels.resize(static_cast<std::size_t>(frame.region.width) *
                        static_cast<std::size_t>(frame.region.height));
    drawer.begin(shot, std::move(frame));
  }

  /// A client may write any number into a register.
  Region on_sensor(Region region) const {
    region.width = std::clamp(region.width, 1, options_.sensor_width);
    region.height = std::clamp(region.height, 1, options_.sensor_height);
    region.x = std::clamp(region.x, 0, options_.sensor_width - region.width);
    region.y = std::clamp(region.y, 0, options_.sensor_height - region.height);
    return region;
  }

  void wait(const ControlServer& server, Nanoseconds until) const {
    const auto [unicast, broadcast] = server.handles();
    std::array<pollfd, 3> events = {
        {{unicast, POLLIN, 0}, {broadcast, POLLIN, 0}, {bell_.handle(), POLLIN, 0}}};
    constexpr Nanoseconds kSecond = 1'000'000'000;  // [ns]
    const Nanoseconds left = std::clamp<Nanoseconds>(until - host_now(), 0, kIdle);
    const timespec timeout = {left / kSecond, left % kSecond};
    ppoll(events.data(), events.size(), &timeout, nullptr);
    bell_.quiet();
  }

  static constexpr Nanoseconds kIdle = 50'000'000;  // [ns] chosen

  const CameraOptions options_;
  const Render render_;
  const std::function<std::uint8_t()> lasers_now_;
  const Bell bell_;

  std::mutex power_mutex_;
  std::atomic<bool> powered_{false};

  mutable std::mutex mutex_;  // what follows, up to the thread
  bool waits_for_pulses_ = false;
  std::deque<Shot> pending_;
  Nanoseconds last_pulse_ = 0;
  std::uint64_t frames_ = 0;  // exposed since power-up
  Counts counts_;
  CameraFaults faults_;
  std::mt19937_64 random_{1};

  std::thread thread_;
};

GigeCamera::GigeCamera(const CameraOptions& options, Render render,
                       std::function<std::uint8_t()> lasers_now)
    : implementation_(
          std::make_unique<Implementation>(options, std::move(render), std::move(lasers_now))) {}

GigeCamera::~GigeCamera() = default;

void GigeCamera::pulse(const TriggerCircuit::Pulse& pulse) {
  implementation_->pulse(pulse);
}

void GigeCamera::set_faults(const CameraFaults& faults) {
  implementation_->set_faults(faults);
}

void GigeCamera::set_power(bool on) {
  implementation_->set_power(on);
}

bool GigeCamera::has_power() const {
  return implementation_->has_power();
}

GigeCamera::Counts GigeCamera::counts() const {
  return implementation_->counts();
}

}  // namespace scan_cell_sim
