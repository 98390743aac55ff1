// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "design_service.h"

#include <fmt/format.h>
#include <tf2_eigen/tf2_eigen.h>

#include "design/recipe_path.h"
#include "markers.h"
#include "path_design/designed_path.h"
#include "run/recipe_picture.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/pose/units.h"
#include "service_answer.h"
#include "tool_path_stretcher/ros/conversions.h"

namespace part_recipes {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::Rgb;
using scan_cell_msgs::DesignPath;
using visualization_msgs::Marker;

PathWay way_of(const DesignPath::Request& request) {
  switch (request.way) {
    case DesignPath::Request::EDGE:
      return PathWay::kEdge;
    case DesignPath::Request::SLICES:
      return PathWay::kSlices;
    case DesignPath::Request::PICKS:
      return PathWay::kPicks;
    default:
      throw InvalidParameter("way", fmt::format("{}", request.way), "give EDGE, SLICES or PICKS");
  }
}

std::vector<scan_cell_msgs::ToolParameter> parameters_of(PathWay way) {
  std::vector<scan_cell_msgs::ToolParameter> parameters;
  for (const PathOption& option : options_of(way)) {
    scan_cell_msgs::ToolParameter parameter;
    parameter.name = option.name;
    parameter.unit = option.unit;
    parameter.value = option.value;
    parameter.range = option.range;
    parameter.words = option.words;
    parameter.meaning = option.meaning;
    parameters.push_back(parameter);
  }
  return parameters;
}

ToolOptions options_in(const DesignPath::Request& request) {
  if (request.parameter_names.size() != request.parameter_values.size())
    throw InvalidParameter("parameter_values", fmt::format("{}", request.parameter_values.size()),
                           fmt::format("give one for each of {}", request.parameter_names.size()));
  ToolOptions options;
  for (std::size_t i = 0; i < request.parameter_names.size(); ++i)
    options[request.parameter_names[i]] = request.parameter_values[i];
  return options;
}

tool_paths::Points points_of(const std::vector<geometry_msgs::Point>& messages) {
  tool_paths::Points points(messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i)
    tf2::fromMsg(messages[i], points[i]);
  return points;
}

tool_paths::Points corners_of(const path_design::PartMesh& mesh) {
  tool_paths::Points corners;
  for (const path_design::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      corners.push_back(mesh.vertices[corner]);
  return corners;
}

/// Both ends of each line; no line joins two segments.
tool_paths::Points lines_along(const tool_paths::ToolPath& path) {
  tool_paths::Points ends;
  for (const tool_paths::Segment& segment : path.segments)
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i)
      for (const std::size_t end : {i - 1, i})
        ends.push_back(segment.waypoints[end].pose.translation());
  return ends;
}

std_msgs::Header header_in(const std::string& frame) {
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time::now();
  return header;
}

}  // namespace

DesignService::DesignService(ros::NodeHandle node, const RecipeParameters& parameters)
    : parameters_(parameters),
      reference_(node.advertise<Marker>("reference", 1, true)),
      path_(node.advertise<Marker>("designed_path", 1, true)),
      picks_(node.advertise<Marker>("picks", 1, true)) {
  node.setCallbackQueue(&queue_);
  service_ = node.advertiseService("design", &DesignService::design, this);
  spinner_.start();
}

bool DesignService::design(Request& request, Response& response) {
  return answer(response, [&] {
    response.parameters = parameters_of(way_of(request));
    const Recipe recipe = load_recipe(find_recipe(parameters_.recipes, request.recipe));
    response.frame = recipe.frame();
    show_reference(recipe, request);
    const std_msgs::Header header = header_in(response.frame);
    show({}, points_of(request.picks), header);  // also where no path comes of it
    if (request.make != 0) make(recipe, request, response);
  });
}

void DesignService::make(const Recipe& recipe, const Request& request, Response& response) {
  const tool_paths::Points picks = points_of(request.picks);
  constexpr double kPatience = 12;  // [s] less than a person's seat has; chosen
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  bool late = false;
  const Stop stop = [&] { return (late = late || ros::WallTime::now() > end) || !ros::ok(); };
  const auto make_it = [&] {
    try {
      return RecipePath(recipe, way_of(request), options_in(request), picks, stop);
    } catch (const scan_cell_common::Error&) {
      if (!late) throw;
      throw scan_cell_common::Refused("path", fmt::format("not made within {:g} s", kPatience),
                                      "take a coarser spacing, or call the tool path by hand");
    }
  };
  const RecipePath made = make_it();
  const std_msgs::Header header = header_in(recipe.frame());
  show(made.path(), picks, header);
  response.path = tool_path_stretcher::to_message(made.path(), header);
  response.notes = made.notes();
  if (request.save_as.empty()) return;
  const std::string fault = draw_picture(made.save_as(parameters_.recipes, request.save_as));
  if (!fault.empty()) response.notes.push_back(fault);
}

/// A request that makes nothing shows the reference anew: a seat may have closed it meanwhile.
void DesignService::show_reference(const Recipe& recipe, const Request& request) {
  constexpr Rgb kGrey = {0.6F, 0.6F, 0.6F};
  const std::string file = (recipe.folder / recipe.reference.file).string();
  const PathParameters parameters = surface_parameters(options_in(request));
  const std::string what = fmt::format(
      "{} {} {} {} {} {} {} {} {}", request.recipe, scan_cell_common::sha256_of_file(file),
      recipe.reference.units, recipe.frame(), parameters.from.x(), parameters.from.y(),
      parameters.from.z(), parameters.leaf, parameters.crease_angle);
  if (what == shown_ && request.make != 0) return;
  const path_design::PartMesh mesh = load_reference_surface(
      file, scan_cell_common::metres_per(recipe.reference.units), parameters);
  Marker marker = marker_of("reference", Marker::TRIANGLE_LIST, corners_of(mesh), 1, kGrey,
                            header_in(recipe.frame()));
  marker.text = request.recipe;
  reference_.publish(marker);
  shown_ = what;
}

void DesignService::show(const tool_paths::ToolPath& path, const tool_paths::Points& picks,
                         const std_msgs::Header& header) {
  constexpr Rgb kRed = {1, 0, 0}, kGreen = {0.1F, 0.6F, 0.2F};
  constexpr double kDiameter = 0.004;  // [m] as waypoints of a verdict
  constexpr double kWide = 0.001;      // [m] chosen
  path_.publish(marker_of("path", Marker::LINE_LIST, lines_along(path), kWide, kGreen, header));
  picks_.publish(marker_of("picks", Marker::SPHERE_LIST, picks, kDiameter, kRed, header));
}

}  // namespace part_recipes
