// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/refinement/weakest_motions.h"

#include <Eigen/Eigenvalues>

#include "alignment/refinement/pairing.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {
namespace {

/// They move a point at the given distance from the centre by at most one metre.
std::array<Vector7d, 2> weakest(const MotionEquations& equations, double distance) {
  Eigen::Matrix<double, 6, 6> matrix = equations.matrix().topLeftCorner<6, 6>();
  matrix.topRows<3>() /= distance;
  matrix.leftCols<3>() /= distance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
  std::array<Vector7d, 2> motions;
  for (Eigen::Index i = 0; i < 2; ++i) {
    Vector7d& motion = motions[static_cast<std::size_t>(i)];
    motion << solver.eigenvectors().col(i).head<3>() / distance,
        solver.eigenvectors().col(i).tail<3>(), 0;
  }
  return motions;
}

}  // namespace

std::array<Vector7d, 2> weakest_motions(const SurfacePair& surfaces, const Similarity& similarity,
                                        const Eigen::Vector3d& centre) {
  const PointConstraints forth = Pairing(surfaces, Density::kMany).object_to_reference(similarity);
  MotionEquations equations(centre);
  equations.add(forth, deviation_of(forth, resolution(surfaces, similarity.scale)));
  return weakest(equations, surfaces.object.size);
}

}  // namespace tool_path_stretcher
