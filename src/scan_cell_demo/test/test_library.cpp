// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_sim/ground_truth.h"
#include "scan_cell_sim/tool_paths.h"
#include "scan_cell_sim/world.h"

namespace fs = std::filesystem;

namespace {

const char* const kNotInACore = "libros|librosc|libxmlrpcpp|libtf2|libvtk|libQt";

/// The suite's cores as seen by an outside program: in a shell without ROS.
class Library : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("library_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  std::string log() const { return scan_cell_common::read_file(file("log")); }

  bool run(const std::string& command) const {
    const std::string bare = "env -i PATH=/usr/bin:/bin HOME=" + folder_.string() + " ";
    return std::system((bare + command + " > " + file("log") + " 2>&1").c_str()) == 0;
  }

  bool build(const std::string& project, const std::string& prefix) const {
    return run("cmake -S " + project + " -B " + file("build") + " -DCMAKE_PREFIX_PATH=" + prefix +
               " -DCMAKE_BUILD_TYPE=Release '-DCMAKE_CXX_FLAGS=" EXAMPLE_FLAGS "'") &&
           run("cmake --build " + file("build"));
  }

  /// A frame, the same frame bent, and a tool path on the first, all from the simulator.
  void write_parts() const {
    const auto reference = scan_cell_sim::load_world(WORLDS "/reference_frame.yaml");
    const auto object = scan_cell_sim::load_world(WORLDS "/object_frame.yaml");
    save_sample("reference.ply", reference, 1);
    save_sample("object.ply", object, 2);
    constexpr double kSpacing = 0.002;  // [m]
    const auto path = scan_cell_sim::crest_path(reference.part("frame"), kSpacing);
    scan_cell_sim::save_tool_path(file("path.csv"), path);
    scan_cell_sim::save_tool_path(
        file("truth.csv"),
        scan_cell_sim::true_image(reference.part("frame"), object.part("frame"), path));
  }

  void save_sample(const std::string& name, const scan_cell_sim::World& world,
                   std::uint64_t seed) const {
    constexpr std::size_t kPoints = 40000;
    constexpr double kNoise = 1e-4;  // [m]
    scan_cell_common::Cloud cloud;
    for (const Eigen::Vector3d& point :
         scan_cell_sim::sample(scan_cell_sim::Scene(world, "frame"), kPoints, seed, kNoise)) {
      cloud.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                         static_cast<float>(point.z()));
    }
    scan_cell_common::save_cloud(file(name), cloud);
  }

  /// [m] from the waypoints' true places in the simulator.
  double path_rms() const {
    const auto adapted = scan_cell_sim::load_tool_path(file("adapted.csv"));
    const auto truth = scan_cell_sim::load_tool_path(file("truth.csv"));
    if (adapted.size() != truth.size()) throw std::runtime_error("a path of another length");
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      sum += (adapted[i].translation() - truth[i].translation()).squaredNorm();
    return std::sqrt(sum / static_cast<double>(truth.size()));
  }

  void expect_example_works() {
    write_parts();
    ASSERT_TRUE(run(file("build/adapt_my_path") + " " + file("reference.ply") + " " +
                    file("object.ply") + " " + file("path.csv") + " " + file("adapted.csv")))
        << log();
    EXPECT_EQ(log().rfind("accepted: ", 0), 0u) << log();
    EXPECT_LT(path_rms(), 1e-3);
  }

  void expect_no_ros_in(const std::string& binary) const {
    ASSERT_TRUE(run("ldd " + binary)) << log();
    std::smatch found;
    const std::string libraries = log();
    EXPECT_FALSE(std::regex_search(libraries, found, std::regex(kNotInACore)))
        << binary << ": " << found.str() << "\n"
        << libraries;
    EXPECT_EQ(libraries.find("not found"), std::string::npos) << binary << "\n" << libraries;
  }

  fs::path folder_;
};

}  // namespace

TEST_F(Library, IsUsedByAProgramOutsideWithoutRos) {
  ASSERT_TRUE(build(EXAMPLE_PROJECT, DEVEL_FOLDER)) << log();
  expect_no_ros_in(file("build/adapt_my_path"));
  expect_example_works();
}

TEST_F(Library, IsUsedWhereItIsInstalled) {
  for (const char* package : {"scan_cell_common", "tool_paths", "tool_path_stretcher"}) {
    ASSERT_TRUE(run("cmake -DCMAKE_INSTALL_PREFIX=" + file("prefix") + " -P " BUILD_FOLDER "/" +
                    package + "/cmake_install.cmake"))
        << log();
  }
  fs::rename(file("prefix"), file("moved"));
  ASSERT_TRUE(build(EXAMPLE_PROJECT, file("moved"))) << log();
  expect_no_ros_in(file("build/adapt_my_path"));
  expect_example_works();
}

TEST_F(Library, LinksEveryCoreWithoutRos) {
  const std::regex exported("add_library\\((scan_cell::[a-z0-9_]+) ");
  std::string packages, targets;
  std::size_t count = 0;
  for (const fs::directory_entry& core : fs::directory_iterator(DEVEL_FOLDER "/lib/cmake")) {
    const std::string name = core.path().filename();
    const fs::path list = core.path() / (name + "Targets.cmake");
    if (!fs::exists(list)) continue;
    ++count;
    packages += "find_package(" + name + " REQUIRED)\n";
    const std::string text = scan_cell_common::read_file(list.string());
    for (std::sregex_iterator at(text.begin(), text.end(), exported), end; at != end; ++at)
      targets += " " + (*at)[1].str();
  }
  constexpr std::size_t kPackagesWithACore = 12;
  EXPECT_GE(count, kPackagesWithACore);
  fs::create_directories(folder_ / "all");
  scan_cell_common::save_text(file("all/main.cpp"), "int main() {}\n");
  scan_cell_common::save_text(file("all/CMakeLists.txt"),
                              "cmake_minimum_required(VERSION 3.16)\nproject(all_cores CXX)\n" +
                                  packages + "add_executable(all_cores main.cpp)\n" +
                                  "target_link_libraries(all_cores" + targets + ")\n");
  ASSERT_TRUE(build(file("all"), DEVEL_FOLDER)) << log();
  expect_no_ros_in(file("build/all_cores"));
}
