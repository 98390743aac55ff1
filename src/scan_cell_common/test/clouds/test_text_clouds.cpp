// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "clouds/scratch_folder.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"

using namespace scan_cell_common;  // NOLINT

namespace {

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

const Eigen::Vector3f kFirst(0.5F, -2.25F, 3);
const Eigen::Vector3f kSecond(1e-3F, 4, -5);

/// Expects both points and nothing else.
void expect_points(const std::string& text, const std::string& note = "") {
  SCOPED_TRACE(text);
  const LoadedCloud loaded = parse_point_table(text, "f");
  ASSERT_EQ(loaded.cloud.size(), 2U);
  EXPECT_EQ(loaded.cloud[0].getVector3fMap(), kFirst);
  EXPECT_EQ(loaded.cloud[1].getVector3fMap(), kSecond);
  if (note.empty()) {
    EXPECT_TRUE(loaded.notes.empty());
  } else {
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], note);
  }
}

std::string text_complaint(const std::string& text, double metres_per_unit = 1) {
  try {
    parse_point_table(text, "f", metres_per_unit);
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing";
}

CloudFormat profiles(double column_step, double profile_step, std::vector<double> invalid = {}) {
  CloudFormat format;
  format.column_step = column_step;
  format.profile_step = profile_step;
  format.invalid = std::move(invalid);
  return format;
}

std::string complaint_of_profiles(const std::string& text) {
  try {
    parse_depth_profiles(text, "f", profiles(1, 1));
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing";
}

class TextClouds : public ScratchFolder {};

}  // namespace

TEST(PointTable, IsReadWithAnyDelimiter) {
  expect_points("0.5 -2.25 3\n1e-3 4 -5\n");
  expect_points("  0.5   -2.25  3 \r\n\r\n 1e-3 4 -5");
  expect_points("0.5,-2.25,3\n1e-3, 4, -5\n");
  expect_points("0.5;-2.25;3\n1e-3;4;-5\n");
  expect_points("0.5\t-2.25\t3\n1e-3\t4\t-5\n");
  expect_points("\"0.5\",\"-2.25\",\"3\"\n\"1e-3\",\"4\",\"-5\"\n");
  expect_points("\xef\xbb\xbf# scanned today\n0.5 -2.25 3\n# and this\n1e-3 4 -5\n");
}

TEST(PointTable, TakesTheColumnsThatItsHeaderNames) {
  expect_points("x,y,z\n0.5,-2.25,3\n1e-3,4,-5\n");
  expect_points("Z;X;Y\n3;0.5;-2.25\n-5;1e-3;4\n");
  expect_points("x [m],y [m],z [m]\n0.5,-2.25,3\n1e-3,4,-5\n");
  expect_points("intensity,x,y,z,nx\n9,0.5,-2.25,3,a word\n9,1e-3,4,-5,\n",
                "columns intensity, nx are left out");
  expect_points("//X Y Z R\n0.5 -2.25 3 255\n1e-3 4 -5 255\n", "column R is left out");
  expect_points("\"time\",\"Points:0\",\"Points:1\",\"Points:2\"\n7,0.5,-2.25,3\n7,1e-3,4,-5\n",
                "column time is left out");
}

TEST(PointTable, SaysWhichColumnsItLeavesOutWithoutAHeader) {
  expect_points("0.5 -2.25 3 255 0 0\n1e-3 4 -5 0 0 255\n", "columns 4, 5, 6 are left out");
  expect_points("0.5,-2.25,3,good\n1e-3,4,-5,bad\n", "column 4 is left out");
}

TEST(PointTable, TakesAnEmptyFieldForNoMeasurement) {
  const Cloud cloud = parse_point_table("x,y,z\n1,2,\n1,2,nan\n1,2,3\n", "f").cloud;
  ASSERT_EQ(cloud.size(), 3U);
  EXPECT_TRUE(std::isnan(cloud[0].z));
  EXPECT_TRUE(std::isnan(cloud[1].z));
}

TEST(PointTable, SaysWhatIsWrong) {
  EXPECT_SAYS(text_complaint("a,b,c\n1,2,3\n"),
              "f, line 1: neither numbers nor a header with one x, one y and one z");
  EXPECT_SAYS(text_complaint("x,x,y,z\n1,2,3,4\n"), "neither numbers nor a header with one x");
  EXPECT_SAYS(text_complaint("hello\n"), "'hello'; name the columns x, y and z");
  EXPECT_SAYS(text_complaint("1 2\n"), "2 columns; give x, y and z in each line");
  EXPECT_SAYS(text_complaint("x y z\n1 2 3\n1 2\n"), "f, line 3: 2 columns; give 3");
  EXPECT_SAYS(text_complaint("1 2 3\n\n4 five 6\n"),
              "f, line 3: 'five' in column 2; give a number");
  EXPECT_SAYS(text_complaint("x;y;z\n0,5;1;2\n"),
              "'0,5' in column 1; write numbers with a decimal");
  EXPECT_SAYS(text_complaint("0 1.5 2.5 3.5 9\n1 1.6 2.6 3.6 9\n2 1.7 2.7 3.7 9\n"),
              "its first column counts the lines; name x, y and z");
  std::string wide = "0";
  for (int i = 0; i < 40; ++i)
    wide += ",0.5";
  EXPECT_SAYS(text_complaint(wide), "41 columns and no header");
  EXPECT_SAYS(text_complaint(wide), "--column-step");
}

TEST(PointTable, RefusesAnotherUnitThanItsHeaderNames) {
  for (const char* header : {"x_mm,y_mm,z_mm", "x [mm],y [mm],z [mm]", "X(mm),Y(mm),Z(mm)"}) {
    const std::string text = std::string(header) + "\n500,20,3\n";
    EXPECT_SAYS(text_complaint(text), "gives x, y, z in mm; read it with --units mm");
    EXPECT_SAYS(text_complaint(text, 0.0254), "--units mm");
    EXPECT_EQ(text_complaint(text, 1e-3), "nothing");
  }
  EXPECT_SAYS(text_complaint("x_mm,y_mm,z_inch\n1,2,3\n"),
              "neither numbers nor a header with one x");
}

TEST(DepthProfiles, BecomePointsAtTheSteps) {
  for (const char* text : {"7,8,9\n,nan,5\n", "7;8;9\n;nan;5\n", "7\t8\t9\n\tnan\t5\n",
                           "a,b,c\n7,8,9\n,nan,5\n", "# z [mm]\n7,8,9\n-32.768,-32.768,5\n"}) {
    SCOPED_TRACE(text);
    const LoadedCloud loaded = parse_depth_profiles(text, "f", profiles(0.25, -2, {-32.768}));
    ASSERT_EQ(loaded.cloud.size(), 4U);
    EXPECT_EQ(loaded.cloud[1].getVector3fMap(), Eigen::Vector3f(0.25F, 0, 8));
    EXPECT_EQ(loaded.cloud[3].getVector3fMap(), Eigen::Vector3f(0.5F, -2, 5));
    EXPECT_EQ(loaded.notes.back(),
              "2 profiles of 3 columns, 2 of their 6 values are not measurements");
  }
}

TEST(DepthProfiles, SayWhatIsWrong) {
  EXPECT_SAYS(complaint_of_profiles("1,2,3\n1,2\n"), "f, line 2: 2 columns; give 3");
  EXPECT_SAYS(complaint_of_profiles("1,2,3\n1,---,3\n"), "line 2: '---' in column 2");
  EXPECT_SAYS(complaint_of_profiles("y\\x,0.5,1\n1,2,3\n"), "line 1: 'y\\x' in column 1");
  EXPECT_SAYS(complaint_of_profiles("1\n2\n"), "one column");
}

TEST_F(TextClouds, ComeInMetresWhateverTheirUnit) {
  const std::string text = "x,y,z\n254,-25.4,2.54\n";
  for (const char* name : {"a.xyz", "a.CSV", "a.txt", "a.asc"}) {
    const Cloud cloud = load_cloud(write(name, text), metres_per("mm"));
    ASSERT_EQ(cloud.size(), 1U) << name;
    EXPECT_TRUE(cloud[0].getVector3fMap().isApprox(Eigen::Vector3f(0.254F, -0.0254F, 0.00254F)));
  }
  CloudFormat format = profiles(5, 10, {-32.768});
  format.metres_per_unit = metres_per("inch");
  const LoadedCloud loaded = load_cloud_file(write("p.csv", "1,-32.768\n-32.768,2\n"), format);
  ASSERT_EQ(loaded.cloud.size(), 2U);
  EXPECT_TRUE(
      loaded.cloud[1].getVector3fMap().isApprox(0.0254F * Eigen::Vector3f(5, 10, 2), 1e-6F));
}

TEST_F(TextClouds, LoseThePointsThatHoldAnInvalidNumber) {
  CloudFormat format;
  format.invalid = {-32.768, 0};
  const LoadedCloud loaded =
      load_cloud_file(write("a.xyz", "1 2 0\n0 0 1\n1 2 -32.768\n1 2 3\n"), format);
  ASSERT_EQ(loaded.cloud.size(), 2U);
  EXPECT_EQ(loaded.cloud[0].z, 1);
  ASSERT_EQ(loaded.notes.size(), 2U);
  EXPECT_EQ(loaded.notes[0], "1 of 4 points hold the invalid number -32.768");
  EXPECT_THROW(load_cloud_file(write("b.xyz", "0 0 0\n"), format), UnusableInput);
}

TEST_F(TextClouds, AreRefusedWhereTheStepsMakeNoSense) {
  const std::string csv = write("a.csv", "1,2\n");
  EXPECT_THROW(load_cloud_file(csv, profiles(1, 0)), InvalidParameter);
  EXPECT_THROW(load_cloud_file(csv, profiles(0, 1)), InvalidParameter);
  EXPECT_THROW(load_cloud_file(csv, profiles(NAN, 1)), InvalidParameter);
  EXPECT_THROW(load_cloud_file(write("a.ply", "ply\n"), profiles(1, 1)), InvalidParameter);
  EXPECT_THROW(load_cloud(write("empty.csv", "x,y,z\n")), UnusableInput);
  EXPECT_THROW(load_cloud(write("empty.xyz", "")), UnusableInput);
}

namespace {

/// A plate with noise, 0.3 x 0.2 m at z 0.5, with `count` points at a value of z.
Cloud plate_with(float value, int count) {
  Cloud cloud;
  for (int i = 0; i < 3000; ++i) {
    const float z = i < count ? value : 0.5F + 1e-5F * static_cast<float>(i * 37 % 101);
    cloud.push_back({0.005F * static_cast<float>(i % 60), 0.004F * static_cast<float>(i / 60), z});
  }
  return cloud;
}

}  // namespace

TEST(Sentinels, AreFoundWhereManyPointsHoldOneNumberFarAway) {
  for (const float value : {-32.768F, -9999.0F, 3.4e38F, 0.1F, 0.0F}) {
    const auto found = find_sentinel(plate_with(value, 900));
    ASSERT_TRUE(found.has_value()) << value;
    EXPECT_EQ(found->axis, 'z');
    EXPECT_EQ(found->value, static_cast<double>(value));
    EXPECT_EQ(found->points, 900U);
  }
}

TEST(Sentinels, AreFoundAtTheOrigin) {
  Cloud cloud = plate_with(0, 0);
  for (int i = 0; i < 500; ++i)
    cloud.push_back({0, 0, 0});
  const auto found = find_sentinel(cloud);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->value, 0);
  EXPECT_EQ(found->points, 500U);
}

TEST(Sentinels, AreNotSeenInOutliersNorInAFlatFloor) {
  EXPECT_FALSE(find_sentinel(plate_with(0, 0)).has_value());
  EXPECT_FALSE(find_sentinel(plate_with(-32.768F, 2)).has_value());  // two outliers
  Cloud computed = plate_with(0.1F, 1500);  // a table without noise, and a lid above it
  for (pcl::PointXYZ& point : computed)
    point.z = point.z > 0.3F ? 0.5F : point.z;
  EXPECT_FALSE(find_sentinel(computed).has_value());
  Cloud flat = plate_with(0.5F, 3000);
  EXPECT_FALSE(find_sentinel(flat).has_value());
  flat.resize(1);
  EXPECT_FALSE(find_sentinel(flat).has_value());
  EXPECT_FALSE(find_sentinel(Cloud()).has_value());
}
