// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include <memory>
#include <string>

#include "seat/seat.h"
#include "seat/seat_links.h"
#include "view/passes/pass_handles.h"
#include "view/path/waypoint_handles.h"
#include "view/scan/box_handles.h"
#include "view/stage/stage_views.h"

namespace scan_cell_rviz {

/// The seat as an rviz panel. It asks before the window closes during a scan or work.
class SeatPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit SeatPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  /// @return whether the window may close
  bool may_close();
  bool may_lose_edits();
  void apply_config();
  void use_tool(const QString& name);
  void show_handles(const char* name, const std::string& topic);
  void show_topic(const QString& type, const char* name, const char* property,
                  const std::string& topic);
  void show_path();
  void show_pose(int pose);
  void show_run(const QString& run);
  void show_page(Page page);
  void fit_view();
  void fit_view_once();
  void look_at(double x, double y, double z, const QString& frame);

  std::unique_ptr<SeatLinks> links_;
  std::unique_ptr<BoxHandles> box_;
  std::unique_ptr<WaypointHandles> waypoint_;
  std::unique_ptr<PassHandles> passes_;
  std::unique_ptr<StageViews> views_;
  Seat* seat_ = nullptr;
  QString run_;  // in view
  QString person_;
  QString pose_file_;
  rviz::Config kept_views_;  // as in the settings
};

}  // namespace scan_cell_rviz
