// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/display.h>
#include <rviz/ogre_helpers/point_cloud.h>

#include <memory>

#include "edit/edit_session.h"

namespace rviz {
class FloatProperty;
}

namespace scan_cell_rviz {

/// The cloud that is cleaned by hand: what stays, and each in a colour of its own what the
/// automatic stages would take and what the last edit took.
class EditDisplay : public rviz::Display {
  Q_OBJECT

 public:
  EditDisplay();
  ~EditDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onInitialize() override;
  void onEnable() override { show(); }

 private Q_SLOTS:
  void show();

 private:
  rviz::FloatProperty* size_;
  std::unique_ptr<rviz::PointCloud> kept_;
  std::unique_ptr<rviz::PointCloud> taken_;
  EditedViewPtr view_;  // that is drawn
};

}  // namespace scan_cell_rviz
