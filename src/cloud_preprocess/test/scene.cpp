// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <pcl/common/transforms.h>

#include <algorithm>
#include <cmath>

namespace cloud_preprocess {

double Scene::Rectangle::inside(double px, double py) const {
  return std::min(width / 2 - std::abs(px - x), depth / 2 - std::abs(py - y));
}

void Scene::add(double x, double y, double z, Label label) {
  cloud_.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  labels_.push_back(label);
}

void Scene::add_surface(const Rectangle& area, double height, Label label,
                        const std::vector<Rectangle>& covered) {
  constexpr double kShadow = 5e-3;
  for (double y = area.y - area.depth / 2; y < area.y + area.depth / 2; y += kAcross) {
    for (double x = area.x - area.width / 2; x < area.x + area.width / 2; x += kAlongLine) {
      const bool hidden = std::any_of(covered.begin(), covered.end(), [&](const Rectangle& by) {
        return by.inside(x, y) > -kShadow;
      });
      if (!hidden) add(x + noise(), y + noise(), height + noise(), label);
    }
  }
}

void Scene::add_floor(const Rectangle& floor, const std::vector<Rectangle>& covered) {
  add_surface(floor, 0, Label::kFloor, covered);
}

void Scene::add_box(const Rectangle& box, double height, Label label) {
  add_surface(box, height, label, {});
  const auto wall_point = [&](double x, double y, double z) {
    add(x + noise(), y + noise(), z, z > kMargin ? label : Label::kFoot);
  };
  for (double z = 0.2e-3; z < height; z += 2e-3) {
    for (double along = -0.5; along < 0.5; along += kAlongLine / box.width) {
      wall_point(box.x + along * box.width, box.y - box.depth / 2, z);
      wall_point(box.x + along * box.width, box.y + box.depth / 2, z);
    }
    for (double along = -0.5; along < 0.5; along += kAcross / box.depth) {
      wall_point(box.x - box.width / 2, box.y + along * box.depth, z);
      wall_point(box.x + box.width / 2, box.y + along * box.depth, z);
    }
  }
}

void Scene::add_frame(const Rectangle& frame) {
  constexpr double kMoulding = 0.03, kRise = 0.02, kTop = 0.015, kRebate = 0.004, kInsert = 0.003;
  for (double y = frame.y - frame.depth / 2; y < frame.y + frame.depth / 2; y += kAcross) {
    for (double x = frame.x - frame.width / 2; x < frame.x + frame.width / 2; x += kAlongLine) {
      const double inside = frame.inside(x, y);
      double height = kInsert;
      if (inside < kRise) {
        height = kTop * std::sin(M_PI / 2 * inside / kRise);
      } else if (inside < kMoulding) {
        height = kTop + (kRebate - kTop) * (inside - kRise) / (kMoulding - kRise);
      }
      // Within three standard deviations of the margin, either answer is right.
      add(x + noise(), y + noise(), height + noise(),
          height > kMargin + 3 * kNoise ? Label::kPart : Label::kFoot);
    }
  }
}

void Scene::add_outliers(const Rectangle& area, double height, int count) {
  constexpr double kApart = 0.015;
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  for (int tries = 0; count > 0 && tries < 100000; ++tries) {
    const Eigen::Vector3f point(static_cast<float>(area.x + area.width * unit(generator_)),
                                static_cast<float>(area.y + area.depth * unit(generator_)),
                                static_cast<float>(height * (0.5 + unit(generator_))));
    const bool near = std::any_of(cloud_.begin(), cloud_.end(), [&](const pcl::PointXYZ& other) {
      return (other.getVector3fMap() - point).norm() < kApart;
    });
    if (near) continue;
    cloud_.push_back({point.x(), point.y(), point.z()});
    labels_.push_back(Label::kOutlier);
    --count;
  }
}

void Scene::move(const Eigen::Affine3f& by) {
  Cloud moved;
  pcl::transformPointCloud(cloud_, moved, by);
  cloud_ = moved;
}

int Scene::count(Label label) const {
  return static_cast<int>(std::count(labels_.begin(), labels_.end(), label));
}

double Scene::share_in(const Cloud& part, Label label) const {
  std::map<Key, Label> label_of;
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    label_of[{cloud_[i].x, cloud_[i].y, cloud_[i].z}] = labels_[i];
  }
  int found = 0;
  for (const pcl::PointXYZ& point : part) {
    found += label_of.at({point.x, point.y, point.z}) == label ? 1 : 0;
  }
  return static_cast<double>(found) / count(label);
}

}  // namespace cloud_preprocess
