// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/session.h"

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace fs = std::filesystem;

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

/// The file's whole path.
std::string find(const fs::path& folder, const std::string& file, const std::string& poses_file,
                 const std::string& view) {
  if (file.empty()) return {};
  const fs::path path = folder / file;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) {
    throw UnusableInput(poses_file + ": " + view, "no file " + path.string(),
                        "restore it or remove the line");
  }
  return path.string();
}

}  // namespace

Session load_session(const std::string& folder) {
  const fs::path root(folder);
  const std::string head_file = (root / "session.yaml").string();
  const SessionHead head = parse_session_head(scan_cell_common::read_file(head_file), head_file);
  const std::string poses_file = (root / head.poses_file).string();
  Session session{
      head.board, head.lasers,
      parse_session_poses(scan_cell_common::read_file(poses_file), poses_file, head.lasers)};
  for (SessionView& view : session.views) {
    view.board_image = find(root, view.board_image, poses_file, view.name);
    for (std::string& line : view.lines)
      line = find(root, line, poses_file, view.name);
  }
  return session;
}

}  // namespace scan_calibration
