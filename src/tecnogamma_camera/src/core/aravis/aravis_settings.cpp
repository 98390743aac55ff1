// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "aravis/aravis_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "aravis/aravis_support.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;

void check_bounds(const std::string& name, double value, double least, double most,
                  const std::string& unit) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  throw InvalidParameter(name, fmt::format("{}{}", value, unit),
                         fmt::format("this camera takes {:.6g} to {:.6g}{}", least, most, unit));
}

std::string to_text(const Region& region) {
  return fmt::format("{} x {} at {}, {}", region.width, region.height, region.x, region.y);
}

void set_region(ArvCamera* arv, const Region& region) {
  aravis("region " + to_text(region), [&](GError** e) {
    arv_camera_set_region(arv, region.x, region.y, region.width, region.height, e);
  });
}

}  // namespace

Region read_region(ArvCamera* arv) {
  Region region;
  aravis("region", [&](GError** e) {
    arv_camera_get_region(arv, &region.x, &region.y, &region.width, &region.height, e);
  });
  return region;
}

Region write_region(ArvCamera* arv, const Region& wanted) {
  int columns = 0, rows = 0;
  aravis("sensor size", [&](GError** e) { arv_camera_get_sensor_size(arv, &columns, &rows, e); });
  Region region = wanted;
  if (region.width == 0) region.width = columns - region.x;
  if (region.height == 0) region.height = rows - region.y;
  if (region.x < 0 || region.y < 0 || region.width < 1 || region.height < 1 ||
      region.width > columns - region.x || region.height > rows - region.y) {
    throw InvalidParameter("region", to_text(region),
                           fmt::format("the sensor has {} x {} pixels", columns, rows));
  }
  const Region before = read_region(arv);
  try {
    set_region(arv, region);
    const Region taken = read_region(arv);
    if (taken != region) {
      throw InvalidParameter(
          "region", to_text(region),
          "the camera took " + to_text(taken) + "; give multiples of its increments");
    }
  } catch (const InvalidParameter&) {
    set_region(arv, before);
    throw;
  }
  return region;
}

Region write_payload_region(ArvCamera* arv, const Region& wanted) {
  if (wanted.y != 0 || wanted.height != 0) {
    throw InvalidParameter("region", to_text(wanted),
                           "the rows of a payload are not sensor rows: leave y and height at 0");
  }
  const auto set = [&](const char* feature, std::int64_t value) {
    aravis(feature, [&](GError** e) { arv_camera_set_integer(arv, feature, value, e); });
  };
  // Offset and width limit each other.
  if (wanted.width != 0) {
    set("OffsetX", 0);
    set("Width", wanted.width);
  }
  if (wanted.width != 0 || wanted.x != 0) set("OffsetX", wanted.x);
  constexpr const char* kRows = "HeightInterface";
  if (has_feature(arv, kRows)) {
    set("Height", aravis(kRows, [&](GError** e) { return arv_camera_get_integer(arv, kRows, e); }));
  }
  const Region taken = read_region(arv);
  if ((wanted.width != 0 && taken.width != wanted.width) || taken.x != wanted.x) {
    throw InvalidParameter(
        "region", to_text(wanted),
        "the camera took " + to_text(taken) + "; give multiples of its increments");
  }
  return taken;
}

const PixelFormat& write_pixel_format(ArvCamera* arv, const std::string& name) {
  const PixelFormat& format = pixel_format(name);
  guint count = 0;
  const char** const names = aravis("PixelFormat", [&](GError** e) {
    return arv_camera_dup_available_pixel_formats_as_strings(arv, &count, e);
  });
  const bool has_it = std::any_of(names, names + count, [&](const char* n) { return name == n; });
  g_free(names);
  if (!has_it) {
    throw MissingFeature("camera feature", "PixelFormat " + name,
                         "the camera does not have it; give another pixel_format");
  }
  aravis("PixelFormat " + name,
         [&](GError** e) { arv_camera_set_pixel_format_from_string(arv, name.c_str(), e); });
  return format;
}

void write_exposure(ArvCamera* arv, double exposure) {
  if (!arv_camera_is_exposure_time_available(arv, nullptr)) require_feature(arv, "ExposureTime");
  double least = 0, most = 0;
  aravis("exposure",
         [&](GError** e) { arv_camera_get_exposure_time_bounds(arv, &least, &most, e); });
  if (arv_camera_is_exposure_auto_available(arv, nullptr)) {
    aravis("ExposureAuto Off",
           [&](GError** e) { arv_camera_set_exposure_time_auto(arv, ARV_AUTO_OFF, e); });
  }
  check_bounds("exposure", exposure, least / kMicroseconds, most / kMicroseconds, " s");
  aravis("exposure",
         [&](GError** e) { arv_camera_set_exposure_time(arv, exposure * kMicroseconds, e); });
}

void write_gain(ArvCamera* arv, double gain) {
  if (!arv_camera_is_gain_available(arv, nullptr)) require_feature(arv, "Gain");
  double least = 0, most = 0;
  aravis("gain", [&](GError** e) { arv_camera_get_gain_bounds(arv, &least, &most, e); });
  if (arv_camera_is_gain_auto_available(arv, nullptr))
    aravis("GainAuto Off", [&](GError** e) { arv_camera_set_gain_auto(arv, ARV_AUTO_OFF, e); });
  check_bounds("gain", gain, least, most, "");
  aravis("gain", [&](GError** e) { arv_camera_set_gain(arv, gain, e); });
}

void write_rate(ArvCamera* arv, double rate) {
  if (!arv_camera_is_frame_rate_available(arv, nullptr))
    require_feature(arv, "AcquisitionFrameRate");
  double least = 0, most = 0;
  aravis("rate", [&](GError** e) { arv_camera_get_frame_rate_bounds(arv, &least, &most, e); });
  check_bounds("rate", rate, least, most, " Hz");
  aravis("rate", [&](GError** e) { arv_camera_set_frame_rate(arv, rate, e); });
}

void write_trigger(ArvCamera* arv, Trigger trigger, const std::string& source) {
  if (trigger == Trigger::kFreeRun) {
    if (!has_feature(arv, "TriggerMode")) return;
    aravis("TriggerMode Off", [&](GError** e) { arv_camera_clear_triggers(arv, e); });
    return;
  }
  require_feature(arv, "TriggerMode");
  require_feature(arv, "TriggerSource");
  aravis("TriggerSource " + source,
         [&](GError** e) { arv_camera_set_trigger(arv, source.c_str(), e); });
}

std::vector<std::string> words_of(ArvCamera* arv, const char* feature) {
  if (!has_feature(arv, feature)) return {};
  guint count = 0;
  const char** const words = aravis(feature, [&](GError** e) {
    return arv_camera_dup_available_enumerations_as_strings(arv, feature, &count, e);
  });
  std::vector<std::string> result(words, words + count);
  g_free(words);  // the words are the camera's
  return result;
}

StrobeOutputs::StrobeOutputs(ArvCamera* arv, const std::string& lines, const std::string& source)
    : arv_(arv) {
  for (const char* feature : {"LineSelector", "LineMode", "LineSource"})
    require_feature(arv, feature);
  try {
    std::istringstream names(lines);
    for (std::string line; std::getline(names >> std::ws, line, ',');) {
      line.erase(line.find_last_not_of(" \t") + 1);
      change("LineSelector", line);
      change("LineMode", "Output");
      change("LineSource", source);
    }
  } catch (...) {
    restore();
    throw;
  }
}

void StrobeOutputs::change(const char* feature, const std::string& value) {
  const std::string before =
      to_text(aravis(feature, [&](GError** e) { return arv_camera_get_string(arv_, feature, e); }));
  aravis(feature + (" " + value),
         [&](GError** e) { arv_camera_set_string(arv_, feature, value.c_str(), e); });
  changed_.push_back({feature, before});
}

void StrobeOutputs::restore() {
  // If one setting cannot be restored, the others must be all the same.
  for (auto change = changed_.rbegin(); change != changed_.rend(); ++change)
    arv_camera_set_string(arv_, change->feature, change->before.c_str(), nullptr);
  changed_.clear();
}

}  // namespace tecnogamma_camera
