// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/gige_camera.h"

#include <arpa/inet.h>
#include <arv.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <deque>
#include <fstream>
#include <mutex>
#include <random>
#include <thread>

#include "scan_cell_common/errors.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::from_seconds;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;

constexpr std::uint16_t kControlPort = 3956;  // GigE Vision 1.2, section 7
constexpr guint32 kOn = 1;
/// Aravis looks for a trigger this often. It sleeps whole milliseconds and spins the rest: a little
/// more than a whole number of them keeps the spinning short.
constexpr double kLookPeriod = 0.0042;  // [s]
/// The counter starts where Aravis' own does: it wraps soon, as it does in every long scan.
constexpr std::uint16_t kFirstBlock = 65400;

Nanoseconds host_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// A UDP socket that is closed at the end.
class UdpSocket {
 public:
  UdpSocket() : handle_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~UdpSocket() { close(handle_); }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  int handle() const { return handle_; }

 private:
  int handle_;
};

sockaddr_in control_address(const std::string& address) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(kControlPort);
  if (inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1) {
    throw InvalidParameter("camera address", address, "give an IPv4 address such as 127.0.0.1");
  }
  return name;
}

/// Aravis says nothing if it cannot bind.
void throw_if_taken(const std::string& address) {
  const sockaddr_in name = control_address(address);
  const UdpSocket probe;
  if (bind(probe.handle(), reinterpret_cast<const sockaddr*>(&name), sizeof(name)) == 0) return;
  throw ConnectionError("camera on " + address + ":" + std::to_string(kControlPort),
                        std::strerror(errno),
                        "stop the other camera or simulator on this address, or give another one");
}

void check(const CameraOptions& options) {
  const Region& r = options.region;
  if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.width > options.sensor_width - r.x ||
      r.height > options.sensor_height - r.y) {
    throw InvalidParameter("camera region",
                           std::to_string(r.width) + " x " + std::to_string(r.height) + " at " +
                               std::to_string(r.x) + ", " + std::to_string(r.y),
                           "the sensor has " + std::to_string(options.sensor_width) + " x " +
                               std::to_string(options.sensor_height) + " pixels");
  }
  if (!std::ifstream(options.genicam_file)) {
    throw scan_cell_common::FileError(options.genicam_file, "cannot be read",
                                      "give the path of gige_camera.xml");
  }
}

}  // namespace

/// Aravis' camera asks for frames in its own thread; pulses come in another, and a third keeps
/// house.
class GigeCamera::Implementation {
 public:
  Implementation(const CameraOptions& options, Render render,
                 std::function<std::uint8_t()> lasers_now)
      : options_(options), render_(std::move(render)), lasers_now_(std::move(lasers_now)) {
    check(options_);
    set_power(true);
    keeper_ = std::thread(&Implementation::keep_house, this);
  }

  ~Implementation() {
    ending_ = true;
    keeper_.join();
    set_power(false);
  }

  void pulse(const TriggerCircuit::Pulse& pulse) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.pulses;
    if (!waits_for_pulses()) {
      ++counts_.ignored;
      return;
    }
    const bool too_soon = pulse.time - last_pulse_ < from_seconds(options_.least_period);
    if (too_soon || pending_.size() >= static_cast<std::size_t>(options_.most_pending)) {
      ++counts_.overrun;
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
    request_frame();
  }

  void set_faults(const CameraFaults& faults) {
    const std::lock_guard<std::mutex> lock(mutex_);
    faults_ = faults;
    random_.seed(faults.seed);
    if (camera_ != nullptr) lose_packets();
  }

  void set_power(bool on) {
    const std::lock_guard<std::mutex> power_lock(power_mutex_);
    if (on == has_power()) return;
    on ? switch_on() : switch_off();
  }

  bool has_power() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return camera_ != nullptr;
  }

  Counts counts() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
  }

 private:
  ArvFakeCamera* registers() const { return arv_gv_fake_camera_get_fake_camera(camera_); }

  void write(guint32 address, int value) {
    arv_fake_camera_write_register(registers(), address, static_cast<guint32>(value));
  }

  bool acquires() const {
    return camera_ != nullptr && arv_fake_camera_get_control_channel_privilege(registers()) != 0 &&
           arv_fake_camera_get_acquisition_status(registers()) != 0;
  }

  bool waits_for_pulses() const {
    return acquires() && arv_fake_camera_is_in_software_trigger_mode(registers()) != 0;
  }

  void request_frame() { write(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOFTWARE, kOn); }

  void lose_packets() { g_object_set(camera_, "gvsp-lost-ratio", faults_.lost_packets, nullptr); }

  void switch_on() {
    throw_if_taken(options_.address);
    ArvGvFakeCamera* const camera = arv_gv_fake_camera_new_full(
        options_.address.c_str(), options_.serial.c_str(), options_.genicam_file.c_str());
    if (arv_gv_fake_camera_is_running(camera) == 0) {
      g_object_unref(camera);
      throw ConnectionError("camera on " + options_.address, "cannot be served",
                            "give the address of a network interface of this machine");
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    camera_ = camera;
    frames_ = 0;
    power_up_registers();
    lose_packets();
    arv_fake_camera_set_trigger_frequency(registers(), 1 / kLookPeriod);
    arv_fake_camera_set_fill_pattern(registers(), &Implementation::fill, this);
  }

  void power_up_registers() {
    write(ARV_FAKE_CAMERA_REGISTER_SENSOR_WIDTH, options_.sensor_width);
    write(ARV_FAKE_CAMERA_REGISTER_SENSOR_HEIGHT, options_.sensor_height);
    write(ARV_FAKE_CAMERA_REGISTER_WIDTH, options_.region.width);
    write(ARV_FAKE_CAMERA_REGISTER_HEIGHT, options_.region.height);
    write(ARV_FAKE_CAMERA_REGISTER_X_OFFSET, options_.region.x);
    write(ARV_FAKE_CAMERA_REGISTER_Y_OFFSET, options_.region.y);
    constexpr int kExposure = 1000;  // [us]
    write(ARV_FAKE_CAMERA_REGISTER_EXPOSURE_TIME_US, kExposure);
    write(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOURCE, kOn);
    write_text(0x48, "ScanCell");  // vendor and model, as the discovery packet tells them
    write_text(0x68, "SimulatedCamera");
  }

  void write_text(guint32 address, const char* text) {
    std::array<char, 32> field{};
    std::strncpy(field.data(), text, field.size() - 1);
    arv_fake_camera_write_memory(registers(), address, field.size(), field.data());
  }

  void switch_off() {
    ArvGvFakeCamera* camera = nullptr;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::swap(camera, camera_);
      discard_pending();
    }
    g_object_unref(camera);  // waits for its thread, which may be in fill()
  }

  void discard_pending() {
    counts_.discarded += pending_.size();
    pending_.clear();
    last_pulse_ = 0;
  }

  static void fill(ArvBuffer* buffer, void* self, guint32 exposure_us, guint32 gain,
                   ArvPixelFormat) noexcept {
    static_cast<Implementation*>(self)->fill(buffer, exposure_us * 1e-6,
                                             std::pow(10, gain / 10.0 / 20));
  }

  void fill(ArvBuffer* buffer, double exposure, double gain) {
    Shot shot = next_shot();
    shot.exposure = exposure;
    shot.gain = gain;
    Region region;
    arv_buffer_get_image_region(buffer, &region.x, &region.y, &region.width, &region.height);
    std::size_t size = 0;  // reads 0 here; Aravis made room for the region
    auto* const pixels =
        static_cast<std::uint8_t*>(const_cast<void*>(arv_buffer_get_data(buffer, &size)));
    render_(shot, region, pixels);
    arv_buffer_set_timestamp(buffer, static_cast<guint64>(shot.time));
    arv_buffer_set_frame_id(buffer, block_of(shot.frame));
  }

  /// The oldest pulse's; now, if it runs freely or a client sent a software trigger.
  Shot next_shot() {
    Shot shot;
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.frames;
    if (pending_.empty()) {
      shot.time = host_now();
      shot.lasers = lasers_now_();
      shot.frame = ++frames_;
      return shot;
    }
    shot = pending_.front();
    pending_.pop_front();
    if (!pending_.empty() && camera_ != nullptr) request_frame();
    return shot;
  }

  /// 16 bits, and 0 is no number.
  static std::uint16_t block_of(std::uint64_t frame) {
    constexpr std::uint64_t kBlocks = 65535;
    return static_cast<std::uint16_t>((kFirstBlock + frame - 2) % kBlocks + 1);
  }

  /// What a real camera does by itself: frames of the last acquisition are not sent in the next,
  /// and a client that vanished loses control, which Aravis notices only when some packet comes.
  void keep_house() {
    constexpr auto kPeriod = std::chrono::milliseconds(5);
    constexpr int kKnockEvery = 50;
    for (int round = 0; !ending_; ++round) {
      if (round % kKnockEvery == 0) knock();
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (camera_ != nullptr && arv_fake_camera_get_control_channel_privilege(registers()) == 0) {
          write(ARV_FAKE_CAMERA_REGISTER_ACQUISITION, 0);
        }
        if (camera_ != nullptr && !waits_for_pulses() && !pending_.empty()) {
          discard_pending();
          write(ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOFTWARE, 0);
        }
      }
      std::this_thread::sleep_for(kPeriod);
    }
  }

  void knock() const {
    constexpr std::array<std::uint8_t, 8> kDiscovery = {0x42, 1, 0, 2, 0, 0, 0, 1};
    const sockaddr_in name = control_address(options_.address);
    const UdpSocket socket;
    sendto(socket.handle(), kDiscovery.data(), kDiscovery.size(), 0,
           reinterpret_cast<const sockaddr*>(&name), sizeof(name));
  }

  const CameraOptions options_;
  const Render render_;
  const std::function<std::uint8_t()> lasers_now_;

  std::mutex power_mutex_;
  mutable std::mutex mutex_;  // all below
  ArvGvFakeCamera* camera_ = nullptr;
  std::deque<Shot> pending_;
  Nanoseconds last_pulse_ = 0;
  std::uint64_t frames_ = 0;  // exposed since power-up
  Counts counts_;
  CameraFaults faults_;
  std::mt19937_64 random_{1};

  std::atomic<bool> ending_{false};
  std::thread keeper_;
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
