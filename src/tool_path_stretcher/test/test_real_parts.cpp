// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "scan_cell_common/clouds/cloud_files.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;
using namespace tool_path_stretcher;

class RealPart : public testing::TestWithParam<const char*> {};

TEST_P(RealPart, CarriesItsRealPathOver) {
  const char* data = std::getenv("SCAN_CELL_DATA");
  if (data == nullptr) {
    GTEST_SKIP() << "NOT TESTED on the real part " << GetParam()
                 << ": set SCAN_CELL_DATA to the folder that holds parts/" << GetParam();
  }
  const fs::path folder = fs::path(data) / "parts" / GetParam();
  const StretchParameters parameters;
  const Surface reference = load_surface((folder / "part.stl").string(), parameters.leaf);
  const auto mesh = scan_cell_common::load_mesh((folder / "part.stl").string());
  const ToolPath path = tool_paths::load_tool_path((folder / "toolpath.yaml").string());
  const std::vector<double> scales = {0.7, 1.0, 1.4};
  for (unsigned i = 0; i < scales.size(); ++i) {
    const Similarity moved =
        synthetic::similarity(scales[i], synthetic::random_rotation(i + 1), {0.4, -0.2, 0.1});
    synthetic::Scan how;
    how.seed = i + 1;
    const Surface object =
        surface_from_cloud(synthetic::scan_mesh(mesh, moved, how), parameters.leaf, "object");
    const StretchResult result = stretch(reference, object, path, parameters);
    ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
    const auto error = synthetic::error_of(
        result.path, synthetic::truth(path, moved, synthetic::no_deformation()));
    std::cout << GetParam() << ", scale " << scales[i] << ": path " << 1e3 * error.rms
              << " mm RMS, " << 1e3 * error.max << " mm max, " << error.orientation * 180 / M_PI
              << " degrees, " << result.seconds << " s\n";
    EXPECT_LE(error.rms, 0.0003);
    EXPECT_LE(error.orientation, 1 * M_PI / 180);
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, RealPart, testing::Values("crs_part_1", "crs_part_2"));
