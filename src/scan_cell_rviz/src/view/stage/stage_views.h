// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/config.h>

#include <QMap>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>

#include "seat/page.h"
#include "seat/place_in_view.h"

namespace rviz {
class Property;
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
  /// @param scanning the cloud that grows stays in view: switched off it would begin anew
  void show(Page page, bool scanning = false);

  /// Turns no view, but goes as near as shows the whole place.
  /// @return false if rviz does not know the frame; then nothing changes
  bool fit(const PlaceInView& place);

  /// Whether a person, or fit(), has chosen from where the page in view is seen.
  bool has_view() const;

  /// To be followed by show().
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;  ///< what was seen beside each page

  /// Names of the displays that have pages; those of this package go by their class instead.
  static QStringList known_displays();

 private:
  struct Stage {
    QMap<QString, bool> shown;  // displays, by their name
    rviz::Config view;
    bool has_view = false;
  };

  void for_each_switch(
      const std::function<void(const QString& name, rviz::Property& shown)>& look) const;
  Stage seen() const;
  void restore(const Stage& stage);

  rviz::VisualizationManager& manager_;
  QMap<Page, Stage> stages_;
  std::optional<Page> page_;
  bool has_view_ = false;   // of the page in view, when it came or since it was fitted
  QString view_when_came_;  // as settings have it
  bool scanning_ = false;
};

}  // namespace scan_cell_rviz
