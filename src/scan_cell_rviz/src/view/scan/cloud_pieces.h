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

/// A large cloud in the scene, of which as many points are drawn as the computer draws in time.
/// Each piece has points from all over the cloud, so some of the pieces are the cloud thinned. They
/// are handed to the graphics system a few at each turn of the window, which never waits for all.
class CloudPieces {
 public:
  using Cloud = cloud_preprocess::Cloud;
  /// How each point looks: 0 is not drawn, others count the colours from 1.
  using Looks = std::vector<std::uint8_t>;

  /// @param node outlives this; has the pose of the cloud's frame
  /// @param colours at most 255
  CloudPieces(Ogre::SceneNode& node, std::vector<Ogre::ColourValue> colours);
  ~CloudPieces();
  CloudPieces(const CloudPieces&) = delete;
  CloudPieces& operator=(const CloudPieces&) = delete;

  void set_size(float pixels);  ///< of a point

  /// From now on; draw() brings it about.
  /// @param cloud [m] in the node's frame
  /// @param looks of each of its points
  void show(std::shared_ptr<const Cloud> cloud, Looks looks);

  /// To be called at each turn of the window.
  /// @return whether what is drawn is as it was asked for
  bool draw();

  /// Draws more points or fewer from the next turn on.
  /// @param seconds that the last picture took
  void follow(double seconds);

  double share() const;  ///< of the cloud's points that are drawn, 0 .. 1

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
  std::size_t drawn_;  // pieces, at most
};

}  // namespace scan_cell_rviz
