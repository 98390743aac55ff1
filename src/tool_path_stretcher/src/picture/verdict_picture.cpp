// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <sstream>

#include "canvas.h"
#include "geometry/kd_tree.h"
#include "mapping/residuals.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_stretcher {
namespace {

constexpr int kWidth = 1000;
constexpr int kHeight = 520;
constexpr int kTop = 84;  // of it, for text

// Blue, green, red.
const cv::Vec3b kBlack(20, 20, 20);
const cv::Vec3b kGrey(165, 165, 165);
const cv::Vec3b kPlain(190, 160, 130);
const cv::Vec3b kWhite(255, 255, 255);
const cv::Vec3b kRed(40, 40, 225);
const cv::Vec3b kOrange(20, 140, 255);
const cv::Vec3b kGreen(90, 200, 90);
const cv::Vec3b kBlue(255, 150, 70);

cv::Vec3b darker(const cv::Vec3b& colour, double share) {
  return {cv::saturate_cast<uchar>(share * colour[0]), cv::saturate_cast<uchar>(share * colour[1]),
          cv::saturate_cast<uchar>(share * colour[2])};
}

/// [m] distances of the object's points from the aligned reference. Each is the median over the
/// point's neighbours, so that the picture shows shapes and not noise.
std::vector<double> deviations_of(const Surface& reference, const Surface& object,
                                  const Similarity& similarity) {
  constexpr std::size_t kNeighbours = 30;
  std::vector<double> single;
  for (const Residual& residual : residuals_of(reference, Mapping{similarity, {}}, object.points)) {
    single.push_back(similarity.scale * std::hypot(residual.along_normal, residual.beside));
  }
  std::vector<double> deviations;
  std::vector<KdTree::Neighbour> found;
  for (const Eigen::Vector3d& point : object.points) {
    object.tree->nearest(point, kNeighbours, found);
    std::vector<double> around;
    for (const KdTree::Neighbour& each : found)
      around.push_back(single[each.index]);
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    deviations.push_back(*middle);
  }
  return deviations;
}

/// [m] value shown in the brightest colour: all but 2 % are below it, and noise alone is never
/// bright.
double brightest_of(std::vector<double> deviations) {
  constexpr double kShare = 0.98;
  constexpr double kLeast = 0.0005;
  const auto at = deviations.begin() +
                  static_cast<std::ptrdiff_t>(kShare * static_cast<double>(deviations.size() - 1));
  std::nth_element(deviations.begin(), at, deviations.end());
  return std::max(*at, kLeast);
}

/// Rotations and shifts of everything shown, as seen: the object to the right of the reference, or
/// the reference laid over it by the similarity.
struct Layout {
  Eigen::Matrix3d reference_turn;
  Eigen::Matrix3d object_turn;
  Eigen::Vector3d reference_shift = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;

  Eigen::Vector3d of_reference(const Eigen::Vector3d& at) const {
    return reference_turn * at + reference_shift;
  }
  Eigen::Vector3d of_object(const Eigen::Vector3d& at) const { return object_turn * at + shift; }
};

/// The box around all points but a few, which may be far away.
Eigen::AlignedBox3d box_of(const Points& points, const Eigen::Matrix3d& turn) {
  constexpr double kShare = 0.002;
  Eigen::AlignedBox3d box(Eigen::Vector3d::Zero().eval());
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& point : points)
      values.push_back(turn.row(axis).dot(point));
    std::sort(values.begin(), values.end());
    const auto cut = static_cast<std::size_t>(kShare * static_cast<double>(values.size()));
    box.min()[axis] = values[cut];
    box.max()[axis] = values[values.size() - 1 - cut];
  }
  return box;
}

Layout side_by_side(const PictureInput& input, const Eigen::Matrix3d& axes) {
  constexpr double kGap = 0.12;  // of the reference's width
  const auto& similarities = input.verdict.similarities;
  Layout layout;
  layout.reference_turn = axes;
  layout.object_turn =
      similarities.empty() ? axes : Eigen::Matrix3d(axes * similarities[0].rotation.transpose());
  const Eigen::AlignedBox3d left = box_of(input.reference.points, layout.reference_turn);
  const Eigen::AlignedBox3d right = box_of(input.object.points, layout.object_turn);
  layout.shift = left.center() - right.center();
  layout.shift.x() = left.max().x() + kGap * left.sizes().x() - right.min().x();
  layout.box = left.merged(right.translated(layout.shift));
  return layout;
}

Layout overlaid(const PictureInput& input, const Eigen::Matrix3d& axes) {
  const Similarity& similarity = input.verdict.similarities[0];
  Layout layout;
  layout.object_turn = axes * similarity.rotation.transpose();
  layout.reference_turn = similarity.scale * axes;
  layout.reference_shift = layout.object_turn * similarity.translation;
  layout.box = box_of(input.reference.points, layout.reference_turn)
                   .translated(layout.reference_shift)
                   .merged(box_of(input.object.points, layout.object_turn));
  return layout;
}

Layout lay_out(const PictureInput& input) {
  const View view = View::from(input.azimuth, input.elevation);
  Layout layout = input.overlay ? overlaid(input, view.axes) : side_by_side(input, view.axes);
  for (const Eigen::Vector3d& at : positions_of(input.path)) {
    layout.box.extend(layout.of_reference(at));
    for (const Similarity& similarity : input.verdict.similarities)
      layout.box.extend(layout.of_object(similarity * at));
  }
  return layout;
}

void draw_surface(Canvas& canvas, const Surface& surface, const Eigen::Matrix3d& turn,
                  const Eigen::Vector3d& shift,
                  const std::function<cv::Vec3b(std::size_t)>& colour_of) {
  constexpr double kShades = 20;  // few colours make small files
  const Eigen::Vector3d light = Eigen::Vector3d(-0.3, 0.5, 0.8).normalized();
  const double radius = std::clamp(1.1 * surface.spacing * canvas.pixels_per_metre(), 1.0, 12.0);
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const double lit = std::abs((turn * surface.normals[i]).dot(light));
    const double shade = std::round(kShades * (0.65 + 0.35 * lit)) / kShades;
    canvas.dot(turn * surface.points[i] + shift, radius, darker(colour_of(i), shade));
  }
}

using Place = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

Points seen(Points points, const Place& place) {
  for (Eigen::Vector3d& point : points)
    point = place(point);
  return points;
}

/// Interpolates between waypoints so densely that the points form a line.
Points drawn_out(const ToolPath& path, double step) {
  Points points;
  for (const Segment& segment : path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const Eigen::Vector3d to = segment.waypoints[i].pose.translation();
      const Eigen::Vector3d from = segment.waypoints[i > 0 ? i - 1 : 0].pose.translation();
      const double steps = std::clamp(std::ceil((to - from).norm() / step), 1.0, 1000.0);
      for (double at = 1; at <= steps; ++at)
        points.push_back(from + at / steps * (to - from));
    }
  }
  return points;
}

void draw_path(Canvas& canvas, const ToolPath& path, const Place& place, const cv::Vec3b& colour,
               double lift) {
  constexpr double kRadius = 1.6;
  const Points points = seen(drawn_out(path, 1 / canvas.pixels_per_metre()), place);
  for (const Eigen::Vector3d& at : points)
    canvas.dot(at, kRadius + 0.9, kBlack, 0.3 * lift);
  for (const Eigen::Vector3d& at : points)
    canvas.dot(at, kRadius, colour, lift);
}

/// Waypoints in the air in blue; over them, in red, those that the verdict names.
void draw_marked(Canvas& canvas, const ReportedVerdict& verdict, const Points& points) {
  constexpr double kRadius = 2.6;
  constexpr double kOverAll = 1e3, kOverBlue = 1.001e3;
  const auto draw = [&](const std::vector<std::size_t>& waypoints, const cv::Vec3b& colour,
                        double lift) {
    for (const std::size_t i : waypoints) {
      if (i < points.size()) canvas.dot(points[i], kRadius, colour, lift);
    }
  };
  draw(verdict.in_air, kBlue, kOverAll);
  draw(verdict.waypoints, kRed, kOverBlue);
}

void draw_paths(Canvas& canvas, const PictureInput& input, const Layout& layout) {
  constexpr double kLift = 0.03;  // of the size: shows paths on the surface, not half in it
  constexpr std::size_t kLines = 24;
  const double lift = kLift * input.reference.size;
  const Place left = [&](const Eigen::Vector3d& at) { return layout.of_reference(at); };
  const Points start = seen(positions_of(input.path), left);
  draw_path(canvas, input.path, left, kWhite, lift);
  draw_marked(canvas, input.verdict, start);
  std::vector<Place> places;  // of the path on the object, by the similarities
  for (const Similarity& similarity : input.verdict.similarities) {
    places.push_back([&](const Eigen::Vector3d& at) { return layout.of_object(similarity * at); });
  }
  if (places.empty()) return;
  for (std::size_t i = 1; i < places.size(); ++i)
    draw_path(canvas, input.path, places[i], kOrange, lift);
  const ToolPath& adapted = input.adapted ? *input.adapted : input.path;
  const Place as_it_is = [&](const Eigen::Vector3d& at) { return layout.of_object(at); };
  const Place right = input.adapted ? as_it_is : places[0];
  const Points end = seen(positions_of(adapted), right);
  draw_path(canvas, adapted, right, kWhite, lift);
  const std::size_t apart = std::max<std::size_t>(1, start.size() / kLines);
  for (std::size_t i = 0; i < std::min(start.size(), end.size()); i += apart)
    canvas.line(start[i], end[i], kGreen);
  draw_marked(canvas, input.verdict, end);
}

/// @param adapted whether the adapted path is drawn
void draw_words(Canvas& canvas, const ReportedVerdict& verdict, bool adapted) {
  constexpr std::size_t kLongest = 105;
  const std::string accepted =
      adapted ? "accepted" : "accepted; not shown: the adapted path (--adapted)";
  const std::string head = verdict.accepted ? accepted : "refused: " + verdict.reason;
  canvas.text(head, 16, 28, 13, verdict.accepted ? darker(kGreen, 0.6) : kRed);
  std::istringstream words(verdict.message);
  std::string word, line;
  int y = 50;
  const auto flush = [&] {
    canvas.text(line, 16, y, 9, kBlack);
    y += 18;
    line.clear();
  };
  while (words >> word) {
    if (line.size() + word.size() > kLongest) flush();
    line += (line.empty() ? "" : " ") + word;
  }
  flush();
}

void draw_legend(Canvas& canvas, double brightest, bool aligned) {
  const int y = canvas.height() - 30;
  canvas.text("reference and tool path", 16, y + 14, 8, kBlack);
  if (!aligned) return canvas.text("object, not aligned", canvas.width() - 420, y + 14, 8, kBlack);
  constexpr int kBar = 140;
  const int x = canvas.width() - 420;
  for (int i = 0; i < kBar; ++i)
    canvas.bar(x + i, y, 1, 12, heat(static_cast<double>(i) / kBar));
  std::array<char, 100> words{};
  std::snprintf(words.data(), words.size(), "0 .. %.1f mm off the aligned reference",
                1e3 * brightest);
  canvas.text(words.data(), x + kBar + 8, y + 11, 8, kBlack);
}

}  // namespace

void save_picture(const std::string& file, const PictureInput& input) {
  const auto& similarities = input.verdict.similarities;
  const bool aligned = !similarities.empty();
  if (input.overlay && !aligned) {
    throw scan_cell_common::UnusableInput(
        "report", "no pose was found",
        "leave --overlay out: it needs a pose of the reference on the object");
  }
  const Layout layout = lay_out(input);
  Canvas canvas(kWidth, kHeight);
  canvas.fit(layout.box.min(), layout.box.max(), kTop, 40);
  draw_surface(canvas, input.reference, layout.reference_turn, layout.reference_shift,
               [](std::size_t) { return kGrey; });
  std::vector<double> deviations(input.object.points.size(), 0);
  if (aligned) deviations = deviations_of(input.reference, input.object, similarities[0]);
  const double brightest = brightest_of(deviations);
  const auto heat_of = [&](double deviation) {
    constexpr double kSteps = 16;
    return heat(std::round(kSteps * std::min(deviation / brightest, 1.0)) / kSteps);
  };
  draw_surface(canvas, input.object, layout.object_turn, layout.shift,
               [&](std::size_t i) { return aligned ? heat_of(deviations[i]) : kPlain; });
  draw_paths(canvas, input, layout);
  draw_words(canvas, input.verdict, input.adapted.has_value());
  draw_legend(canvas, brightest, aligned);
  canvas.save(file);
}

}  // namespace tool_path_stretcher
