// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "quality/uncertainty.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

namespace scan_calibration {
namespace {

/// Student's t over the normal distribution, at three standard deviations (Cornish and Fisher).
double widening(double freedom) {
  constexpr double z = 3;
  constexpr double kMinFreedom = 4;  // below it the expansion does not hold
  if (std::isinf(freedom)) return 1;
  const double f = std::max(freedom, kMinFreedom);
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  const double t = z + (z3 + z) / (4 * f) + (5 * z5 + 16 * z3 + 3 * z) / (96 * f * f) +
                   (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * f * f * f);
  return t / z;
}

/// Covariance of the shared unknowns by leaving out each view in turn; exact for a linear problem.
Eigen::MatrixXd jackknife_covariance(const ReducedSystem& system) {
  const auto count = static_cast<double>(system.views.size());
  Eigen::MatrixXd moves(system.information.rows(), static_cast<Eigen::Index>(system.views.size()));
  Eigen::Index column = 0;
  for (const ReducedView& view : system.views) {
    const Eigen::MatrixXd left = inverse_of_information(system.information - view.information);
    moves.col(column++) = left * view.gradient;
  }
  const Eigen::MatrixXd about_mean = moves.colwise() - moves.rowwise().mean();
  return (count - 1) / count * about_mean * about_mean.transpose();
}

/// The covariance by kind of noise.
std::vector<Eigen::MatrixXd> parts(const NormalEquations& equations, const ReducedSystem& system) {
  const Eigen::Index shared = system.covariance.rows();
  std::vector<Eigen::MatrixXd> result(equations.views.front().size(),
                                      Eigen::MatrixXd::Zero(shared, shared));
  for (std::size_t v = 0; v < equations.views.size(); ++v) {
    const Eigen::MatrixXd rows =
        joint_covariance(system.views[v], system.covariance).bottomRows(shared);
    for (std::size_t group = 0; group < result.size(); ++group)
      result[group] += system.factors[static_cast<Eigen::Index>(group)] * rows *
                       equations.views[v][group].matrix * rows.transpose();
  }
  return result;
}

double spread(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& covariance) {
  return std::max(0., (rows * covariance).cwiseProduct(rows).sum());
}

ScannerState moved_by(const ScannerState& state, const Layout& layout,
                      const Eigen::VectorXd& step) {
  ScannerState result = state;
  if (layout.camera >= 0) result.camera += step.segment<9>(layout.camera);
  if (layout.flange_to_camera >= 0)
    result.flange_to_camera =
        moved(state.flange_to_camera, step.segment<6>(layout.flange_to_camera));
  if (layout.base_to_board >= 0)
    result.base_to_board = moved(state.base_to_board, step.segment<6>(layout.base_to_board));
  if (layout.bend >= 0) result.bend += step.segment<3>(layout.bend);
  for (std::size_t laser = 0; laser < layout.planes.size(); ++laser)
    if (layout.planes[laser] >= 0) result.planes[laser] += step.segment<3>(layout.planes[laser]);
  return result;
}

/// Of the rotation vectors of up to a full turn (there are two), the one nearer to another vector.
Eigen::Vector3d vector_near(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& other) {
  const Eigen::Vector3d one = rotation_vector(rotation);
  if (!(one.norm() > 0)) return one;
  const Eigen::Vector3d two = one - 2 * M_PI * one.normalized();
  return (one - other).norm() <= (two - other).norm() ? one : two;
}

/// Names and values, in the same order.
class Numbers {
 public:
  /// @param reference rotation vectors are chosen near those of this model
  /// @param lasers of the planes
  Numbers(const ScannerState& state, const Layout& layout, const ScannerState& reference,
          const std::vector<std::string>& lasers) {
    if (layout.camera >= 0) add(state.camera);
    if (layout.flange_to_camera >= 0)
      add("flange_to_camera", state.flange_to_camera, reference.flange_to_camera);
    for (std::size_t laser = 0; laser < layout.planes.size(); ++laser)
      if (layout.planes[laser] >= 0)
        add(fmt::format("lasers[{}]", scan_cell_common::laser_index(lasers[laser])),
            state.planes[laser]);
    if (layout.base_to_board >= 0)
      add("base_to_board", state.base_to_board, reference.base_to_board);
    if (layout.bend >= 0)
      for (int i = 0; i < 3; ++i)
        add(fmt::format("board_bend[{}]", i), "m", state.bend[i]);
  }

  Eigen::VectorXd values() const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = parameters[i].value;
    return result;
  }

  std::vector<EstimatedParameter> parameters;

 private:
  void add(const std::string& name, const char* unit, double value) {
    parameters.push_back({name, unit, value, 0});
  }

  void add(const CameraVector& camera) {
    const char* const names[] = {"fx", "fy", "cx", "cy"};
    for (int i = 0; i < 4; ++i)
      add(std::string("camera.") + names[i], "px", camera[i]);
    for (int i = 0; i < 5; ++i)
      add(fmt::format("camera.distortion[{}]", i), "1", camera[4 + i]);
  }

  void add(const std::string& name, const Eigen::Isometry3d& pose,
           const Eigen::Isometry3d& reference) {
    const char* const axes[] = {"x", "y", "z"};
    const Eigen::Vector3d turn = vector_near(pose.linear(), rotation_vector(reference.linear()));
    for (int i = 0; i < 3; ++i)
      add(name + ".translation." + axes[i], "m", pose.translation()[i]);
    for (int i = 0; i < 3; ++i)
      add(name + ".rotation_vector." + axes[i], "rad", turn[i]);
  }

  void add(const std::string& name, const Eigen::Vector3d& plane) {
    for (int i = 0; i < 3; ++i)
      add(fmt::format("{}.normal[{}]", name, i), "1", -plane.normalized()[i]);
    add(name + ".distance", "m", -1 / plane.norm());
  }
};

}  // namespace

Knowledge::Knowledge(const JointEstimate& estimate, const BoardSurface& surface)
    : layout(estimate.choice, estimate.state.planes.size()),
      freedom(estimate.noise.freedom),
      views(static_cast<double>(estimate.views.size())) {
  const NormalEquations equations(estimate.views, surface, estimate.noise.levels, estimate.choice,
                                  estimate.state);
  const ReducedSystem system(equations, equations.noise);
  information = system.information;
  covariance = system.covariance;
  jackknife = jackknife_covariance(system);
  by_source = parts(equations, system);
}

double Knowledge::deviation(const Eigen::MatrixXd& rows) const {
  const double internal = spread(rows, covariance);
  const double external = spread(rows, jackknife);
  double doubt = 0;  // Welch and Satterthwaite: squared parts over their degrees of freedom
  for (std::size_t source = 0; source < by_source.size(); ++source) {
    const double part = spread(rows, by_source[source]);
    doubt += part * part / freedom[static_cast<Eigen::Index>(source)];
  }
  const double known_from =
      doubt > 0 ? internal * internal / doubt : std::numeric_limits<double>::infinity();
  return std::max(std::sqrt(internal) * widening(known_from),
                  std::sqrt(external) * widening(views - 1));
}

Eigen::MatrixXd derivative(const ScannerState& state, const Knowledge& knowledge,
                           const std::function<Eigen::VectorXd(const ScannerState&)>& quantity) {
  constexpr double kPart = 0.1;  // of a standard deviation, chosen: linear there
  const Eigen::Index size = knowledge.layout.size;
  Eigen::MatrixXd result(quantity(state).size(), size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double width = kPart * std::sqrt(knowledge.covariance(i, i));
    const Eigen::VectorXd step = width * Eigen::VectorXd::Unit(size, i);
    result.col(i) = (quantity(moved_by(state, knowledge.layout, step)) -
                     quantity(moved_by(state, knowledge.layout, -step))) /
                    (2 * width);
  }
  return result;
}

void state_parameters(const ScannerState& state, const Knowledge& knowledge,
                      const std::vector<std::string>& lasers,
                      std::vector<EstimatedParameter>& parameters, Eigen::MatrixXd& covariance) {
  parameters = Numbers(state, knowledge.layout, state, lasers).parameters;
  const Eigen::MatrixXd rows = derivative(state, knowledge, [&](const ScannerState& at) {
    return Numbers(at, knowledge.layout, state, lasers).values();
  });
  covariance = rows * knowledge.covariance * rows.transpose();
  Eigen::VectorXd scale(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    double& deviation = parameters[static_cast<std::size_t>(i)].deviation;
    deviation = knowledge.deviation(rows.row(i));
    scale[i] = covariance(i, i) > 0 ? deviation / std::sqrt(covariance(i, i)) : 1;
  }
  covariance = scale.asDiagonal() * covariance * scale.asDiagonal();
}

}  // namespace scan_calibration
