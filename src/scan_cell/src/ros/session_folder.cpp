// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "session_folder.h"

#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/yaml_file.h"
#include "tecnogamma_camera/peak_file.h"

namespace scan_cell {

namespace fs = std::filesystem;

using scan_cell_common::FileError;

namespace {

const char* const kPoses = "poses.csv";

void make_empty_folder(const std::string& path) {
  std::error_code failure;
  fs::create_directories(path, failure);
  if (failure) throw FileError(path, failure.message(), "give a folder of yours");
  const bool empty = fs::is_empty(path, failure);
  if (failure) throw FileError(path, failure.message(), "give a folder of yours");
  if (!empty) {
    throw scan_cell_common::Refused("session folder " + path, "not empty", "give a new one");
  }
}

void save_image(const fs::path& path, const cv::Mat& image) {
  bool written = false;
  try {
    written = cv::imwrite(path.string(), image);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) throw FileError(path.string(), "cannot be written", "check rights and free space");
}

}  // namespace

SessionFolder::SessionFolder(const std::string& path, const scan_calibration::Board& board,
                             const std::vector<std::string>& lasers)
    : path_(path), lasers_(lasers) {
  make_empty_folder(path);
  scan_cell_common::save_text((fs::path(path) / "session.yaml").string(),
                              scan_calibration::session_head_text({kPoses, board, lasers}));
}

void SessionFolder::add(const TakenView& view) {
  char number[16];
  std::snprintf(number, sizeof(number), "%03zu", views_.size() + 1);
  const fs::path folder(path_);
  scan_calibration::SessionView entry;
  entry.base_to_flange = view.base_to_flange;
  entry.name = entry.board_image = std::string("board_") + number + ".png";
  save_image(folder / entry.board_image, view.board.image);
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    const std::string stem = lasers_[i] + "_" + number;
    save_image(folder / (stem + ".png"), view.lines.at(i).image);
    entry.lines.push_back(stem + ".csv");
    tecnogamma_camera::save_peaks((folder / entry.lines.back()).string(), view.lines[i].peaks);
  }
  views_.push_back(entry);
  // The list last, and whole: it names only what is there.
  scan_cell_common::save_text((folder / kPoses).string(),
                              scan_calibration::session_poses_text(views_, lasers_));
}

}  // namespace scan_cell
