// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arv.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "peaks/stripes.h"

namespace fake_cameras {

/// Aravis' fake camera in this process. It shows a laser line at a known place, can be triggered,
/// and can lack features.
class LineCamera {
 public:
  /// Sensor column of the line's centre in a sensor row.
  static double line(int row) { return 100 + 0.25 * row; }

  /// Writes what it sends: `columns` x `rows` bytes.
  using Fill = std::function<void(std::uint8_t* bytes, int columns, int rows)>;

  explicit LineCamera(const std::string& genicam_file = "", Fill fill = nullptr)
      : fill_(std::move(fill)),
        camera_(arv_gv_fake_camera_new_full(
            "127.0.0.1", "LINE", genicam_file.empty() ? nullptr : genicam_file.c_str())) {
    arv_fake_camera_set_fill_pattern(fake(), &LineCamera::draw, this);
    constexpr double kPollingRate = 1000;
    arv_fake_camera_set_trigger_frequency(fake(), kPollingRate);
  }
  ~LineCamera() { g_object_unref(camera_); }
  LineCamera(const LineCamera&) = delete;
  LineCamera& operator=(const LineCamera&) = delete;

  /// One pulse. A pulse before the last one was noticed is lost, as on a real camera.
  void pulse() { arv_fake_camera_write_register(fake(), kSoftwareTriggerRegister, 1); }

  /// Whether AcquisitionFrameRateEnable is on, of save_genicam_with_rate_enable().
  bool rate_is_enabled() {
    guint32 value = 0;
    arv_fake_camera_read_register(fake(), kRateEnableRegister, &value);
    return value != 0;
  }

  /// Writes the camera's description of itself with a feature renamed: a camera without that
  /// feature.
  static void save_genicam_without(const std::string& feature, const std::string& path) {
    save_genicam(feature, "NoSuchThing", path);
  }

  /// A camera with more features: whole numbers, or words from 0 up.
  class Features {
   public:
    Features& number(const std::string& name) {
      nodes_ += "<Integer Name=\"" + name + "\"><pValue>" + name + "Register</pValue></Integer>";
      return add_register(name);
    }
    Features& words(const std::string& name, const std::vector<std::string>& values) {
      add_words(name, values);
      return add_register(name);
    }
    /// As words(), with a value of its own for each word of `selector`.
    Features& words_of_each(const std::string& selector, const std::string& name,
                            const std::vector<std::string>& values, unsigned count) {
      add_words(name, values);
      add_register(name, "<pIndex Offset=\"4\">" + selector + "</pIndex>");
      count_ += count - 1;
      return *this;
    }
    void save(const std::string& path) const { save_genicam("", "", path, nodes_); }

   private:
    void add_words(const std::string& name, const std::vector<std::string>& values) {
      nodes_ += "<Enumeration Name=\"" + name + "\">";
      for (std::size_t i = 0; i < values.size(); ++i) {
        nodes_ += "<EnumEntry Name=\"" + values[i] + "\"><Value>" + std::to_string(i) +
                  "</Value></EnumEntry>";
      }
      nodes_ += "<pValue>" + name + "Register</pValue></Enumeration>";
    }
    Features& add_register(const std::string& name, const std::string& index = "") {
      nodes_ += "<IntReg Name=\"" + name + "Register\"><Address>" +
                std::to_string(kFirst + 4 * count_++) + "</Address>" + index +
                "<Length>4</Length><AccessMode>RW</AccessMode><pPort>Device</pPort>"
                "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess></IntReg>";
      return *this;
    }
    std::string nodes_;
    unsigned count_ = 0;
  };

  /// Value of an added feature; they are counted from 0.
  guint32 read_feature(unsigned index) {
    guint32 value = 0;
    arv_fake_camera_read_register(fake(), kFirst + 4 * index, &value);
    return value;
  }
  void write_feature(unsigned index, guint32 value) {
    arv_fake_camera_write_register(fake(), kFirst + 4 * index, value);
  }

  /// A camera that rounds widths down to multiples of 16.
  static void save_genicam_with_steps(const std::string& path) {
    save_genicam("<pValue>WidthRegister</pValue>", "<pValue>WidthSteps</pValue>", path,
                 R"(<IntConverter Name="WidthSteps">
                      <FormulaTo>FROM - FROM % 16</FormulaTo>
                      <FormulaFrom>TO</FormulaFrom>
                      <pValue>WidthRegister</pValue>
                    </IntConverter>)");
  }

  /// A camera that has Mono12p as well.
  static void save_genicam_with_mono12p(const std::string& path) {
    save_genicam("</DisplayName>\n\t\t<EnumEntry Name=\"BayerBG8\"",
                 "</DisplayName>\n\t\t<EnumEntry Name=\"Mono12p\" NameSpace=\"Standard\">"
                 "<Value>17563719</Value></EnumEntry>\n\t\t<EnumEntry Name=\"BayerBG8\"",
                 path);
  }

  /// A camera whose rate can be switched on and off, as on most real ones.
  static void save_genicam_with_rate_enable(const std::string& path) {
    save_genicam("", "", path,
                 R"(<Boolean Name="AcquisitionFrameRateEnable">
                      <pValue>AcquisitionFrameRateEnableRegister</pValue>
                    </Boolean>
                    <IntReg Name="AcquisitionFrameRateEnableRegister">
                      <Address>0x1f0</Address>
                      <Length>4</Length>
                      <AccessMode>RW</AccessMode>
                      <pPort>Device</pPort>
                      <Sign>Unsigned</Sign>
                      <Endianess>BigEndian</Endianess>
                    </IntReg>)");
  }

 private:
  static constexpr guint32 kFirst = 0x8000;  // unused in its memory
  static constexpr guint32 kSoftwareTriggerRegister = 0x30c;
  static constexpr guint32 kRateEnableRegister = 0x1f0;  // that of its TestRegister

  /// Writes the camera's description of itself, with some text replaced and some nodes added.
  static void save_genicam(const std::string& text, const std::string& replacement,
                           const std::string& path, const std::string& nodes = "") {
    ArvFakeCamera* const plain = arv_fake_camera_new("PLAIN");
    std::size_t size = 0;
    std::string xml(arv_fake_camera_get_genicam_xml(plain, &size));
    g_object_unref(plain);
    for (std::size_t at = 0; !text.empty() && (at = xml.find(text, at)) != std::string::npos;
         at += replacement.size())
      xml.replace(at, text.size(), replacement);
    const std::string end = "</RegisterDescription>";
    xml.replace(xml.rfind(end), end.size(), nodes + end);
    std::ofstream(path) << xml;
  }

  ArvFakeCamera* fake() { return arv_gv_fake_camera_get_fake_camera(camera_); }

  /// Draws 8 bits, or 16 times that in Mono16 and Mono12p.
  static void draw(ArvBuffer* buffer, void* self, guint32, guint32, ArvPixelFormat format) {
    int x = 0, y = 0, width = 0, height = 0;
    arv_buffer_get_image_region(buffer, &x, &y, &width, &height);
    std::size_t size = 0;
    auto* bytes = static_cast<std::uint8_t*>(
        const_cast<void*>(arv_buffer_get_data(buffer, &size)));  // its size reads 0 here
    if (const Fill& fill = static_cast<LineCamera*>(self)->fill_) return fill(bytes, width, height);
    constexpr double kSigma = 1.5, kHeight = 200, kBackground = 10;
    std::vector<std::uint16_t> pixels;
    const int scale = format == ARV_PIXEL_FORMAT_MONO_8 ? 1 : 16;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const double light = kHeight * stripes::gaussian_pixel(x + column, line(y + row), kSigma);
        pixels.push_back(static_cast<std::uint16_t>(std::lround(scale * (kBackground + light))));
      }
    }
    for (std::size_t i = 0; i < pixels.size(); ++i)
      write_pixel(format, i, pixels[i], bytes);
  }

  static void write_pixel(ArvPixelFormat format, std::size_t index, int grey, std::uint8_t* bytes) {
    if (format == ARV_PIXEL_FORMAT_MONO_8) {
      bytes[index] = static_cast<std::uint8_t>(grey);
    } else if (format == ARV_PIXEL_FORMAT_MONO_16) {
      bytes[2 * index] = static_cast<std::uint8_t>(grey & 0xFF);
      bytes[2 * index + 1] = static_cast<std::uint8_t>(grey >> 8);
    } else {  // Mono12p: 8 bits and 4, then 4 and 8
      std::uint8_t* const pair = bytes + index / 2 * 3;
      if (index % 2 == 0) {
        pair[0] = static_cast<std::uint8_t>(grey & 0xFF);
        pair[1] = static_cast<std::uint8_t>(grey >> 8);
      } else {
        pair[1] = static_cast<std::uint8_t>(pair[1] | (grey & 0xF) << 4);
        pair[2] = static_cast<std::uint8_t>(grey >> 4);
      }
    }
  }

  Fill fill_;
  ArvGvFakeCamera* camera_;
};

}  // namespace fake_cameras
