// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

/// Draws the figures of a chart with history_chart.py.
/// @param data as to_json() of history/chart/run_chart.h gives it
/// @param output .html or .png
/// @throw scan_cell_common::FileError if it cannot be drawn
void draw_chart(const std::string& data, const std::filesystem::path& output);
