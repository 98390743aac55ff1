// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/deviation_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "scan_cell_common/colours/colour_scale.h"

namespace part_recipes {
namespace {

using scan_cell_common::FieldedCloud;
using scan_cell_common::FieldType;
using scan_cell_common::Rgb;

constexpr Rgb kPlain = {0.50F, 0.66F, 0.79F};  // as the pages draw an object without deviations

/// [m] of each point, NaN where it is not known; empty where the cloud has none.
std::vector<double> deviations_of(const FieldedCloud& cloud) {
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(), [](const auto& each) {
    return each.name == "deviation" && each.type == FieldType::kFloat32;
  });
  std::vector<double> deviations;
  for (std::size_t i = 0; field != cloud.fields.end() && i < cloud.size(); ++i) {
    float value = 0;
    std::memcpy(&value, cloud.bytes.data() + i * cloud.step + field->offset, sizeof(value));
    deviations.push_back(static_cast<double>(value));
  }
  return deviations;
}

std::uint32_t packed(const Rgb& rgb) {
  std::uint32_t word = 0;
  for (const float part : rgb)
    word = word << 8U | static_cast<std::uint32_t>(std::lround(part * 255));
  return word;
}

/// The median of the known deviations, if most are known; else NaN.
double median_of(std::vector<double> deviations) {
  const std::size_t all = deviations.size();
  deviations.erase(std::remove_if(deviations.begin(), deviations.end(),
                                  [](double each) { return !std::isfinite(each); }),
                   deviations.end());
  if (2 * deviations.size() < all) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  return *middle;
}

Eigen::AlignedBox3d box_of(const scan_cell_common::Cloud& places) {
  Eigen::AlignedBox3d box;
  for (const auto& point : places)
    box.extend(point.getVector3fMap().cast<double>());
  return box;
}

struct Cell {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::vector<double> deviations;
};

}  // namespace

FieldedCloud coloured(const FieldedCloud& cloud, double tolerance) {
  scan_cell_common::places_of(cloud.view());  // refuses broken ones
  const std::vector<double> deviations = deviations_of(cloud);
  FieldedCloud result;
  result.fields = cloud.fields;
  result.fields.push_back({"rgb", FieldType::kFloat32, cloud.step});
  result.step = cloud.step + sizeof(std::uint32_t);
  result.bytes.resize(result.step * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::uint8_t* const to = result.bytes.data() + i * result.step;
    const std::uint32_t rgb =
        packed(deviations.empty()
                   ? kPlain
                   : scan_cell_common::diverging(deviations[i] / (kColourSpan * tolerance)));
    std::memcpy(to, cloud.bytes.data() + i * cloud.step, cloud.step);
    std::memcpy(to + cloud.step, &rgb, sizeof(rgb));
  }
  return result;
}

Eigen::AlignedBox3d box_of(const FieldedCloud& cloud) {
  return cloud.size() == 0 ? Eigen::AlignedBox3d() : box_of(places_of(cloud.view()));
}

std::vector<DeviationMark> deviation_marks(const FieldedCloud& cloud, double tolerance) {
  constexpr double kAcross = 16;  // cells along the longest side; chosen
  const std::vector<double> deviations = deviations_of(cloud);
  if (deviations.empty()) return {};
  const scan_cell_common::Cloud places = scan_cell_common::places_of(cloud.view());
  const Eigen::AlignedBox3d box = box_of(places);
  const double side = box.sizes().maxCoeff() / kAcross;
  if (!(side > 0)) return {};
  std::map<std::array<long, 3>, Cell> cells;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d at = places[i].getVector3fMap().cast<double>();
    const Eigen::Array3d place = (at - box.min()) / side;
    Cell& cell = cells[{std::lround(place.x()), std::lround(place.y()), std::lround(place.z())}];
    cell.sum += at;
    cell.deviations.push_back(deviations[i]);
  }
  std::vector<DeviationMark> marks;
  for (auto& [key, cell] : cells) {
    const auto count = static_cast<double>(cell.deviations.size());
    const double median = median_of(std::move(cell.deviations));
    if (std::abs(median) > tolerance) marks.push_back({cell.sum / count, median > 0});
  }
  return marks;
}

}  // namespace part_recipes
