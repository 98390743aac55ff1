// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pluginlib/class_list_macros.hpp>

#include "scan_cell_common/ros/services.h"
#include "triangulation_services.h"

namespace laser_triangulation {

class TriangulationNodelet
    : public scan_cell_common::ServicesNodelet<TriangulationServices, Parameters> {};

}  // namespace laser_triangulation

PLUGINLIB_EXPORT_CLASS(laser_triangulation::TriangulationNodelet, nodelet::Nodelet)
