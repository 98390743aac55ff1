// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreFrameListener.h>
#include <rviz/display.h>

#include <chrono>
#include <memory>

#include "edit/edit_session.h"
#include "view/scan/cloud_pieces.h"

namespace rviz {
class FloatProperty;
}

namespace scan_cell_rviz {

/// The cloud cleaned by hand: what stays, what each automatic stage would remove and what the last
/// edit took, each in its own colour. If the computer is too slow for all points, some are drawn,
/// and the status tells how many.
class EditDisplay : public rviz::Display, private Ogre::FrameListener {
  Q_OBJECT

 public:
  EditDisplay();
  ~EditDisplay() override;

  /// What is drawn, within this computer's limits; null: drawing is not finished.
  EditedViewPtr drawn() const { return is_drawn_ ? view_ : nullptr; }

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onInitialize() override;
  void onEnable() override { show(); }

 private Q_SLOTS:
  void show();

 private:
  bool frameStarted(const Ogre::FrameEvent& event) override;
  bool frameEnded(const Ogre::FrameEvent& event) override;

  rviz::FloatProperty* size_;
  std::unique_ptr<CloudPieces> pieces_;
  EditedViewPtr view_;  // drawn, or to be drawn
  bool is_drawn_ = false;
  std::chrono::steady_clock::time_point picture_began_;
};

}  // namespace scan_cell_rviz
