// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <unistd.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Eigen/Geometry>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gp_Ax2.hxx>

#include "scan_cell_common/clouds/cloud_files.h"

namespace {

namespace fs = std::filesystem;

/// [mm] A plate of 100 x 60 x 20 with a hole of radius 10 through it.
constexpr double kVolume = 100 * 60 * 20 - M_PI * 100 * 20;

class StepToMesh : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  void save_plate(const char* unit) const {
    const TopoDS_Shape plate =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(100, 60, 20).Shape(),
                        BRepPrimAPI_MakeCylinder(gp_Ax2({50, 30, 0}, {0, 0, 1}), 10, 20).Shape())
            .Shape();
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", unit);
    writer.Transfer(plate, STEPControl_AsIs);
    ASSERT_EQ(writer.Write(file("plate.step").c_str()), IFSelect_RetDone);
  }

  int run(const std::string& more = "") const {
    const std::string command = STEP_TO_MESH " --input " + file("plate.step") + " --output " +
                                file("plate.stl") + " " + more + " > " + file("said") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  std::string said() const {
    std::ifstream text(file("said"));
    return {std::istreambuf_iterator<char>(text), {}};
  }

  /// [mm^3] that the mesh encloses, by the divergence theorem.
  double volume() const {
    constexpr double kMillimetre = 1e-3;
    const pcl::PolygonMesh mesh = scan_cell_common::load_mesh(file("plate.stl"), kMillimetre);
    scan_cell_common::Cloud corners;
    pcl::fromPCLPointCloud2(mesh.cloud, corners);
    double sum = 0;
    for (const pcl::Vertices& face : mesh.polygons) {
      const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
        return corners[face.vertices[i]].getVector3fMap().cast<double>() / kMillimetre;
      };
      sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
    }
    return sum;
  }

  const fs::path folder_ = fs::temp_directory_path() / ("step_to_mesh_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(StepToMesh, KeepsTheVolumeWithinTheDeviation) {
  save_plate("MM");
  ASSERT_EQ(run("--deviation 0.05"), 0) << said();
  const double wall = 2 * M_PI * 10 * 20;  // [mm^2] of the hole, the only curved face
  EXPECT_NEAR(volume(), kVolume, 0.05 * wall);
  EXPECT_NE(said().find("100.0 x 60.0 x 20.0 mm"), std::string::npos) << said();
}

TEST_F(StepToMesh, WritesMillimetresWhateverTheUnitOfTheFile) {
  save_plate("INCH");  // the same numbers, so 100 inches long
  ASSERT_EQ(run(), 0) << said();
  const double expected = std::pow(25.4, 3) * kVolume;
  EXPECT_NEAR(volume(), expected, 1e-3 * expected);
}

TEST_F(StepToMesh, RefusesWhatIsNoStepFile) {
  std::ofstream(file("plate.step")) << "solid plate\nendsolid plate\n";
  EXPECT_EQ(run(), 1);
  EXPECT_NE(said().find("plate.step: not a readable STEP file"), std::string::npos) << said();
  EXPECT_FALSE(fs::exists(file("plate.stl")));
}

TEST_F(StepToMesh, RefusesAFileWithoutASurface) {
  std::ofstream(file("plate.step"))
      << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
         "FILE_NAME('','2026-01-01T00:00:00',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
         "#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_EQ(run(), 1);
  EXPECT_NE(said().find("holds no surface"), std::string::npos) << said();
}
