// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreColourValue.h>
#include <rviz/ogre_helpers/point_cloud.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "cloud_preprocess/cloud_edits.h"

namespace Ogre {
class SceneNode;
}  // namespace Ogre

namespace scan_cell_rviz {

/// A large cloud in the scene, of which only as many points are drawn as the computer can draw in
/// time. Each piece has points from all over the cloud, so a few pieces are the thinned cloud. A
/// few pieces per turn of the window go to the graphics system, so the window never waits for all.
class CloudPieces {
 public:
  using Cloud = cloud_preprocess::Cloud;
  /// Appearance of each point: 0 is not drawn, others are colour numbers from 1.
  using Looks = std::vector<std::uint8_t>;

  /// @param node outlives this; has the pose of the cloud's frame
  /// @param colours at most 255
  CloudPieces(Ogre::SceneNode& node, std::vector<Ogre::ColourValue> colours);
  ~CloudPieces();
  CloudPieces(const CloudPieces&) = delete;
  CloudPieces& operator=(const CloudPieces&) = delete;

  void set_size(float pixels);  ///< of a point

  /// Sets what to show; draw() draws it.
  /// @param cloud [m] in the node's frame
  /// @param looks one per point
  void show(std::shared_ptr<const Cloud> cloud, Looks looks);

  /// Call it at each turn of the window.
  /// @return whether the drawing is up to date
  bool draw();

  /// Adapts the number of points drawn from the next turn on.
  /// @param seconds time of the last picture
  void follow(double seconds);

  double share() const;  ///< of the cloud's points drawn, 0 to 1

 private:
  struct Piece {
    std::unique_ptr<rviz::PointCloud> points;
    bool is_current = false;
  };

  void fill(std::size_t piece);
  void set_count(std::size_t count);

  Ogre::SceneNode& node_;
  std::vector<Ogre::ColourValue> colours_;
  float size_ = 1;  // [pixels]
  std::shared_ptr<const Cloud> cloud_;
  Looks looks_;
  std::vector<Piece> pieces_;
  std::size_t drawn_;  // greatest number of pieces
};

}  // namespace scan_cell_rviz
