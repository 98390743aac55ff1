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

/// The displays and the view beside each page of the seat: at first the subject of the page, later
/// as a person left it. Displays that are neither in the cell's settings nor of this package stay
/// as they are until a person leaves a page with them.
class StageViews {
 public:
  /// @param manager outlives this
  explicit StageViews(rviz::VisualizationManager& manager) : manager_(manager) {}

  /// Stores the view of the page before, and restores that of this page.
  /// @param scanning keeps the growing cloud in view: switched off, it would start over
  void show(Page page, bool scanning = false);

  /// Moves the view, without turning it, so that it just shows the whole place.
  /// @return false: rviz does not know the frame, and nothing changes
  bool fit(const PlaceInView& place);

  /// Whether a person or fit() has chosen the view of this page.
  bool has_view() const;

  /// show() must follow.
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;  ///< views of all pages

  /// Names of the displays that have pages, without those of this package, which are known by
  /// class.
  static QStringList known_displays();

 private:
  struct Stage {
    QMap<QString, bool> shown;  // by display name
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
  bool has_view_ = false;   // of the page in view, from before or by fit()
  QString view_when_came_;  // as in settings
  bool scanning_ = false;
};

}  // namespace scan_cell_rviz
