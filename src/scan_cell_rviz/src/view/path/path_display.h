// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/display.h>
#include <rviz/ogre_helpers/axes.h>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/point_cloud.h>

#include <memory>
#include <vector>

namespace rviz {
class FloatProperty;
}

namespace scan_cell_rviz {

/// The path edited by hand. Shapes tell waypoints apart, not only colours: balls are as adapted,
/// large cubes are edited, flat squares are deleted; chosen waypoints have axes.
class PathDisplay : public rviz::Display {
  Q_OBJECT

 public:
  PathDisplay();
  ~PathDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onInitialize() override;
  void onEnable() override { show(); }

 private Q_SLOTS:
  void show();
  void show_chosen();

 private:
  void draw_lines(float width);

  rviz::FloatProperty* size_;
  std::vector<std::unique_ptr<rviz::BillboardLine>> lines_;
  std::unique_ptr<rviz::PointCloud> adapted_, edited_, deleted_;
  std::vector<std::unique_ptr<rviz::Axes>> chosen_;
};

}  // namespace scan_cell_rviz
