// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QString>
#include <optional>

#include "design/pick_session.h"
#include "edit/edit_session.h"
#include "passes/pass_session.h"
#include "path/path_session.h"

namespace scan_cell_rviz {

/// What a page is about, as the view is turned to it.
struct PlaceInView {
  Eigen::Vector3d middle;  //!< [m] in the frame
  double radius;           //!< [m] all of it is within
  QString frame;
};

/// Where a session's thing lies; none: it has none.
std::optional<PlaceInView> place_of(const PathSession& session);  ///< and the part around the path
std::optional<PlaceInView> place_of(const EditSession& session);  ///< what is shown of the scan
std::optional<PlaceInView> place_of(const PickSession& session);  ///< the reference
std::optional<PlaceInView> place_of(const PassSession& session);  ///< the poses

}  // namespace scan_cell_rviz
