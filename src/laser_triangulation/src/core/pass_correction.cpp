// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_correction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace laser_triangulation {
namespace {

// [m] deviation of a patch's mean along its normal: noise of its points and roughness; chosen
constexpr double kPatchDeviation = 0.03e-3;
// Neighbouring places share points and sensor errors, so they tell less than their number; chosen
constexpr double kPerIndependent = 10;
constexpr double kRobustWidth = 0.1e-3;  // [m] Cauchy's: beyond, a pair counts less; chosen
constexpr int kRounds = 10;              // of reweighting, which settles within five; chosen

using Row = Eigen::Matrix<double, 12, 1>;

/// Two sweeps at a place: their distance and its derivatives by their motions.
struct Pair {
  Eigen::Index one;  // first unknown of the sweep
  Eigen::Index other;
  Row row;
  double distance;  // [m]
};

using SweepPairs = std::set<std::pair<std::size_t, std::size_t>>;  // indices, lower one first

SweepPairs indices_of(const std::vector<PassOverlap>& overlaps, const std::vector<Sweep>& sweeps) {
  const auto index_of = [&](const Sweep& wanted) {
    const auto found = std::find_if(sweeps.begin(), sweeps.end(), [&](const Sweep& sweep) {
      return sweep.pass == wanted.pass && sweep.laser == wanted.laser;
    });
    return static_cast<std::size_t>(found - sweeps.begin());
  };
  SweepPairs pairs;
  for (const PassOverlap& overlap : overlaps)
    pairs.insert(std::minmax({index_of(overlap.one), index_of(overlap.other)}));
  return pairs;
}

template <class Take>
void for_each_pair(const SharedPlaces& shared, const SweepPairs& compared, const Take& take) {
  constexpr std::size_t kMaxPartners = 8;  // of a sweep at a place; chosen
  for (const std::vector<SweepPatch>& patches : shared.places) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(patches.size(), i + 1 + kMaxPartners); ++j) {
        const SweepPatch& one = patches[i];
        const SweepPatch& other = patches[j];
        if (one.whole && other.whole && same_side(one, other) &&
            compared.count({one.sweep, other.sweep}) > 0)
          take(one, other);
      }
    }
  }
}

std::vector<Pair> pairs_of(const SharedPlaces& shared, const SweepPairs& compared,
                           const std::vector<Eigen::Vector3d>& centres) {
  std::vector<Pair> pairs;
  for_each_pair(shared, compared, [&](const SweepPatch& one, const SweepPatch& other) {
    const Eigen::Vector3d& normal = one.normal;
    const auto lever = [&](const SweepPatch& patch) -> Eigen::Vector3d {
      return (one.mean - centres[patch.sweep]).cross(normal);
    };
    Row row;
    row << -normal, -lever(one), normal, lever(other);
    pairs.push_back({static_cast<Eigen::Index>(6 * one.sweep),
                     static_cast<Eigen::Index>(6 * other.sweep), row,
                     normal.dot(other.mean - one.mean)});
  });
  return pairs;
}

double distance_after(const Pair& pair, const Eigen::VectorXd& motions) {
  return pair.distance + pair.row.head<6>().dot(motions.segment<6>(pair.one)) +
         pair.row.tail<6>().dot(motions.segment<6>(pair.other));
}

/// [m] the mean of each sweep's places, shared or not.
std::vector<Eigen::Vector3d> centres_of(const SharedPlaces& shared) {
  std::vector<Eigen::Vector3d> centres(shared.sweeps.size(), Eigen::Vector3d::Zero());
  std::vector<double> counts(shared.sweeps.size(), 0);
  for (const std::vector<SweepPatch>& patches : shared.places) {
    for (const SweepPatch& patch : patches) {
      centres[patch.sweep] += patch.nearest;
      ++counts[patch.sweep];
    }
  }
  for (std::size_t i = 0; i < centres.size(); ++i)
    centres[i] /= std::max(1., counts[i]);
  return centres;
}

}  // namespace

PassCorrection find_correction(const SharedPlaces& shared, const std::vector<PassOverlap>& overlaps,
                               const Eigen::MatrixXd& covariance) {
  PassCorrection correction;
  const SweepPairs compared = indices_of(overlaps, shared.sweeps);
  const std::vector<Eigen::Vector3d> centres = centres_of(shared);
  const std::vector<Pair> pairs = pairs_of(shared, compared, centres);
  const Eigen::Index size = covariance.rows();
  // x = C (1 + H C)^-1 g instead of (C^-1 + H)^-1 g: C may be singular in directions that cannot
  // move.
  Eigen::VectorXd motions = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(size);  // motions = covariance * pull
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
    for (const Pair& pair : pairs) {
      const double off = distance_after(pair, motions) / kRobustWidth;
      const double weight =
          1 / ((1 + off * off) * kPatchDeviation * kPatchDeviation * kPerIndependent);
      const Eigen::Matrix<double, 12, 12> square = weight * pair.row * pair.row.transpose();
      const Eigen::Index at[] = {pair.one, pair.other};
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j)
          information.block<6, 6>(at[i], at[j]) += square.block<6, 6>(6 * i, 6 * j);
        gradient.segment<6>(at[i]) -= weight * pair.distance * pair.row.segment<6>(6 * i);
      }
    }
    const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(size, size) + information * covariance;
    pull = system.partialPivLu().solve(gradient);
    motions = covariance * pull;
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto first = static_cast<Eigen::Index>(6 * i);
    correction.motions.push_back(
        {centres[i], motions.segment<3>(first), motions.segment<3>(first + 3)});
  }
  // x' C^-1 x, without an inverse.
  correction.deviations = std::sqrt(std::max(0., pull.dot(motions)) / static_cast<double>(size));
  return correction;
}

Eigen::Isometry3d transform(const SweepMotion& motion) {
  const double angle = motion.turn.norm();
  const Eigen::Vector3d axis = angle > 0 ? (motion.turn / angle).eval() : Eigen::Vector3d::UnitZ();
  return Eigen::Translation3d(motion.centre + motion.shift) * Eigen::AngleAxisd(angle, axis) *
         Eigen::Translation3d(-motion.centre);
}

void apply(const PassCorrection& correction, const std::vector<Sweep>& sweeps, ScanCloud& cloud) {
  std::map<std::pair<std::uint8_t, std::uint8_t>, Eigen::Isometry3d> transforms;
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    transforms[{sweeps[i].pass, sweeps[i].laser}] = transform(correction.motions[i]);
  cloud.for_each([&](ScanPoint& point) {
    const Eigen::Isometry3d& move = transforms.at({point.pass, point.laser});
    const Eigen::Vector3f place = (move * Eigen::Vector3d(point.x, point.y, point.z)).cast<float>();
    const Eigen::Vector3f from =
        (move * Eigen::Vector3d(point.vp_x, point.vp_y, point.vp_z)).cast<float>();
    std::tie(point.x, point.y, point.z) = std::tuple(place.x(), place.y(), place.z());
    std::tie(point.vp_x, point.vp_y, point.vp_z) = std::tuple(from.x(), from.y(), from.z());
  });
}

}  // namespace laser_triangulation
