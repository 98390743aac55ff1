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

/// The subject of a page, for turning the view to it.
struct PlaceInView {
  Eigen::Vector3d middle;  //!< [m] in `frame`
  double radius;           //!< [m] of a sphere around all of it
  QString frame;
};

/// Where the subject of a session is; none: it has none.
std::optional<PlaceInView> place_of(const PathSession& session);  ///< path with the part around it
std::optional<PlaceInView> place_of(const EditSession& session);  ///< visible points of the scan
std::optional<PlaceInView> place_of(const PickSession& session);  ///< the reference
std::optional<PlaceInView> place_of(const PassSession& session);  ///< the poses

}  // namespace scan_cell_rviz
