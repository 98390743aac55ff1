// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scan_cell_common/clouds/cloud_files.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/surface.h"

namespace fs = std::filesystem;
using tool_path_stretcher::Points;
using tool_path_stretcher::Similarity;

namespace {

const Eigen::Vector3d kMiddle(0.2, -0.1, 0.05);  // [m] where the panel lies
const Eigen::Vector3d kLarger(0.2, 0.45, 0.05);  // [m] where a larger frame lies

Points scanned(const synthetic::Part& part, const Eigen::Vector3d& place, double scale,
               unsigned seed) {
  synthetic::Scan how;
  how.seed = seed;
  how.points = static_cast<std::size_t>(20000 * scale * scale);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return synthetic::scan(part, synthetic::similarity(scale, turn, place),
                         synthetic::no_deformation(), how);
}

Points panel_at(const Eigen::Vector3d& place, unsigned seed) {
  return scanned(synthetic::curved_panel(), place, 1, seed);
}

/// A photo frame, twice as large.
Points frame_at(const Eigen::Vector3d& place) {
  return scanned(synthetic::photo_frame(), place, 2, 7);
}

Points together(Points one, const Points& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

class CleanCloudByReference : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    save("reference.ply", panel_at({0, 0, 0}, 11));
    save("scan.ply", together(panel_at(kMiddle, 1), frame_at(kLarger)));
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  void save(const std::string& name, const Points& points, double metres_per_unit = 1) const {
    scan_cell_common::save_cloud(file(name), tool_path_stretcher::to_cloud(points),
                                 metres_per_unit);
  }

  /// Runs the command and returns its exit code. There is no floor, and points at edges must stay.
  int clean(const std::string& scan, const std::string& options) const {
    const std::string command = std::string(CLEAN_CLOUD) + " --input " + file(scan) + " --output " +
                                file("part.ply") + " --floor off --outliers off --grid off " +
                                options + " > " + file("said") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  std::string said() const {
    std::ifstream stream(file("said"));
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void expect_said(const std::string& part) const {
    EXPECT_NE(said().find(part), std::string::npos) << part << " not in: " << said();
  }

  void expect_panel() const {
    const auto part = scan_cell_common::load_cloud(file("part.ply"));
    EXPECT_GT(part.size(), 19950U);  // of 20,000
    for (const auto& point : part)
      ASSERT_LT(point.y, 0.1) << "a point of the frame";
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("by_reference_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(CleanCloudByReference, KeepsThePartNotTheLargerThing) {
  ASSERT_EQ(clean("scan.ply", ""), 0) << said();
  const auto largest = scan_cell_common::load_cloud(file("part.ply"));
  EXPECT_GT(largest.front().y, 0.1) << "the frame is the larger thing";
  save("reference_mm.ply", panel_at({0, 0, 0}, 11), 1e-3);
  ASSERT_EQ(clean("scan.ply", "--reference " + file("reference_mm.ply") + " --reference-units mm"),
            0)
      << said();
  expect_panel();
  expect_said("reference_mm.ply' explains kept");
}

TEST_F(CleanCloudByReference, RefusesTwoAlikeAndWritesNothing) {
  save("two.ply", together(panel_at(kMiddle, 1), panel_at(kLarger, 2)));
  EXPECT_EQ(clean("two.ply", "--reference " + file("reference.ply")), 1);
  expect_said("reference.ply' explains 2 objects: ");
  expect_said("isolate/select to nearest");
  EXPECT_FALSE(fs::exists(file("part.ply")));
}

TEST_F(CleanCloudByReference, RefusesWhatTheReferenceDoesNotExplain) {
  save("other.ply", frame_at(kLarger));
  EXPECT_EQ(clean("other.ply", "--reference " + file("reference.ply")), 1);
  expect_said("reference.ply' explains none of 1 objects (");
  EXPECT_FALSE(fs::exists(file("part.ply")));
}

TEST_F(CleanCloudByReference, RefusesBadOptionsByName) {
  EXPECT_EQ(clean("scan.ply", "--isolate reference"), 1);
  expect_said("isolate.reference: not set; give the file of the part to look for");
  EXPECT_EQ(clean("scan.ply", "--isolate largest --reference " + file("reference.ply")), 1);
  expect_said("leave it out, or give --isolate reference");
  EXPECT_EQ(clean("scan.ply", "--reference " + file("lost.ply")), 1);
  expect_said("lost.ply");
  EXPECT_NE(clean("scan.ply", "--reference " + file("reference.ply") + " --reference-units feet"),
            0);
  expect_said("--reference-units");
}
