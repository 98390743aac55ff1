// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/session_recorder.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tecnogamma_camera/peak_file.h"

namespace fs = std::filesystem;

namespace scan_calibration {
namespace {

constexpr const char* kHead = "session.yaml";
constexpr const char* kImages = "images";

std::string path_of(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

}  // namespace

SessionRecorder::SessionRecorder(const std::string& folder, const Board& board,
                                 const std::vector<std::string>& lasers)
    : folder_(folder), head_{"poses.csv", board, lasers} {
  std::error_code failure;  // of an inaccessible path: reported below, where it cannot be made
  if (fs::exists(path_of(folder, kHead), failure)) {
    throw scan_cell_common::Refused(folder, "holds a session already",
                                    "name a new folder: a session is never overwritten");
  }
  // Data that cannot be read back must not be recorded.
  parse_session_head(session_head_text(head_), path_of(folder, kHead));
  fs::create_directories(fs::path(folder) / kImages, failure);
  if (failure) {
    throw scan_cell_common::FileError(folder, failure.message(),
                                      "check the path and its permissions");
  }
}

std::string SessionRecorder::save(const cv::Mat& image, const std::string& name) const {
  if (image.empty() || (image.type() != CV_8UC1 && image.type() != CV_16UC1)) {
    throw scan_cell_common::UnusableInput(
        name, image.empty() ? "empty" : cv::typeToString(image.type()) + " pixels",
        "give an image of 8 or 16 bit grey pixels");
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  const std::string file = std::string(kImages) + "/" + name + ".png";
  scan_cell_common::save_text(path_of(folder_, file), {bytes.begin(), bytes.end()});
  return file;
}

std::string SessionRecorder::save(const RecordedLine& line, const std::string& name) const {
  const std::string image = line.image.empty() ? "" : save(line.image, name);
  if (!line.peaks) return image;
  const std::string file = std::string(kImages) + "/" + name + ".csv";
  tecnogamma_camera::save_peaks(path_of(folder_, file), *line.peaks);
  return file;
}

void SessionRecorder::add(const Eigen::Isometry3d& base_to_flange, const cv::Mat& board_image,
                          const std::vector<RecordedLine>& lines) {
  if (lines.size() != head_.lasers.size()) {
    throw scan_cell_common::UnusableInput(
        "lines of a view", fmt::format("{}", lines.size()),
        fmt::format("give one per laser, {} in all, empty where not taken", head_.lasers.size()));
  }
  if (lines.size() > 1 && std::any_of(lines.begin(), lines.end(), [](const RecordedLine& line) {
        return line.in_board_image;
      })) {
    throw scan_cell_common::UnusableInput("lines of a view", "in the image of the board",
                                          "take one image per laser: several lines in one image "
                                          "cannot be told apart");
  }
  const std::string number = fmt::format("{:04}", views() + 1);
  SessionView view;
  view.base_to_flange = base_to_flange;
  view.name = view.board_image = save(board_image, "board_" + number);
  for (std::size_t i = 0; i < lines.size(); ++i)
    view.lines.push_back(lines[i].in_board_image ? view.board_image
                                                 : save(lines[i], head_.lasers[i] + "_" + number));
  std::vector<SessionView> views = views_;
  views.push_back(view);
  scan_cell_common::save_text(path_of(folder_, head_.poses_file),
                              session_poses_text(views, head_.lasers));
  if (views_.empty())
    scan_cell_common::save_text(path_of(folder_, kHead), session_head_text(head_));
  views_ = std::move(views);
}

}  // namespace scan_calibration
