// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/collision_scene.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <fmt/format.h>
#include <octomap/OcTree.h>

#include <algorithm>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::UnusableInput;
using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using Kind = CellShape::Kind;

constexpr const char* kTip = "tool_tip";
constexpr const char* kPart = "part";

struct Body {
  std::string name;
  Kind kind;  // of primitives
  bool primitive = true;
  std::size_t link = 0;  // it moves with this index of RobotModel::links_at(); one beyond: the tip
  Eigen::Isometry3d pose;  // in the link, or in base_link
  std::unique_ptr<fcl::CollisionObjectd> object;
};

/// @param grown [m] on all sides
Geometry geometry_of(const CellShape& shape, double grown) {
  switch (shape.kind) {
    case Kind::kSphere:
      return std::make_shared<fcl::Sphered>(shape.size.x() + grown);
    case Kind::kBox:
      return std::make_shared<fcl::Boxd>(
          Eigen::Vector3d(shape.size + Eigen::Vector3d::Constant(2 * grown)));
    case Kind::kCapsule:
      return std::make_shared<fcl::Capsuled>(shape.size.x() + grown, shape.size.y());
    case Kind::kHalfSpace:
      break;
  }
  return std::make_shared<fcl::Halfspaced>(shape.size, 0);
}

/// Whether FCL computes the exact depth for this pair.
bool depth_is_known(const Body& a, const Body& b) {
  if (!a.primitive || !b.primitive) return false;
  const auto either = [&](Kind kind) { return a.kind == kind || b.kind == kind; };
  return either(Kind::kHalfSpace) || either(Kind::kSphere) ||
         (a.kind == b.kind && either(Kind::kBox));
}

Body body_of(const CellShape& shape, double grown) {
  Body body;
  body.name = shape.name;
  body.kind = shape.kind;
  body.pose = shape.pose;
  body.object = std::make_unique<fcl::CollisionObjectd>(geometry_of(shape, grown), shape.pose);
  return body;
}

std::string listed(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

struct CollisionScene::Bodies {
  const RobotModel& robot;
  std::set<std::pair<std::string, std::string>> may_touch;
  std::vector<Body> moving;
  std::vector<Body> standing;

  bool may_meet(const Body& body, const Body& other) const {
    const bool contact_of_tool = other.name == kPart && body.link == robot.link_names().size();
    return !contact_of_tool && may_touch.count(std::minmax(body.name, other.name)) == 0;
  }

  void add_shape(const CellShape& shape, double clearance) {
    if (shape.frame == "base_link") {
      standing.push_back(body_of(shape, 0));
      return;
    }
    std::vector<std::string> frames = robot.link_names();
    frames.emplace_back(kTip);
    const auto frame = std::find(frames.begin(), frames.end(), shape.frame);
    if (frame == frames.end()) {
      throw UnusableInput("frame of " + shape.name, "'" + shape.frame + "'",
                          "give base_link or one of " + listed(frames));
    }
    moving.push_back(body_of(shape, clearance));
    moving.back().link = static_cast<std::size_t>(frame - frames.begin());
  }

  void add_link(const LinkCapsule& capsule, double clearance) {
    const std::vector<std::string>& links = robot.link_names();
    const auto link = std::find(links.begin(), links.end(), capsule.link);
    if (link == links.end())
      throw UnusableInput("link", "'" + capsule.link + "'", "give one of " + listed(links));
    const auto index = static_cast<std::size_t>(link - links.begin());
    const Eigen::Vector3d line = robot.next_origin(index);
    CellShape shape;
    shape.name = capsule.link;
    shape.kind = line.norm() > 0 ? Kind::kCapsule : Kind::kSphere;
    shape.size = {capsule.radius, line.norm(), 0};
    shape.pose = Eigen::Translation3d(line / 2) *
                 Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), line);
    moving.push_back(body_of(shape, clearance));
    moving.back().link = index;
  }

  void set_part(const Geometry& geometry) {
    const auto is_part = [](const Body& body) { return body.name == kPart; };
    standing.erase(std::remove_if(standing.begin(), standing.end(), is_part), standing.end());
    geometry->computeLocalAABB();
    Body part;
    part.name = kPart;
    part.primitive = false;
    part.object = std::make_unique<fcl::CollisionObjectd>(geometry);
    standing.push_back(std::move(part));
  }
};

CollisionScene::CollisionScene(const RobotModel& robot, const CellShapes& shapes)
    : bodies_(new Bodies{robot, shapes.may_touch, {}, {}}) {
  for (const CellShape& shape : shapes.shapes)
    bodies_->add_shape(shape, shapes.clearance);
  for (const LinkCapsule& link : shapes.links)
    bodies_->add_link(link, shapes.clearance);
}

CollisionScene::~CollisionScene() = default;

void CollisionScene::set_part(const std::vector<Eigen::Vector3d>& vertices,
                              const std::vector<std::array<std::size_t, 3>>& triangles) {
  if (triangles.empty()) throw UnusableInput("part", "no triangles", "give a mesh");
  std::vector<fcl::Triangle> corners;
  for (const auto& [a, b, c] : triangles) {
    if (std::max({a, b, c}) >= vertices.size()) {
      throw UnusableInput(
          "part",
          fmt::format("a triangle with vertex {} of {}", std::max({a, b, c}), vertices.size()),
          "give triangles of the part's own vertices");
    }
    corners.emplace_back(a, b, c);
  }
  for (const Eigen::Vector3d& vertex : vertices) {
    if (!vertex.allFinite())
      throw UnusableInput("part", "a vertex that is not finite", "remove it");
  }
  const auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel(static_cast<int>(corners.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, corners);
  model->endModel();
  bodies_->set_part(model);
}

void CollisionScene::set_part(const std::vector<Eigen::Vector3d>& points, double size) {
  constexpr double kLeast = 1e-4;  // [m] an octree of 16 levels spans 6.5 m of these
  if (points.empty()) throw UnusableInput("part", "no points", "give a cloud of the part");
  if (!(size >= kLeast))
    throw UnusableInput("cells of the part", fmt::format("{:g} m", size), "give 1e-4 m or more");
  const auto tree = std::make_shared<octomap::OcTree>(size);
  for (const Eigen::Vector3d& point : points) {
    octomap::OcTreeKey key;
    if (!point.allFinite() || !tree->coordToKeyChecked(point.x(), point.y(), point.z(), key)) {
      throw UnusableInput(
          "part", fmt::format("a point at {:g} {:g} {:g} m", point.x(), point.y(), point.z()),
          "remove it: it is too far away, or not finite");
    }
    tree->updateNode(key, true, true);
  }
  tree->updateInnerOccupancy();
  bodies_->set_part(std::make_shared<fcl::OcTreed>(tree));
}

std::vector<Collision> CollisionScene::collisions(const Joints& joints,
                                                  const Eigen::Isometry3d& flange_to_tip) const {
  std::vector<Eigen::Isometry3d> links = bodies_->robot.links_at(joints);
  links.push_back(links.back() * flange_to_tip);
  std::vector<Collision> found;
  for (const Body& body : bodies_->moving) {
    body.object->setTransform(links[body.link] * body.pose);
    body.object->computeAABB();
    for (const Body& other : bodies_->standing) {
      if (!body.object->getAABB().overlap(other.object->getAABB())) continue;
      if (!bodies_->may_meet(body, other)) continue;
      const bool depth = depth_is_known(body, other);
      const fcl::CollisionRequestd request(1, depth);
      fcl::CollisionResultd result;
      if (fcl::collide(body.object.get(), other.object.get(), request, result) == 0) continue;
      found.push_back({body.name, other.name});
      if (depth) found.back().depth = result.getContact(0).penetration_depth;
    }
  }
  return found;
}

}  // namespace c4g_driver
