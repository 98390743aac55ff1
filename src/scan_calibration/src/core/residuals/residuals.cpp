// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/residuals.h"

#include <cmath>

namespace scan_calibration {
namespace {

template <int Columns>
using Rows = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::RowMajor>>;

enum Block { kCamera, kFlangeToCamera, kBaseToBoard, kBend, kFlange, kPlane };

struct Moved {
  Moved(const ResidualContext& context, const BoardView& view, double const* const* parameters)
      : state(context.reference) {
    state.camera = Eigen::Map<const CameraVector>(parameters[kCamera]);
    state.bend = Eigen::Map<const Eigen::Vector3d>(parameters[kBend]);
    sight = board_sight(state.flange_to_camera, state.base_to_board, view.measured,
                        Eigen::Map<const Vector6d>(parameters[kFlangeToCamera]),
                        Eigen::Map<const Vector6d>(parameters[kBaseToBoard]),
                        Eigen::Map<const Vector6d>(parameters[kFlange]));
  }
  ScannerState state;
  BoardSight sight;
};

/// Writes rows of the derivative by the three poses, from the derivative by the board's pose in the
/// camera.
template <int Count>
void write_poses(const Eigen::Matrix<double, Count, 6>& by_sight, const BoardSight& sight,
                 Eigen::Index row, Eigen::Index rows, double** jacobians) {
  const Eigen::Matrix<double, Count, 18> by_motions = by_sight * sight.by_motions;
  const Block blocks[] = {kFlangeToCamera, kBaseToBoard, kFlange};
  for (int i = 0; i < 3; ++i) {
    if (jacobians[blocks[i]] == nullptr) continue;
    Rows<6>(jacobians[blocks[i]], rows, 6).template middleRows<Count>(row) =
        by_motions.template middleCols<6>(6 * i);
  }
}

template <int Columns, typename Derived>
void write(const Eigen::MatrixBase<Derived>& derivative, Block block, Eigen::Index row,
           Eigen::Index rows, double** jacobians) {
  if (jacobians[block] == nullptr) return;
  Rows<Columns>(jacobians[block], rows, Columns).middleRows(row, derivative.rows()) = derivative;
}

}  // namespace

CornerResiduals::CornerResiduals(const ResidualContext& context, const BoardView& view)
    : context_(context), view_(view) {
  set_num_residuals(2 * static_cast<int>(view.pixels.size()));
  *mutable_parameter_block_sizes() = {9, 6, 6, 3, 6};
}

bool CornerResiduals::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  const Moved moved(context_, view_, parameters);
  const Eigen::Index rows = num_residuals();
  Projection projection;
  for (std::size_t i = 0; i < view_.pixels.size(); ++i) {
    const double scale = std::sqrt(view_.weights[i]) / context_.noise.corner_px;
    const Eigen::Vector3d lever =
        moved.sight.rotation * on_board(context_.surface, moved.state.bend, view_.places[i]);
    if (!project(moved.state.camera, lever + moved.sight.position, projection)) return false;
    const auto row = static_cast<Eigen::Index>(2 * i);
    Eigen::Map<Eigen::Vector2d>(residuals + row) = scale * (projection.pixel - view_.pixels[i]);
    if (jacobians == nullptr) continue;
    const Eigen::Matrix<double, 2, 3> by_point = scale * projection.by_point;
    Eigen::Matrix<double, 2, 6> by_sight;
    for (int k = 0; k < 2; ++k)  // u . (turn x lever) = turn . (lever x u)
      by_sight.row(k).head<3>() = lever.cross(by_point.row(k).transpose());
    by_sight.rightCols<3>() = by_point;
    write_poses<2>(by_sight, moved.sight, row, rows, jacobians);
    write<9>(scale * projection.by_camera, kCamera, row, rows, jacobians);
    write<3>(by_point * moved.sight.rotation.col(2) *
                 context_.surface.basis(view_.places[i]).transpose(),
             kBend, row, rows, jacobians);
  }
  return true;
}

LineResiduals::LineResiduals(const ResidualContext& context, const BoardView& view,
                             std::size_t index, std::size_t laser)
    : context_(context), view_(view), laser_(laser) {
  const LinePoints& line = view.lines[laser];
  set_num_residuals(static_cast<int>(line.pixels.size()));
  *mutable_parameter_block_sizes() = {9, 6, 6, 3, 6, 3};
  const BoardSight sight = sight_of(context.reference, view, index);
  LineOffset offset;
  for (std::size_t i = 0; i < line.pixels.size(); ++i) {
    const bool usable = line_offset(context.reference, context.surface, sight, line.pixels[i],
                                    context.reference.planes[laser], offset);
    scale_.push_back(usable ? std::sqrt(line.weights[i]) / offset.by_pixel.norm() /
                                  context.noise.line_px[laser]
                            : 0);
  }
}

bool LineResiduals::Evaluate(double const* const* parameters, double* residuals,
                             double** jacobians) const {
  const Moved moved(context_, view_, parameters);
  const Eigen::Vector3d plane = Eigen::Map<const Eigen::Vector3d>(parameters[kPlane]);
  const Eigen::Index rows = num_residuals();
  const std::vector<Eigen::Vector2d>& pixels = view_.lines[laser_].pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double scale = scale_[i];
    LineOffset offset;  // zero, for what is left out
    if (scale > 0 &&
        !line_offset(moved.state, context_.surface, moved.sight, pixels[i], plane, offset)) {
      return false;
    }
    residuals[i] = scale * offset.value;
    if (jacobians == nullptr) continue;
    write_poses<1>(scale * offset.by_sight.transpose(), moved.sight, row, rows, jacobians);
    write<9>(scale * offset.by_camera.transpose(), kCamera, row, rows, jacobians);
    write<3>(scale * offset.by_bend.transpose(), kBend, row, rows, jacobians);
    write<3>(scale * offset.point.transpose(), kPlane, row, rows, jacobians);
  }
  return true;
}

RobotResiduals::RobotResiduals(const ResidualContext& context, const BoardView& view)
    : context_(context), view_(view) {
  set_num_residuals(6);
  *mutable_parameter_block_sizes() = {6};
}

bool RobotResiduals::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  const double root = std::sqrt(view_.pose_weight);
  Vector6d scale;
  scale.head<3>().setConstant(root / context_.noise.robot_m);
  scale.tail<3>().setConstant(root / context_.noise.robot_rad);
  Eigen::Map<Vector6d> result(residuals);
  result = scale.cwiseProduct(Eigen::Map<const Vector6d>(parameters[0]));
  if (jacobians != nullptr && jacobians[0] != nullptr)
    Rows<6>(jacobians[0], 6, 6) = scale.asDiagonal().toDenseMatrix();
  return true;
}

LensResiduals::LensResiduals(const ResidualContext& context, bool square_pixels) {
  set_num_residuals(6);
  *mutable_parameter_block_sizes() = {9};
  constexpr double kMaxTerm = 0.3;         // of the corner's distance from the middle, chosen
  constexpr double kMaxDifference = 1e-4;  // [px] of fx and fy, chosen: next to nothing
  const ScannerState& state = context.reference;
  const double corner = std::hypot(state.width, state.height) / (state.camera[0] + state.camera[1]);
  rows_.setZero();
  const double powers[] = {2, 4, 1, 1, 6};  // of the ray's length, per coefficient
  for (int i = 0; i < 5; ++i)
    rows_(i, 4 + i) = std::pow(corner, powers[i]) / kMaxTerm;
  if (square_pixels) {
    rows_(5, 0) = 1 / kMaxDifference;
    rows_(5, 1) = -1 / kMaxDifference;
  }
}

bool LensResiduals::Evaluate(double const* const* parameters, double* residuals,
                             double** jacobians) const {
  Eigen::Map<Vector6d> result(residuals);
  result = rows_ * Eigen::Map<const CameraVector>(parameters[0]);
  if (jacobians != nullptr && jacobians[0] != nullptr) Rows<9>(jacobians[0], 6, 9) = rows_;
  return true;
}

}  // namespace scan_calibration
