// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic_parts.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <cmath>
#include <stdexcept>

namespace synthetic {
namespace {

constexpr double kDifference = 1e-6;  // [m] for derivatives

Eigen::Matrix3d frame_about(const Eigen::Vector3d& normal, const Eigen::Vector3d& along) {
  Eigen::Matrix3d frame;
  frame.col(2) = normal;
  frame.col(1) = normal.cross(along).normalized();
  frame.col(0) = frame.col(1).cross(normal);
  return frame;
}

/// The rotation nearest to the deformation's derivative.
Eigen::Matrix3d turn_of(const Deformation& deformation, const Eigen::Vector3d& at,
                        const Eigen::Matrix3d& rotation) {
  Eigen::Matrix3d derivative = Eigen::Matrix3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kDifference * Eigen::Vector3d::Unit(axis);
    derivative.col(axis) += (deformation(at + step) - deformation(at - step)) / (2 * kDifference);
  }
  // The normal stays normal to the surface, the first axis stays along the path.
  const Eigen::Vector3d normal = (derivative.inverse().transpose() * rotation.col(2)).normalized();
  return frame_about(normal, derivative * rotation.col(0));
}

}  // namespace

Eigen::Vector3d Part::normal(double x, double y) const {
  const double slope_x =
      (height(x + kDifference, y) - height(x - kDifference, y)) / (2 * kDifference);
  const double slope_y =
      (height(x, y + kDifference) - height(x, y - kDifference)) / (2 * kDifference);
  return Eigen::Vector3d(-slope_x, -slope_y, 1).normalized();
}

Part photo_frame(double rosette) {
  constexpr double kMoulding = 0.025;
  Part part;
  part.width = 0.200;
  part.depth = 0.150;
  const auto from_rim = [](double x, double y) {
    return std::min(0.100 - std::abs(x), 0.075 - std::abs(y));
  };
  part.inside = [from_rim](double x, double y) {
    const double rim = from_rim(x, y);
    return rim >= 0 && rim <= kMoulding;
  };
  part.height = [from_rim, rosette](double x, double y) {
    const double across = from_rim(x, y) / kMoulding;
    const double moulding = 0.006 + 0.014 * std::pow(std::sin(M_PI * (0.15 + 0.7 * across)), 2);
    const double away = std::hypot(x - 0.055, y - 0.0625) / 0.006;
    return moulding + rosette * std::exp(-away * away);
  };
  part.path_position = [height = part.height](double a) {
    const double half_x = 0.0875;
    const double half_y = 0.0625;
    const double length = 4 * (half_x + half_y);
    double s = a * length;
    Eigen::Vector2d at;
    if (s < 2 * half_x) {
      at = {-half_x + s, -half_y};
    } else if ((s -= 2 * half_x) < 2 * half_y) {
      at = {half_x, -half_y + s};
    } else if ((s -= 2 * half_y) < 2 * half_x) {
      at = {half_x - s, half_y};
    } else {
      at = {-half_x, half_y - (s - 2 * half_x)};
    }
    return Eigen::Vector3d(at.x(), at.y(), height(at.x(), at.y()));
  };
  return part;
}

Part curved_panel() {
  Part part;
  part.width = 0.300;
  part.depth = 0.200;
  part.inside = [](double x, double y) { return std::abs(x) <= 0.150 && std::abs(y) <= 0.100; };
  part.height = [](double x, double y) {
    return 1.2 * x * x - 0.8 * y * y + 4 * x * x * x + 0.5 * x * y + 3 * y * y * x +
           0.004 * std::sin(25 * x + 1) * std::cos(20 * y);
  };
  part.path_position = [height = part.height](double a) {
    const double x = -0.12 + 0.24 * a;
    const double y = 0.06 * std::sin(9 * a);
    return Eigen::Vector3d(x, y, height(x, y));
  };
  return part;
}

Part box_lid() {
  Part part;
  part.width = 0.180;
  part.depth = 0.120;
  part.inside = [](double x, double y) { return std::abs(x) <= 0.090 && std::abs(y) <= 0.060; };
  part.height = [](double x, double y) {
    const double rim = std::min(0.090 - std::abs(x), 0.060 - std::abs(y));
    return 0.030 * std::min(1.0, rim / 0.005);
  };
  part.path_position = [](double a) { return Eigen::Vector3d(-0.07 + 0.14 * a, 0.03, 0.030); };
  return part;
}

Deformation no_deformation() {
  return [](const Eigen::Vector3d&) { return Eigen::Vector3d::Zero().eval(); };
}

Deformation bend(double rise, double width) {
  return [rise, width](const Eigen::Vector3d& at) {
    const double across = 2 * at.x() / width;
    return Eigen::Vector3d(0, 0, rise * (1 - across * across));
  };
}

Points scan(const Part& part, const Similarity& similarity, const Deformation& deformation,
            const Scan& how) {
  std::mt19937 engine(how.seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::normal_distribution<double> normal(0, 1);
  Points points;
  for (std::size_t tries = 0; points.size() < how.points; ++tries) {
    if (tries > 1000 * how.points) throw std::logic_error("nothing of the part is seen");
    const double x = part.width * uniform(engine);
    const double y = part.depth * uniform(engine);
    if (!part.inside(x, y)) continue;
    if (how.uneven && uniform(engine) + 0.5 > 0.25 + 0.75 * (x / part.width + 0.5)) continue;
    const Eigen::Vector3d at(x, y, part.height(x, y));
    if (how.is_hole && how.is_hole(at)) continue;
    if (part.normal(x, y).dot(how.view.normalized()) < how.min_facing) continue;
    const Eigen::Vector3d noise =
        how.noise * Eigen::Vector3d(normal(engine), normal(engine), normal(engine));
    points.push_back(similarity * (at + deformation(at)) + noise);
  }
  for (std::size_t i = 0; i < how.outliers; ++i) {
    const double x = uniform(engine), y = uniform(engine), z = uniform(engine);
    points.push_back(similarity *
                     Eigen::Vector3d(1.2 * part.width * x, 1.2 * part.depth * y, 0.1 * z));
  }
  return points;
}

Points scan_mesh(const pcl::PolygonMesh& mesh, const Similarity& similarity, const Scan& how) {
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  const auto corner = [&](const pcl::Vertices& polygon, std::size_t i) {
    return Eigen::Vector3d(
        vertices[static_cast<std::size_t>(polygon.vertices[i])].getVector3fMap().cast<double>());
  };
  std::vector<double> areas;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    const Eigen::Vector3d a = corner(polygon, 0);
    areas.push_back((corner(polygon, 1) - a).cross(corner(polygon, 2) - a).norm());
  }
  std::mt19937 engine(how.seed);
  std::discrete_distribution<std::size_t> triangle(areas.begin(), areas.end());
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, how.noise);
  Points points;
  for (std::size_t i = 0; i < how.points; ++i) {
    const pcl::Vertices& polygon = mesh.polygons[triangle(engine)];
    const double edge = std::sqrt(uniform(engine));
    const double along = uniform(engine);
    const Eigen::Vector3d at = (1 - edge) * corner(polygon, 0) +
                               edge * (1 - along) * corner(polygon, 1) +
                               edge * along * corner(polygon, 2);
    const Eigen::Vector3d noise(normal(engine), normal(engine), normal(engine));
    points.push_back(similarity * at + noise);
  }
  return points;
}

ToolPath path_on(const Part& part, std::size_t count) {
  ToolPath path;
  path.name = "synthetic";
  path.has_orientation = true;
  path.process_names = {"speed", "force"};
  path.segments = {{"first", {}}, {"second", {}}};
  for (std::size_t i = 0; i < count; ++i) {
    const double a = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const Eigen::Vector3d at = part.path_position(a);
    const Eigen::Vector3d ahead = part.path_position(a + 1e-5) - part.path_position(a - 1e-5);
    tool_path_stretcher::Waypoint waypoint;
    waypoint.pose.translation() = at;
    waypoint.pose.linear() = frame_about(part.normal(at.x(), at.y()), ahead);
    waypoint.process_values = {0.1 + 0.001 * static_cast<double>(i), 20};
    path.segments[2 * i < count ? 0 : 1].waypoints.push_back(waypoint);
  }
  return path;
}

ToolPath truth(const ToolPath& path, const Similarity& similarity, const Deformation& deformation) {
  ToolPath result = path;
  for (auto& segment : result.segments) {
    for (auto& waypoint : segment.waypoints) {
      const Eigen::Vector3d at = waypoint.pose.translation();
      waypoint.pose.linear() =
          similarity.rotation * turn_of(deformation, at, waypoint.pose.linear());
      waypoint.pose.translation() = similarity * (at + deformation(at));
    }
  }
  return result;
}

Similarity similarity(double scale, const Eigen::Matrix3d& rotation,
                      const Eigen::Vector3d& translation) {
  Similarity result;
  result.scale = scale;
  result.rotation = rotation;
  result.translation = translation;
  return result;
}

Eigen::Matrix3d random_rotation(unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0, 1);
  const double w = normal(engine), x = normal(engine), y = normal(engine), z = normal(engine);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

PathError error_of(const ToolPath& path, const ToolPath& truth) {
  PathError error;
  double count = 0;
  for (std::size_t s = 0; s < truth.segments.size(); ++s) {
    for (std::size_t w = 0; w < truth.segments[s].waypoints.size(); ++w) {
      const Eigen::Isometry3d& is = path.segments.at(s).waypoints.at(w).pose;
      const Eigen::Isometry3d& should = truth.segments[s].waypoints[w].pose;
      const double distance = (is.translation() - should.translation()).norm();
      const double angle = Eigen::AngleAxisd(is.linear().transpose() * should.linear()).angle();
      error.rms += distance * distance;
      error.max = std::max(error.max, distance);
      error.orientation += angle * angle;
      count += 1;
    }
  }
  error.rms = std::sqrt(error.rms / count);
  error.orientation = std::sqrt(error.orientation / count);
  return error;
}

}  // namespace synthetic
