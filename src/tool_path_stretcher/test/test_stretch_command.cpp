// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "scan_cell_common/cloud_files.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace fs = std::filesystem;
using namespace tool_path_stretcher;

namespace {

scan_cell_common::Cloud cloud_of(const Points& points) {
  scan_cell_common::Cloud cloud;
  for (const Eigen::Vector3d& p : points)
    cloud.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  return cloud;
}

class StretchCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("stretch_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    synthetic::Scan whole;
    whole.seed = 11;
    const auto none = synthetic::no_deformation();
    scan_cell_common::save_cloud(file("r.ply"), cloud_of(synthetic::scan(part_, {}, none, whole)));
    scan_cell_common::save_cloud(file("d.ply"), cloud_of(synthetic::scan(part_, moved_, none, {})));
    save_tool_path(file("p.csv"), synthetic::path_on(part_, 100));
  }

  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Exit code; files are given by name.
  int run(const std::string& reference, const std::string& object, const std::string& path,
          const std::string& more = "") const {
    return run_into("out.csv", "report.json", reference, object, path, more);
  }

  int run_into(const std::string& output, const std::string& report,
               const std::string& reference = "r.ply", const std::string& object = "d.ply",
               const std::string& path = "p.csv", const std::string& more = "") const {
    const std::string command = std::string(STRETCH_COMMAND) + " --reference " + file(reference) +
                                " --object " + file(object) + " --path " + file(path) +
                                " --output " + file(output) + " --report " + file(report) + " " +
                                more + " > /dev/null 2> " + file("stderr");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  nlohmann::json report() const {
    std::ifstream in(file("report.json"));
    return nlohmann::json::parse(in);
  }

  std::string text_of(const std::string& name) const {
    std::ifstream in(file(name));
    return std::string((std::istreambuf_iterator<char>(in)), {});
  }

  bool left_no_path() const { return !fs::exists(file("out.csv")); }

  fs::path folder_;
  synthetic::Part part_ = synthetic::photo_frame();
  Similarity moved_ = synthetic::similarity(
      1.08, Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {0.3, 0.1, 0});
};

}  // namespace

TEST_F(StretchCommand, AdaptsThePathAndReportsIt) {
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0) << text_of("stderr");
  const ToolPath path = load_tool_path(file("out.csv"));
  const ToolPath truth =
      synthetic::truth(synthetic::path_on(part_, 100), moved_, synthetic::no_deformation());
  EXPECT_LE(synthetic::error_of(path, truth).rms, 0.0002);
  EXPECT_EQ(report()["verdict"], "accepted");
  EXPECT_EQ(report()["reason"], "accepted");
  EXPECT_NEAR(report()["scale"], 1.08, 0.001);
  EXPECT_EQ(report()["quality"].size(), 100U);
  EXPECT_GT(report()["inlier_ratio"], 0.95);
}

TEST_F(StretchCommand, GivesTheSameBytesTwice) {
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const std::string first = text_of("out.csv");
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  EXPECT_EQ(first, text_of("out.csv"));
}

TEST_F(StretchCommand, GivesTheSameBytesOnOneThreadOrMany) {
  setenv("OMP_NUM_THREADS", "1", 1);
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const std::string one = text_of("out.csv");
  setenv("OMP_NUM_THREADS", "4", 1);
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  unsetenv("OMP_NUM_THREADS");
  EXPECT_EQ(one, text_of("out.csv"));
}

TEST_F(StretchCommand, RefusesAWrongPartAndRemovesAnOldPath) {
  std::ofstream(file("out.csv")) << "an old path";
  scan_cell_common::save_cloud(
      file("wrong.ply"),
      cloud_of(synthetic::scan(synthetic::curved_panel(), {}, synthetic::no_deformation(), {})));
  EXPECT_EQ(run("r.ply", "wrong.ply", "p.csv"), 2);
  EXPECT_TRUE(left_no_path());
  EXPECT_EQ(report()["verdict"], "refused");
  EXPECT_EQ(report()["reason"], "wrong_part");
}

TEST_F(StretchCommand, SaysWhatIsUnusable) {
  EXPECT_EQ(run("no.ply", "d.ply", "p.csv"), 1);
  EXPECT_NE(text_of("stderr").find("no.ply: no such file"), std::string::npos);
  EXPECT_EQ(report()["reason"], "unusable_input");
  std::ofstream(file("bad.csv")) << "x,y,z\n1,2,nan\n";
  EXPECT_EQ(run("r.ply", "d.ply", "bad.csv"), 1);
  EXPECT_NE(text_of("stderr").find("line 2: z = 'nan'"), std::string::npos);
  std::ofstream(file("bad.ply")) << "not a cloud";
  EXPECT_EQ(run("r.ply", "bad.ply", "p.csv"), 1);
  EXPECT_EQ(run("r.ply", "d.ply", "p.csv", "--method magic"), 1);
  EXPECT_NE(text_of("stderr").find("method: 'magic'"), std::string::npos);
  EXPECT_EQ(run("r.ply", "d.ply", "p.csv", "--tolerance -1"), 1);
  EXPECT_EQ(run("r.ply", "d.ply", "p.csv", "--no-such-option"), 1);
  EXPECT_TRUE(left_no_path());
}

TEST_F(StretchCommand, NamesTheCloudThatIsNone) {
  const auto write = [this](const std::string& name, const std::string& bytes) {
    std::ofstream(file(name), std::ios::binary) << bytes;
  };
  const std::string whole = text_of("d.ply");
  scan_cell_common::save_cloud(file("d.pcd"), scan_cell_common::load_cloud(file("d.ply")));
  write("picture.ply", "\x89PNG\r\n\x1a\n" + std::string(100, '\0'));
  write("empty.ply", "");
  write("short.ply", whole.substr(0, whole.size() / 2));
  write("short.pcd", text_of("d.pcd").substr(0, 100000));
  write("huge.ply",
        std::string(whole).replace(whole.find("vertex 20000"), 12, "vertex 4000000000"));
  write("short.stl", "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  write("short.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n");
  fs::create_directory(file("folder.ply"));
  ASSERT_EQ(mkfifo(file("pipe.ply").c_str(), 0600), 0);
  const std::map<std::string, std::string> complaints = {
      {"picture.ply", "no PLY file"},
      {"empty.ply", "no PLY file"},
      {"short.ply", "truncated: its header promises 20000"},
      {"short.pcd", "truncated: its header promises 20000"},
      {"huge.ply", "truncated: its header promises 4000000000"},
      {"short.stl", "truncated: no 'endsolid'"},
      {"short.obj", "line 4: a face of 2 corners"},
      {"folder.ply", "no file but a folder"},
      {"pipe.ply", "no file but a folder, a device or a pipe"}};
  for (const auto& [name, complaint] : complaints) {
    EXPECT_EQ(run(name, "d.ply", "p.csv"), 1) << name;
    EXPECT_NE(text_of("stderr").find(name), std::string::npos) << text_of("stderr");
    EXPECT_NE(text_of("stderr").find(complaint), std::string::npos) << text_of("stderr");
    EXPECT_EQ(report()["reason"], "unusable_input") << name;
    EXPECT_TRUE(left_no_path()) << name;
  }
}

TEST_F(StretchCommand, NeverOverwritesWhatItReads) {
  fs::create_hard_link(file("p.csv"), file("linked.csv"));
  fs::create_symlink(file("p.csv"), file("pointing.csv"));
  const std::string path = text_of("p.csv");
  const std::string reference = text_of("r.ply");
  for (const char* output : {"p.csv", "linked.csv", "pointing.csv", "no/../p.csv"}) {
    EXPECT_EQ(run_into(output, "report.json"), 1) << output;
    EXPECT_EQ(report()["reason"], "unusable_input") << output;
    EXPECT_EQ(text_of("p.csv"), path) << output;
  }
  for (const char* report : {"p.csv", "r.ply", "d.ply", "out.csv"}) {
    EXPECT_EQ(run_into("out.csv", report), 1) << report;
    EXPECT_NE(text_of("stderr").find("given twice"), std::string::npos) << report;
  }
  EXPECT_EQ(text_of("p.csv"), path);
  EXPECT_TRUE(text_of("r.ply") == reference);
  EXPECT_TRUE(left_no_path());
}

TEST_F(StretchCommand, NeverReportsAPathThatIsNotThere) {
  EXPECT_EQ(run_into("out.txt", "report.json"), 1);
  EXPECT_EQ(report()["reason"], "unusable_input");
  EXPECT_NE(text_of("stderr").find("ending '.txt'"), std::string::npos) << text_of("stderr");
  EXPECT_EQ(run_into("no/such/folder/out.csv", "report.json"), 1);
  EXPECT_EQ(report()["reason"], "unusable_input");
  fs::create_directory(file("folder.csv"));
  EXPECT_EQ(run_into("folder.csv", "report.json"), 1);
  EXPECT_EQ(report()["reason"], "unusable_input");
  EXPECT_TRUE(fs::is_directory(file("folder.csv")));
}

TEST_F(StretchCommand, LeavesNoPathWithoutAReport) {
  EXPECT_EQ(run_into("out.csv", "no/such/folder/report.json"), 1);
  EXPECT_TRUE(left_no_path());
}

TEST_F(StretchCommand, RefusesCloudsWithNan) {
  scan_cell_common::Cloud cloud = scan_cell_common::load_cloud(file("d.ply"));
  cloud[5].x = std::numeric_limits<float>::quiet_NaN();
  scan_cell_common::save_cloud(file("nan.ply"), cloud);
  EXPECT_EQ(run("r.ply", "nan.ply", "p.csv"), 1);
  EXPECT_NE(text_of("stderr").find("1 of 20000 points are not finite"), std::string::npos);
}
