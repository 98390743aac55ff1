// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "path/complaints.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_paths;
using scan_cell_common::InvalidParameter;

namespace {

PathConventions euler(const std::string& axes, AngleUnit angles) {
  PathConventions conventions;
  conventions.euler = axes;
  conventions.angles = angles;
  return conventions;
}

PathConventions rotation_vector(AngleUnit angles) {
  PathConventions conventions;
  conventions.rotation_vector = true;
  conventions.angles = angles;
  return conventions;
}

PathConventions units(const std::string& name) {
  PathConventions conventions;
  conventions.units = name;
  return conventions;
}

PathConventions process_values(const std::vector<std::string>& names) {
  PathConventions conventions;
  conventions.process_values = names;
  return conventions;
}

Eigen::Isometry3d first_pose(const std::string& text, const PathConventions& conventions = {}) {
  return parse_tool_path_csv(text, "path", conventions).path.segments[0].waypoints[0].pose;
}

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
}

Eigen::Matrix3d about_x(double degrees) {
  return turn(degrees, Eigen::Vector3d::UnitX());
}

Eigen::Matrix3d about_y(double degrees) {
  return turn(degrees, Eigen::Vector3d::UnitY());
}

Eigen::Matrix3d about_z(double degrees) {
  return turn(degrees, Eigen::Vector3d::UnitZ());
}

/// The error with which the path is refused; empty if it is not.
std::string complaint(const std::string& text, const PathConventions& conventions = {}) {
  return complaint_of([&] { parse_tool_path_csv(text, "path.csv", conventions); });
}

/// The whole path moved by a motion, like an adapted path.
ToolPath moved(ToolPath path, const Eigen::Isometry3d& motion) {
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose = motion * waypoint.pose;
  }
  return path;
}

std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(scan_cell_common::parse_number(field).value_or(-12345));
  return numbers;
}

/// The last line of a path that was read, moved and written.
std::vector<double> last_line_moved(const std::string& text, const PathConventions& conventions,
                                    const Eigen::Isometry3d& motion) {
  const ToolPathFile file = parse_tool_path_csv(text, "path", conventions);
  std::string written = tool_path_to_csv(moved(file.path, motion), file.layout);
  EXPECT_EQ(written.substr(0, written.find('\n')), text.substr(0, text.find('\n')));
  written.pop_back();  // the end of the last line
  return numbers_in(written.substr(written.rfind('\n') + 1));
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

}  // namespace

TEST(Orientations, AreReadAsEulerAnglesWhereTheirOrderIsGiven) {
  const Eigen::Matrix3d zyx = about_z(30) * about_y(-20) * about_x(100);
  const PathConventions degrees = euler("zyx", AngleUnit::kDegrees);
  EXPECT_TRUE(
      first_pose("x,y,z,rx,ry,rz\n0,0,0,100,-20,30\n", degrees).linear().isApprox(zyx, 1e-12));
  EXPECT_TRUE(first_pose("X,Y,Z,Yaw,Pitch,Roll\n0,0,0,30,-20,100\n", degrees)
                  .linear()
                  .isApprox(zyx, 1e-12));
  // Kuka's A, B, C and Fanuc's W, P, R
  EXPECT_TRUE(first_pose("x,y,z,a,b,c\n0,0,0,30,-20,100\n", degrees).linear().isApprox(zyx, 1e-12));
  EXPECT_TRUE(first_pose("x,y,z,w,p,r\n0,0,0,100,-20,30\n", degrees).linear().isApprox(zyx, 1e-12));
  const Eigen::Matrix3d xyz = about_x(100) * about_y(-20) * about_z(30);
  EXPECT_TRUE(first_pose("x,y,z,rx_deg,ry_deg,rz_deg\n0,0,0,100,-20,30\n",
                         euler("xyz", AngleUnit::kNotGiven))
                  .linear()
                  .isApprox(xyz, 1e-12));
  const Eigen::Matrix3d radians = first_pose("x,y,z,rx,ry,rz\n0,0,0,0,0,1.5707963267948966\n",
                                             euler("zyx", AngleUnit::kRadians))
                                      .linear();
  EXPECT_TRUE(radians.isApprox(about_z(90), 1e-12));
}

TEST(Orientations, AreReadAsRotationVectors) {
  const Eigen::Isometry3d pose = first_pose("x,y,z,rx,ry,rz\n0,0,0,0,1.5707963267948966,0\n",
                                            rotation_vector(AngleUnit::kRadians));
  EXPECT_TRUE(pose.linear().isApprox(about_y(90), 1e-12));
}

TEST(Orientations, AreReadAsTheRobotsShowThem) {
  // ABB: q1 is the real part
  const Eigen::Isometry3d abb = first_pose("x,y,z,q1,q2,q3,q4\n0,0,0,0,1,0,0\n");
  EXPECT_TRUE(abb.linear().isApprox(about_x(180), 1e-12));
  // Comau: Z-Y-Z in degrees, and millimetres
  const Eigen::Isometry3d comau =
      first_pose("x_mm,y_mm,z_mm,a_deg,e_deg,r_deg\n100,-200,1071.8,30,90,-45\n");
  EXPECT_TRUE(comau.linear().isApprox(about_z(30) * about_y(90) * about_z(-45), 1e-12));
  EXPECT_TRUE(comau.translation().isApprox(Eigen::Vector3d(0.1, -0.2, 1.0718), 1e-12));
}

TEST(Orientations, AreReadAsToolVectors) {
  for (const char* const header : {"x,y,z,i,j,k", "x,y,z,nx,ny,nz", "X,Y,Z,I,J,K"}) {
    const Eigen::Isometry3d pose = first_pose(std::string(header) + "\n0,0,0,0.6,0,-0.8\n");
    EXPECT_TRUE(pose.linear().col(2).isApprox(Eigen::Vector3d(0.6, 0, -0.8), 1e-12)) << header;
  }
  EXPECT_TRUE(names(complaint("x,y,z,i,j,k\n0,0,0,3,4,0\n"), "a tool vector of length 5"));
}

TEST(Orientations, GoOutInTheConventionTheyCameIn) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = about_z(90);
  motion.translation() << 1, 2, 3;
  const PathConventions degrees = euler("zyx", AngleUnit::kDegrees);
  expect_near(last_line_moved("speed,rz,ry,rx,x,y,z\n7,10,20,30,0.5,0,0\n", degrees, motion),
              {7, 100, 20, 30, 1, 2.5, 3});
  expect_near(last_line_moved("x_mm,y_mm,z_mm,a_deg,e_deg,r_deg\n500,0,0,-30,45,60\n", {}, motion),
              {1000, 2500, 3000, 60, 45, 60});
  expect_near(last_line_moved("x,y,z,nx,ny,nz,f\n0.5,0,0,0.6,0,0.8,1\n", {}, motion),
              {1, 2.5, 3, 0, 0.6, 0.8, 1});
  const double half = std::sqrt(0.5);
  expect_near(last_line_moved("x,y,z,q1,q2,q3,q4\n0.5,0,0,1,0,0,0\n", {}, motion),
              {1, 2.5, 3, half, 0, 0, half});
  expect_near(last_line_moved("x,y,z,rx,ry,rz\n0,0,0,0,0,0.25\n",
                              rotation_vector(AngleUnit::kRadians), motion),
              {1, 2, 3, 0, 0, 0.25 + M_PI / 2});
  expect_near(last_line_moved("x,y,z\n254,0,0\n", units("mm"), motion), {1000, 2254, 3000});
  expect_near(last_line_moved("x,y,z\n10,0,0\n", units("inch"), motion),
              {1 / 0.0254, 10 + 2 / 0.0254, 3 / 0.0254});
}

TEST(Orientations, ThatAreNotUnderstoodAreRefusedByName) {
  for (const char* const columns : {"rx,ry,rz", "roll,pitch,yaw", "a,b,c", "a,e,r", "w,p,r",
                                    "o,a,t", "alpha,beta,gamma", "RX,RY,RZ", "rx_deg,ry_deg,rz_deg",
                                    "Roll [deg],Pitch [deg],Yaw [deg]", "rot_x,rot_y,rot_z"}) {
    const std::string message = complaint(std::string("x,y,z,") + columns + "\n0,0,0,0,0,0\n");
    const std::string first = std::string(columns).substr(0, std::string(columns).find(','));
    EXPECT_TRUE(names(message, "line 1: '" + first + "'")) << message;
    EXPECT_TRUE(names(message, "could be an orientation")) << columns;
    EXPECT_TRUE(names(message, "--euler zyx --degrees")) << message;
    EXPECT_TRUE(names(message, std::string("--process-values ") + columns)) << message;
  }
}

TEST(Orientations, ThatAreThereInPartAreRefusedByName) {
  for (const char* const column :
       {"yaw", "rx", "q1", "q0", "quat_w", "orientation", "tool_angle", "rotation", "theta",
        "normal_x", "axis_z", "r11", "j4", "c", "i", "tilt_deg", "ow", "rotZ", "angle1"}) {
    const std::string message = complaint(std::string("x,y,z,speed,") + column + "\n0,0,0,1,0\n");
    EXPECT_TRUE(names(message, std::string("'") + column + "' could be an orientation")) << column;
  }
  EXPECT_TRUE(names(complaint("x,y,z,vx,vy,vz\n0,0,0,1,0,0\n"), "'vx', 'vy', 'vz' could be"));
  EXPECT_TRUE(
      names(complaint("x,y,z,qx,qy,qz,qw,nx,ny,nz\n0,0,0,0,0,0,1,0,0,1\n"), "two orientations"));
}

TEST(Orientations, AreNotSeenWhereAreNone) {
  const ToolPath path =
      parse_tool_path_csv(
          "x,y,z,speed,force,dwell_s,laser_power,normal_force,temperature,zone,p,e,extra\n"
          "0,0,0,1,2,3,4,5,6,7,8,9,10\n",
          "path")
          .path;
  EXPECT_FALSE(path.has_orientation);
  EXPECT_EQ(path.process_names.size(), 10U);
}

TEST(Orientations, AreProcessValuesWhereAPersonSaysSo) {
  const ToolPath path = parse_tool_path_csv("x,y,z,qx,qy,qz,qw,a,tilt\n0,0,0,0,0,0,1,5,7\n", "path",
                                            process_values({"a", "tilt"}))
                            .path;
  EXPECT_EQ(path.process_names, (std::vector<std::string>{"a", "tilt"}));
  EXPECT_THROW(parse_tool_path_csv("x,y,z\n0,0,0\n", "path", process_values({"a"})),
               InvalidParameter);
}

TEST(Orientations, AreRefusedWhereTheConventionDoesNotFit) {
  const std::string angles = "x,y,z,rx,ry,rz\n0,0,0,0,0,0\n";
  EXPECT_TRUE(
      names(complaint(angles, euler("zyx", AngleUnit::kNotGiven)), "angles without a unit"));
  EXPECT_THROW(first_pose(angles, euler("zyz", AngleUnit::kDegrees)), InvalidParameter);
  EXPECT_THROW(first_pose(angles, euler("zxw", AngleUnit::kDegrees)), InvalidParameter);
  EXPECT_THROW(first_pose("x,y,z\n0,0,0\n", euler("zyx", AngleUnit::kDegrees)), InvalidParameter);
  EXPECT_THROW(first_pose("x,y,z,i,j,k\n0,0,0,0,0,1\n", euler("zyx", AngleUnit::kDegrees)),
               InvalidParameter);
  EXPECT_THROW(first_pose("x_mm,y_mm,z_mm\n0,0,0\n", units("m")), InvalidParameter);
  EXPECT_THROW(first_pose("x,y,z\n0,0,0\n", units("furlong")), InvalidParameter);
  EXPECT_TRUE(names(complaint("x_mm,y_mm,z\n0,0,0\n"), "different units"));
  EXPECT_TRUE(names(complaint("x,y,z,rx,ry,rz\n0,0,0,0,0,3.14159\n0,0,0,0,1.5,0.2\n",
                              euler("zyx", AngleUnit::kDegrees)),
                    "--radians"));
}

TEST(Orientations, AreReadByTheSameNamesInYaml) {
  const auto first = [](const std::string& text, const PathConventions& conventions) {
    return parse_tool_path_yaml(text, "path", conventions).path.segments[0].waypoints[0].pose;
  };
  const PathConventions degrees = euler("zyx", AngleUnit::kDegrees);
  for (const char* const pose :
       {"{position: {x: 1, y: 0, z: 0}, rpy: [100, -20, 30]}",
        "{position: {x: 1, y: 0, z: 0}, rpy: {roll: 100, pitch: -20, yaw: 30}}",
        "{position: [1, 0, 0], orientation: {yaw: 30, roll: 100, pitch: -20}}",
        "{x: 1, y: 0, z: 0, rx: 100, ry: -20, rz: 30}"}) {
    EXPECT_TRUE(first(std::string("- ") + pose + "\n", degrees)
                    .linear()
                    .isApprox(about_z(30) * about_y(-20) * about_x(100), 1e-12))
        << pose;
    EXPECT_TRUE(names(yaml_complaint(std::string("- ") + pose + "\n"), "--euler")) << pose;
  }
  const Eigen::Isometry3d flat =
      first("- {x: 1, y: 2, z: 3, qw: 0, qx: 0, qy: 1, qz: 0}\n", PathConventions{});
  EXPECT_TRUE(flat.linear().isApprox(about_y(180), 1e-12));
  EXPECT_EQ(flat.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(Orientations, ThatAreNotUnderstoodInYamlAreRefusedByName) {
  const std::string position = "- {position: {x: 1, y: 0, z: 0}, ";
  for (const char* const key :
       {"euler: [1, 2, 3]", "normal: {x: 0, y: 0, z: 1}", "quaternion: [0, 0, 0, 1]",
        "rotation: north", "data: {rpy: [0, 0, 1]}", "yaw: 0.5"}) {
    EXPECT_TRUE(names(yaml_complaint(position + key + "}\n"), "could be an orientation")) << key;
  }
  EXPECT_TRUE(names(yaml_complaint(position + "orientation: [0, 0, 0, 1]}\n"), "not a map"));
  EXPECT_TRUE(names(yaml_complaint("rpy: [0, 0, 1]\nposes: [[1, 2, 3]]\n"), "beside the poses"));
}

TEST(PathContents, SayWhatWasUnderstood) {
  const auto said = [](const std::string& text, const PathConventions& conventions = {}) {
    const ToolPathFile file = parse_tool_path_csv(text, "path", conventions);
    return to_string(contents_of(file.path, file.layout));
  };
  EXPECT_EQ(said("x,y,z\n0,0,0\n"),
            "1 waypoint in 1 segment, in m; orientations: none; process values: none");
  EXPECT_EQ(
      said("x,y,z,segment,qx,qy,qz,qw,speed,force\n0,0,0,a,0,0,0,1,1,2\n0,0,0,b,0,0,0,1,1,2\n"),
      "2 waypoints in 2 segments, in m; orientations: quaternions, x y z w (qx, qy, qz, qw); "
      "process values: speed, force");
  EXPECT_TRUE(names(said("x_mm,y_mm,z_mm,a_deg,e_deg,r_deg\n0,0,0,0,0,0\n"),
                    "in mm; orientations: Euler angles Z-Y-Z in degrees (a_deg, e_deg, r_deg)"));
  EXPECT_TRUE(
      names(said("x,y,z,q1,q2,q3,q4\n0,0,0,1,0,0,0\n"), "quaternions, x y z w (q2, q3, q4, q1)"));
  EXPECT_TRUE(names(said("x,y,z,i,j,k\n0,0,0,1,0,0\n"), "tool vectors (i, j, k)"));
}
