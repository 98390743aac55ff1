// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/config.h>

#include <QMap>
#include <QString>
#include <optional>

#include "seat/page.h"
#include "seat/place_in_view.h"

namespace rviz {
class Display;
class VisualizationManager;
}  // namespace rviz

namespace scan_cell_rviz {

/// What the 3D view shows beside each page of the seat, and from where: at first what the page is
/// about, later on as a person left it there. Displays that are neither in the settings of the
/// cell nor of this package stay as they are until a person has left a page with them.
class StageViews {
 public:
  /// @param manager outlives this
  explicit StageViews(rviz::VisualizationManager& manager) : manager_(manager) {}

  /// Keeps what is seen beside the page before, and shows what belongs to this one.
  void show(Page page);

  /// Turns no view, but goes as near as shows the whole place.
  /// @return false if rviz does not know the frame; then nothing changes
  bool fit(const PlaceInView& place);

  /// Whether a person, or fit(), has chosen from where the page in view is seen.
  bool has_view() const { return has_view_; }

  /// To be followed by show().
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;  ///< what was seen beside each page

 private:
  struct Stage {
    QMap<QString, bool> enabled;  // by the name of the display
    rviz::Config view;
  };

  Stage seen() const;
  void restore(const Stage& stage);
  void show_first(Page page);

  rviz::VisualizationManager& manager_;
  QMap<Page, Stage> stages_;
  std::optional<Page> page_;
  bool has_view_ = false;
};

}  // namespace scan_cell_rviz
