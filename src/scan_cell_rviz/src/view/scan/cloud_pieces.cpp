// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/scan/cloud_pieces.h"

#include <OgreSceneNode.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "edit/scatter.h"

namespace scan_cell_rviz {
namespace {

constexpr std::size_t kPoints = 1 << 14;         // of a piece, approximately: filled in 1 ms
constexpr std::size_t kFewest = 3;               // pieces drawn on any computer; chosen
constexpr std::chrono::milliseconds kATurn{10};  // of the window, for filling; chosen
constexpr double kPicture = 0.025;  // [s] for a picture: with filling within the goal of 50 ms

}  // namespace

CloudPieces::CloudPieces(Ogre::SceneNode& node, std::vector<Ogre::ColourValue> colours)
    : node_(node), colours_(std::move(colours)), drawn_(kFewest) {}

CloudPieces::~CloudPieces() {
  set_count(0);
}

void CloudPieces::set_size(float pixels) {
  if (pixels == size_) return;
  size_ = pixels;
  for (const Piece& piece : pieces_)
    piece.points->setDimensions(size_, size_, size_);
}

void CloudPieces::show(std::shared_ptr<const Cloud> cloud, Looks looks) {
  if (cloud == cloud_ && looks == looks_) return;
  if (cloud != cloud_) {
    set_count(0);  // no old piece beside new ones
    set_count((cloud->size() + kPoints - 1) / kPoints);
  }
  for (Piece& piece : pieces_)
    piece.is_current = false;
  cloud_ = std::move(cloud);
  looks_ = std::move(looks);
}

void CloudPieces::set_count(std::size_t count) {
  while (pieces_.size() > count) {
    if (pieces_.back().points->isAttached()) node_.detachObject(pieces_.back().points.get());
    pieces_.pop_back();
  }
  while (pieces_.size() < count) {
    Piece& piece = pieces_.emplace_back();
    piece.points = std::make_unique<rviz::PointCloud>();
    piece.points->setName("piece " + std::to_string(pieces_.size()));  // Ogre needs different names
    piece.points->setRenderMode(rviz::PointCloud::RM_POINTS);
    piece.points->setDimensions(size_, size_, size_);
  }
}

bool CloudPieces::draw() {
  const auto until = std::chrono::steady_clock::now() + kATurn;
  bool is_current = true;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool is_drawn = i < drawn_;
    if (!is_drawn && pieces_[i].points->isAttached()) node_.detachObject(pieces_[i].points.get());
    if (is_drawn && pieces_[i].is_current && !pieces_[i].points->isAttached())
      node_.attachObject(pieces_[i].points.get());
    if (!is_drawn || pieces_[i].is_current) continue;
    if (std::chrono::steady_clock::now() < until)
      fill(i);
    else
      is_current = false;
  }
  return is_current;
}

/// The time of a picture grows at most in proportion to what is drawn, so an increase is not
/// reverted at once.
void CloudPieces::follow(double seconds) {
  constexpr double kStep = 1.5;  // chosen
  if (seconds > kPicture)
    drawn_ = static_cast<std::size_t>(static_cast<double>(drawn_) * kPicture / seconds);
  else if (kStep * seconds < kPicture)
    drawn_ += (drawn_ + 1) / 2;
  drawn_ = std::clamp(drawn_, kFewest, std::max(kFewest, pieces_.size()));
}

double CloudPieces::share() const {
  if (pieces_.empty()) return 1;
  return static_cast<double>(std::min(drawn_, pieces_.size())) /
         static_cast<double>(pieces_.size());
}

/// Fills the piece detached: rviz would also attach each of its buffers and draw them twice,
/// whether the piece is visible or not.
void CloudPieces::fill(std::size_t piece) {
  std::vector<rviz::PointCloud::Point> drawn;
  drawn.reserve(kPoints);
  for (std::size_t number = 0; number * pieces_.size() < cloud_->size(); ++number) {
    const std::size_t i = scattered(piece, number, pieces_.size());
    if (i >= cloud_->size() || looks_[i] == 0) continue;
    const auto& point = (*cloud_)[i];
    drawn.push_back({Ogre::Vector3(point.x, point.y, point.z), colours_[looks_[i] - 1U]});
  }
  rviz::PointCloud& shown = *pieces_[piece].points;
  if (shown.isAttached()) node_.detachObject(&shown);
  shown.clear();
  if (!drawn.empty()) shown.addPoints(drawn.data(), static_cast<std::uint32_t>(drawn.size()));
  node_.attachObject(&shown);
  pieces_[piece].is_current = true;
}

}  // namespace scan_cell_rviz
