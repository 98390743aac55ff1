// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "clouds/carried_fields.h"

namespace scan_cell_common {
namespace {

constexpr std::size_t kMinPoints = 5;  // with the same number; measured ones never have it

/// Range of most numbers on an axis, and how often they repeat.
struct Range {
  double least = 0;
  double most = 0;
  double repeated = 0;  // share of the most frequent number

  double distance(double value) const { return std::max({0.0, least - value, value - most}); }
};

/// Range of about 20,000 of the points that `keep` selects, without the outermost 1 % at each end.
template <class Keep>
Range range_of(const Cloud& cloud, std::size_t axis, const Keep& keep) {
  constexpr std::size_t kSample = 20000;
  constexpr double kOutermost = 0.01;
  const auto kept = static_cast<std::size_t>(std::count_if(cloud.begin(), cloud.end(), keep));
  const std::size_t step = std::max<std::size_t>(1, kept / kSample);
  std::size_t seen = 0;
  std::vector<float> values;
  for (const pcl::PointXYZ& point : cloud) {
    if (keep(point) && seen++ % step == 0) values.push_back(point.data[axis]);
  }
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  std::ptrdiff_t longest = 0;
  for (auto first = values.begin(); first != values.end();) {
    const auto last = std::upper_bound(first, values.end(), *first);
    longest = std::max(longest, last - first);
    first = last;
  }
  const auto count = static_cast<double>(values.size());
  const auto skip = static_cast<std::size_t>(kOutermost * count);
  return {static_cast<double>(values[skip]), static_cast<double>(values[values.size() - 1 - skip]),
          static_cast<double>(longest) / count};
}

bool is_finite(const pcl::PointXYZ& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// Ranges of the points that `keep` selects.
template <class Keep>
std::array<Range, 3> box_of(const Cloud& cloud, const Keep& keep) {
  return {range_of(cloud, 0, keep), range_of(cloud, 1, keep), range_of(cloud, 2, keep)};
}

double diagonal(const std::array<Range, 3>& box) {
  double squared = 0;
  for (const Range& range : box)
    squared += std::pow(range.most - range.least, 2);
  return std::sqrt(squared);
}

/// Whether a number shared by many points lies where nothing can have been measured: very far away,
/// or clearly away from numbers that do not repeat because of noise. So the table in a computed
/// cloud without noise is not a sentinel.
bool is_far(double value, const std::array<Range, 3>& box, std::size_t axis) {
  constexpr double kVeryFar = 2;  // diagonals of the rest
  constexpr double kFar = 0.2;
  constexpr double kNoise = 0.1;  // share of one number
  const double size = diagonal(box);
  const double distance = box[axis].distance(value);
  return size > 0 && distance > (box[axis].repeated < kNoise ? kFar : kVeryFar) * size;
}

/// The least or greatest value on an axis, if it is far from all others and many points have it.
std::optional<Sentinel> extreme_at(const Cloud& cloud, std::size_t axis, bool greatest) {
  float extreme = std::numeric_limits<float>::infinity() * (greatest ? -1.F : 1.F);
  std::size_t count = 0;
  for (const pcl::PointXYZ& point : cloud) {
    if (!is_finite(point)) continue;
    const float value = point.data[axis];
    if (value == extreme) ++count;
    if (greatest ? value <= extreme : value >= extreme) continue;
    extreme = value;
    count = 1;
  }
  if (count < kMinPoints) return std::nullopt;
  const auto rest = [&](const pcl::PointXYZ& p) { return is_finite(p) && p.data[axis] != extreme; };
  if (!is_far(static_cast<double>(extreme), box_of(cloud, rest), axis)) return std::nullopt;
  return Sentinel{"xyz"[axis], static_cast<double>(extreme), count};
}

bool is_zero(const pcl::PointXYZ& point) {
  return point.x == 0 && point.y == 0 && point.z == 0;
}

/// Points exactly at the origin, outside the range of all others.
std::optional<Sentinel> zeros_of(const Cloud& cloud) {
  constexpr double kOutside = 0.1;  // of the diagonal of the rest
  const auto count = static_cast<std::size_t>(std::count_if(cloud.begin(), cloud.end(), is_zero));
  if (count < kMinPoints) return std::nullopt;
  const std::array<Range, 3> box =
      box_of(cloud, [](const pcl::PointXYZ& p) { return is_finite(p) && !is_zero(p); });
  const double size = diagonal(box);
  double outside = 0;
  for (const Range& range : box)
    outside = std::max(outside, range.distance(0));
  if (!(size > 0 && outside > kOutside * size)) return std::nullopt;
  return Sentinel{'z', 0, count};
}

}  // namespace

std::optional<Sentinel> find_sentinel(const Cloud& cloud) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool greatest : {false, true}) {
      const std::optional<Sentinel> found = extreme_at(cloud, axis, greatest);
      if (found && (found->value != 0 || axis == 2)) return found;  // x or y may be 0 anywhere
    }
  }
  return zeros_of(cloud);
}

bool holds_invalid(const pcl::PointXYZ& point, double invalid) {
  // Within the rounding of a float and of the digits that a text file usually has.
  constexpr double kEqual = 1e-6;
  const auto is_invalid = [invalid](float value) {
    return std::abs(static_cast<double>(value) - invalid) <= kEqual * std::abs(invalid);
  };
  if (invalid == 0) return point.z == 0;  // x or y may be 0 anywhere
  return is_invalid(point.x) || is_invalid(point.y) || is_invalid(point.z);
}

std::size_t drop_invalid(Cloud& cloud, double invalid) {
  const auto drop = [invalid](const pcl::PointXYZ& point) { return holds_invalid(point, invalid); };
  const std::size_t before = cloud.size();
  cloud.erase(std::remove_if(cloud.begin(), cloud.end(), drop), cloud.end());
  return before - cloud.size();
}

}  // namespace scan_cell_common
