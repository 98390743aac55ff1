// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/grey_image_file.h"

#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::FileError;

constexpr const char* kCure = "give a PNG, TIFF or PGM of 8 or 16 bit grey pixels";

/// OpenCV decodes a truncated PNG or JPEG as far as it goes and leaves the rest grey or black.
bool is_truncated(std::string_view bytes) {
  const auto begins = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
  constexpr std::size_t kTail = 64;  // [bytes] that hold the end mark of a whole file; chosen
  const std::string_view tail = bytes.substr(bytes.size() - std::min(bytes.size(), kTail));
  if (begins("\x89PNG")) return tail.find("IEND") == std::string_view::npos;
  if (begins("\xff\xd8")) return tail.rfind("\xff\xd9") == std::string_view::npos;
  return false;
}

cv::Mat decode(const std::string& bytes, const std::string& path) {
  if (bytes.empty()) throw FileError(path, "empty", kCure);
  if (is_truncated(bytes)) throw FileError(path, "truncated", "take the image again");
  cv::Mat image;
  try {
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                          const_cast<char*>(bytes.data()));
    image = cv::imdecode(encoded, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw FileError(path, error.err, kCure);
  }
  if (image.empty()) throw FileError(path, "cannot be read as an image", kCure);
  return image;
}

cv::Mat without_equal_channels(const cv::Mat& image) {
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  if (channels.size() != 3) return image;
  for (const cv::Mat& channel : {channels[1], channels[2]})
    if (cv::norm(channels[0], channel, cv::NORM_INF) != 0) return image;
  return channels[0];
}

template <class Pixel>
ImageView<Pixel> view_of(const cv::Mat& image) {
  return {
      image.ptr<Pixel>(), image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step1()), 0, 0};
}

}  // namespace

cv::Mat load_grey_image(const std::string& path) {
  const cv::Mat image = without_equal_channels(decode(scan_cell_common::read_file(path), path));
  if (image.type() != CV_8UC1 && image.type() != CV_16UC1) {
    throw scan_cell_common::UnusableInput(path, cv::typeToString(image.type()) + " pixels",
                                          "convert it to 8 or 16 bit grey");
  }
  return image;
}

GreyImage grey_view(const cv::Mat& image) {
  if (image.type() == CV_16UC1) return view_of<std::uint16_t>(image);
  return view_of<std::uint8_t>(image);
}

}  // namespace tecnogamma_camera
