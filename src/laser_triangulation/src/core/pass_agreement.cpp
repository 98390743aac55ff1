// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace laser_triangulation {
namespace {

using scan_cell_common::kMillimetres;
constexpr std::size_t kMaxMended = 64;  // sweeps: a system of 384 unknowns; chosen
// [m] lever arm: half of the depth range at the usual distance in which a laser's points have that
// uncertainty; chosen
constexpr double kLever = 0.1;
constexpr double kMaxDeviations = 3;  // of a motion along each axis (99.7 %); chosen

/// Why the sweeps cannot be corrected, for a person; empty if they can.
std::string why_not_mended(const std::vector<Sweep>& sweeps,
                           const std::vector<double>& deviations) {
  if (sweeps.size() > kMaxMended)
    return fmt::format("{} sweeps, at most {} can be corrected", sweeps.size(), kMaxMended);
  for (const Sweep& sweep : sweeps) {
    if (sweep.laser < deviations.size() && deviations[sweep.laser] > 0) continue;
    return "the scanner model has no uncertainty for " + scan_cell_common::laser_name(sweep.laser);
  }
  return "";
}

/// Variances of each sweep's shift [m2] and rotation [rad2] along and about each axis. Sweeps are
/// assumed independent, which allows more than the lasers' common errors would.
Eigen::MatrixXd covariance_of(const std::vector<Sweep>& sweeps,
                              const std::vector<double>& deviations) {
  Eigen::VectorXd variances(static_cast<Eigen::Index>(6 * sweeps.size()));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const double deviation = deviations[sweeps[i].laser];
    const double shift = deviation * deviation / 3;
    const auto first = static_cast<Eigen::Index>(6 * i);
    variances.segment<3>(first).setConstant(shift);
    variances.segment<3>(first + 3).setConstant(shift / (kLever * kLever));
  }
  return variances.asDiagonal();
}

/// The first sweep whose motion exceeds what its covariance explains.
std::optional<std::size_t> beyond(const PassCorrection& correction,
                                  const Eigen::MatrixXd& covariance) {
  for (std::size_t i = 0; i < correction.motions.size(); ++i) {
    Eigen::Matrix<double, 6, 1> motion;
    motion << correction.motions[i].shift, correction.motions[i].turn;
    const auto variances = covariance.diagonal().segment<6>(static_cast<Eigen::Index>(6 * i));
    const Eigen::ArrayXd deviations = motion.array().abs() / variances.array().sqrt();
    if ((deviations > kMaxDeviations).any()) return i;
  }
  return std::nullopt;
}

SharedPlaces moved(const SharedPlaces& shared, const PassCorrection& correction) {
  std::vector<Eigen::Isometry3d> transforms;
  for (const SweepMotion& motion : correction.motions)
    transforms.push_back(transform(motion));
  SharedPlaces result = shared;
  for (std::vector<SweepPatch>& patches : result.places) {
    for (SweepPatch& patch : patches) {
      const Eigen::Isometry3d& move = transforms[patch.sweep];
      patch.nearest = move * patch.nearest;
      patch.from = move * patch.from;
      patch.mean = move * patch.mean;
      patch.normal = move.linear() * patch.normal;
    }
  }
  return result;
}

std::string figures(const PassOverlap& overlap) {
  std::string text = fmt::format("{} and {} lie {:.3f} mm apart, 95 % within {:.3f} mm",
                                 name_of(overlap.one), name_of(overlap.other),
                                 kMillimetres * overlap.median, kMillimetres * overlap.most);
  if (overlap.shifted > 0)
    text += fmt::format(", {} of {} places on patches that are {:g} mm off", overlap.shifted,
                        overlap.points, kMillimetres * kShifted);
  if (overlap.apart > 0)
    text += fmt::format(", {} of {} places more than {:g} mm", overlap.apart, overlap.points,
                        kMillimetres * kApart);
  return text;
}

/// The pair that disagrees most.
const PassOverlap& worst_of(const std::vector<PassOverlap>& overlaps) {
  return *std::max_element(overlaps.begin(), overlaps.end(), [](const auto& a, const auto& b) {
    return std::tie(a.apart, a.shifted, a.median) < std::tie(b.apart, b.shifted, b.median);
  });
}

bool any_disagree(const std::vector<PassOverlap>& overlaps) {
  return std::any_of(overlaps.begin(), overlaps.end(), disagree);
}

bool any_shifted(const std::vector<PassOverlap>& overlaps) {
  return std::any_of(overlaps.begin(), overlaps.end(), is_shifted);
}

std::string alone_text(const std::vector<Sweep>& alone) {
  std::string names;
  for (const Sweep& sweep : alone)
    names += (names.empty() ? "" : ", ") + name_of(sweep);
  if (names.empty()) return "";
  return "; not compared, since it shares too little of the surface with the others: " + names;
}

constexpr const char* kLookAt =
    "; look at the calibration, at the time offset between poses and pulses, and whether a part "
    "moved between the passes";

/// Corrects the passes, or says in the message why not.
/// @return whether a person should look for the cause
bool mend(const SharedPlaces& shared, const std::vector<double>& deviations, ScanCloud& cloud,
          PassAgreement& result) {
  const std::string why_not = why_not_mended(shared.sweeps, deviations);
  if (!why_not.empty()) {
    result.message += "; not corrected: " + why_not;
    return false;
  }
  const Eigen::MatrixXd covariance = covariance_of(shared.sweeps, deviations);
  const PassCorrection correction = find_correction(shared, result.overlaps, covariance);
  if (const std::optional<std::size_t> too_far = beyond(correction, covariance)) {
    if (any_shifted(result.overlaps)) result.agreement = Agreement::kDisagree;
    result.message += fmt::format(
        "; not corrected: {} would have to move further than the calibration's uncertainty "
        "explains",
        name_of(shared.sweeps[*too_far]));
    return true;
  }
  std::vector<PassOverlap> after = compare_sweeps(moved(shared, correction));
  if (any_disagree(after)) return false;
  if (any_shifted(after)) {
    result.agreement = Agreement::kDisagree;
    result.message += "; not corrected: no small motion of the passes would bring them together";
    return true;
  }
  apply(correction, shared.sweeps, cloud);
  result.agreement = Agreement::kMended;
  result.overlaps = std::move(after);
  result.message += "; corrected: " + figures(worst_of(result.overlaps));
  result.correction = correction;
  return false;
}

}  // namespace

PassAgreement bring_together(ScanCloud& cloud, const std::vector<double>& deviations) {
  PassAgreement result;
  const SharedPlaces shared = find_shared_places(cloud);
  result.sweeps = shared.sweeps;
  result.overlaps = compare_sweeps(shared);
  if (shared.sweeps.size() < 2) return result;
  const std::string alone = alone_text(sweeps_alone(shared, result.overlaps));
  if (result.overlaps.empty()) {
    result.message = "the passes cannot be compared" + alone;
    return result;
  }
  result.agreement = any_disagree(result.overlaps) ? Agreement::kDisagree : Agreement::kAgree;
  result.message = figures(worst_of(result.overlaps));
  const bool look = mend(shared, deviations, cloud, result);
  if (look || result.agreement == Agreement::kDisagree) result.message += kLookAt;
  result.message += alone;
  return result;
}

}  // namespace laser_triangulation
