// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recording/folder_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "scan_cell_common/files/files.h"

namespace fs = std::filesystem;

namespace tecnogamma_camera {
namespace {

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

constexpr const char* kPayload = ".bin";

bool is_frame_file(const fs::path& path) {
  const std::string extension = scan_cell_common::extension_of(path.string());
  const auto known = {".png", ".pgm", ".tif", ".tiff", ".bmp", kPayload};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// Compares numbers in names by their value: frame_9 before frame_10.
bool comes_before(const std::string& one, const std::string& other) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto number_at = [&](const std::string& text, std::size_t& at) {
    const std::size_t begin = std::min(text.find_first_not_of('0', at), text.size());
    at = begin;
    while (at < text.size() && digit(text[at]))
      ++at;
    return text.substr(begin, at - begin);
  };
  std::size_t i = 0, k = 0;
  while (i < one.size() && k < other.size()) {
    if (digit(one[i]) && digit(other[k])) {
      const std::string a = number_at(one, i), b = number_at(other, k);
      if (a.size() != b.size()) return a.size() < b.size();
      if (a != b) return a < b;
    } else {
      if (one[i] != other[k]) return one[i] < other[k];
      ++i, ++k;
    }
  }
  if (one.size() - i != other.size() - k) return one.size() - i < other.size() - k;
  return one < other;
}

FolderIndex list_files(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_frame_file(entry.path()))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end(), comes_before);
  FolderIndex index;
  for (const std::string& name : names)
    index.files.push_back({name, index.files.size() + 1});
  if (names.empty()) {
    throw FileError(folder.string(), "holds no images",
                    "give a folder of PNG, PGM, TIFF, BMP, bin");
  }
  return index;
}

/// Of any channels and depth.
cv::Mat read_image(const std::string& path) {
  const std::string bytes = scan_cell_common::read_file(path);
  cv::Mat image;
  try {
    if (!bytes.empty()) {
      const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                            const_cast<char*>(bytes.data()));
      image = cv::imdecode(encoded, cv::IMREAD_UNCHANGED);
    }
  } catch (const cv::Exception& error) {
    throw FileError(path, error.err, "record it again");
  }
  if (image.empty()) throw FileError(path, "cannot be read as an image", "record it again");
  return image;
}

/// 8 or 16 bit grey, or the bytes of a payload in one row.
cv::Mat read_frame(const std::string& path) {
  if (scan_cell_common::extension_of(path) == kPayload) {
    const std::string bytes = scan_cell_common::read_file(path);
    return cv::Mat(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()))
        .clone();
  }
  cv::Mat image = read_image(path);
  if (image.type() != CV_8UC1 && image.type() != CV_16UC1) {
    throw UnusableInput(path, cv::typeToString(image.type()) + " pixels",
                        "convert it to 8 or 16 bit grey");
  }
  return image;
}

std::string to_text(int columns, int rows, int type) {
  return fmt::format("{} x {} {}", columns, rows, cv::typeToString(type));
}

class FolderRecording : public Recording {
 public:
  FolderRecording(const std::string& path, FolderIndex index)
      : folder_(path), index_(std::move(index)) {
    throw_if_missing();
    const auto first = std::find_if(index_.files.begin(), index_.files.end(),
                                    [](const auto& file) { return file.packets_lost == 0; });
    if (first == index_.files.end())
      throw UnusableInput(path, "every frame lost packets", "give a folder with complete frames");
    pixels_ = read_frame(path_of(*first));
    columns_ = pixels_.cols;
    rows_ = pixels_.rows;
    type_ = pixels_.type();
    check_place();
  }

  CameraDescription describe() override {
    CameraDescription description;
    description.id = "folder:" + folder_.string();
    description.model = "recording";
    description.transport = "folder";
    description.region = {index_.first_column, index_.first_row, columns_, rows_};
    description.sensor_columns =
        index_.sensor_columns > 0 ? index_.sensor_columns : index_.first_column + columns_;
    description.sensor_rows =
        index_.sensor_rows > 0 ? index_.sensor_rows : index_.first_row + rows_;
    description.grey_bits = bits();
    description.counter = kCounter64;
    return description;
  }

  std::optional<Frame> next() override {
    if (next_ == index_.files.size()) return std::nullopt;
    const RecordedFile& file = index_.files[next_++];
    Frame frame;
    frame.counter = file.frame;
    frame.device_time = file.device_time;
    frame.time = file.time;
    frame.packets_lost = file.packets_lost;
    frame.image.columns = columns_;
    frame.image.rows = rows_;
    frame.image.first_column = index_.first_column;
    frame.image.first_row = index_.first_row;
    frame.image.bits = bits();
    if (file.packets_lost > 0) return frame;
    try {
      read_pixels(path_of(file), frame.image);
    } catch (const scan_cell_common::Error& error) {
      frame.fault = error.what();
    }
    return frame;
  }

  void rewind() override { next_ = 0; }

 private:
  int bits() const { return type_ == CV_16UC1 ? 16 : 8; }

  std::string path_of(const RecordedFile& file) const { return (folder_ / file.file).string(); }

  void throw_if_missing() const {
    for (const RecordedFile& file : index_.files)
      if (file.packets_lost == 0 && !fs::is_regular_file(path_of(file)))
        throw FileError(path_of(file), "no such file",
                        "correct the folder's index, which names it");
  }

  void check_place() const {
    const bool fits =
        (index_.sensor_columns == 0 || index_.first_column + columns_ <= index_.sensor_columns) &&
        (index_.sensor_rows == 0 || index_.first_row + rows_ <= index_.sensor_rows);
    if (fits) return;
    throw UnusableInput(folder_.string() + "/index.csv", "images beyond the sensor's edge",
                        "correct first_column, first_row, sensor_columns or sensor_rows");
  }

  /// Payloads may differ in size, images may not.
  void read_pixels(const std::string& path, GreyImage& image) {
    pixels_ = read_frame(path);
    const bool payload = scan_cell_common::extension_of(path) == kPayload;
    if (pixels_.type() != type_ ||
        (!payload && (pixels_.cols != columns_ || pixels_.rows != rows_))) {
      throw UnusableInput(path,
                          to_text(pixels_.cols, pixels_.rows, pixels_.type()) +
                              " pixels, the first image has " + to_text(columns_, rows_, type_),
                          "put images of different kinds into different folders");
    }
    image.columns = pixels_.cols;
    image.rows = pixels_.rows;
    image.pixels = pixels_.data;
    image.stride = static_cast<std::ptrdiff_t>(pixels_.step1());
  }

  fs::path folder_;
  FolderIndex index_;
  int columns_ = 0;
  int rows_ = 0;
  int type_ = CV_8UC1;  // or CV_16UC1
  std::size_t next_ = 0;
  cv::Mat pixels_;  // of the frame that next() gave last
};

}  // namespace

std::unique_ptr<Recording> open_folder_recording(const std::string& path) {
  if (!fs::is_directory(path)) throw FileError(path, "no such folder", "check the path");
  const fs::path file = fs::path(path) / "index.csv";
  FolderIndex index =
      fs::exists(file)
          ? parse_folder_index(scan_cell_common::read_file(file.string()), file.string())
          : list_files(path);
  return std::make_unique<FolderRecording>(path, std::move(index));
}

}  // namespace tecnogamma_camera
