// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "uncertainty/mapping_error.h"
#include "uncertainty/soft_prior.h"

using namespace tool_path_stretcher;

namespace {

constexpr double kSize = 0.2;  // [m]
const Eigen::Vector3d kCentre(0.1, 0.1, 0);

/// A flat, undisplaced graph of 10 x 10 nodes, and its assumptions.
struct Sheet {
  Mapping mapping;
  NormalEquations known, rigid;
  Eigen::MatrixXd modes;
  SoftPrior prior;

  Sheet() {
    Points points;
    for (int i = 0; i < 100; ++i)
      points.emplace_back(0.02 * (i % 10) + 0.01, 0.02 * (i / 10) + 0.01, 0.001 * (i % 7));
    mapping.graph = DeformationGraph(points, 0.02);
    rigid = rigidity(mapping, kCentre);
    known = knowledge(mapping, {}, {1e-3, 1e-4}, kCentre);
    modes = smooth_modes(mapping.graph);
    prior = SoftPrior(known, rigid, modes, links());
  }

  std::size_t links() const { return mapping.graph.links().size(); }

  /// The motion of the unknowns that shifts each node as given.
  template <class Shift>
  Eigen::VectorXd motion(const Shift& shift) const {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(rigid.matrix.rows());
    for (std::size_t i = 0; i < mapping.graph.nodes().size(); ++i)
      motion.segment<3>(static_cast<Eigen::Index>(6 * i + 3)) = shift(i);
    return motion;
  }

  double held(const Eigen::VectorXd& motion) const {
    Eigen::Matrix<double, Eigen::Dynamic, 3> motions =
        Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(motion.size(), 3);
    motions.col(0) = motion;
    return prior.held(motions)(0, 0);
  }

  /// The motion's cost in squared standard deviations of independent links.
  double held_by_links(const Eigen::VectorXd& motion) const {
    return motion.dot(rigid.matrix * motion);
  }
};

TEST(SoftPrior, AStretchOfTheWholePartIsOneObservationOfAllLinks) {
  const Sheet sheet;
  ASSERT_GT(sheet.links(), 300u);
  const Eigen::VectorXd stretch = sheet.motion([&](std::size_t i) {
    const Eigen::Vector3d& at = sheet.mapping.graph.nodes()[i].at;
    return Eigen::Vector3d(1e-3 * (at - kCentre).x(), 0, 0);
  });
  // The covariances of links and modes add up, so the modes' alone is the least.
  const double one = sheet.held_by_links(stretch) / static_cast<double>(sheet.links());
  EXPECT_LT(sheet.held(stretch), one);
  EXPECT_GT(sheet.held(stretch), 0.95 * one);
}

TEST(SoftPrior, ASingleNodeIsHeldByItsOwnLinks) {
  const Sheet sheet;
  const Eigen::VectorXd dent = sheet.motion([](std::size_t i) {
    return i == 44 ? Eigen::Vector3d(0, 0, 1e-3) : Eigen::Vector3d::Zero();
  });
  EXPECT_GT(sheet.held(dent), 0.8 * sheet.held_by_links(dent));
}

TEST(SoftPrior, TurnAndShiftOfTheWholeAreHeldByWhatWasKnownOfThem) {
  const Sheet sheet;
  const Eigen::VectorXd shift =
      sheet.motion([](std::size_t) { return Eigen::Vector3d(0, 1e-3, 0); });
  const double known = shift.dot(sheet.known.matrix * shift);
  EXPECT_NEAR(sheet.held(shift), known, 1e-4 * known);
}

TEST(SoftPrior, IsTheInverseOfTheSumOfBothCovariances) {
  const Sheet sheet;
  const Eigen::MatrixXd stiff = sheet.known.matrix + sheet.rigid.matrix;
  // The independent modes: eigenvectors of their strain.
  const Eigen::MatrixXd strained = sheet.modes.transpose() * sheet.rigid.matrix * sheet.modes /
                                   static_cast<double>(sheet.links());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(strained);
  Eigen::MatrixXd covariance = stiff.inverse();
  for (Eigen::Index i = 0; i < strained.rows(); ++i) {
    if (solver.eigenvalues()[i] < 1e-9 * solver.eigenvalues().maxCoeff()) continue;
    const Eigen::VectorXd mode = sheet.modes * solver.eigenvectors().col(i);
    covariance += mode * mode.transpose() / solver.eigenvalues()[i];
  }
  const Eigen::VectorXd waves = sheet.motion([](std::size_t i) {
    return Eigen::Vector3d(1e-4 * std::sin(i), 1e-4 * std::cos(2.0 * i), 1e-4 * std::sin(3.0 * i));
  });
  const Eigen::VectorXd again = sheet.prior.equations().matrix * (covariance * waves);
  EXPECT_LT((again - waves).norm(), 1e-3 * waves.norm());
  EXPECT_NEAR(sheet.held(waves), waves.dot(sheet.prior.equations().matrix * waves),
              1e-9 * sheet.held(waves));
}

TEST(PosteriorCovariance, IsTheInverse) {
  const Sheet sheet;
  const Eigen::MatrixXd information = sheet.prior.equations().matrix;
  const Eigen::MatrixXd covariance = posterior_covariance(information);
  const Eigen::VectorXd waves =
      sheet.motion([](std::size_t i) { return Eigen::Vector3d(0, 0, 1e-4 * std::sin(i)); });
  EXPECT_LT((covariance * (information * waves) - waves).norm(), 1e-3 * waves.norm());
}

TEST(PosteriorCovariance, IsRefusedWhereAnUnknownIsFreeOrNotANumber) {
  const Sheet sheet;
  Eigen::MatrixXd information = sheet.prior.equations().matrix;
  information(300, 300) = -1;
  EXPECT_THROW(posterior_covariance(information), UnheldMapping);
  information(300, 300) = std::nan("");
  EXPECT_THROW(posterior_covariance(information), UnheldMapping);
}

}  // namespace
