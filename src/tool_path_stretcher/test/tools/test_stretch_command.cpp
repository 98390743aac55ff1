// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "report.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "synthetic_parts.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;
using namespace tool_path_stretcher;

namespace {

Points scaled(Points points, double factor) {
  for (Eigen::Vector3d& point : points)
    point *= factor;
  return points;
}

class StretchCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("stretch_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    synthetic::Scan whole;
    whole.seed = 11;
    const auto none = synthetic::no_deformation();
    scan_cell_common::save_cloud(file("r.ply"), to_cloud(synthetic::scan(part_, {}, none, whole)));
    scan_cell_common::save_cloud(file("d.ply"), to_cloud(synthetic::scan(part_, moved_, none, {})));
    tool_paths::save_tool_path(file("p.csv"), synthetic::path_on(part_, 100));
  }

  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the command and returns its exit code; files are given by name.
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
                                more + " > " + file("stdout") + " 2> " + file("stderr");
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
  const ToolPath path = tool_paths::load_tool_path(file("out.csv"));
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
      to_cloud(synthetic::scan(synthetic::curved_panel(), {}, synthetic::no_deformation(), {})));
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
      {"picture.ply", "not a PLY file"},
      {"empty.ply", "not a PLY file"},
      {"short.ply", "truncated: its header promises 20000"},
      {"short.pcd", "truncated: its header promises 20000"},
      {"huge.ply", "truncated: its header promises 4000000000"},
      {"short.stl", "truncated: no 'endsolid'"},
      {"short.obj", "line 4: a face with 2 corners"},
      {"folder.ply", "a folder, a device or a pipe, not a file"},
      {"pipe.ply", "a folder, a device or a pipe, not a file"}};
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
  EXPECT_NE(text_of("stderr").find("extension '.txt'"), std::string::npos) << text_of("stderr");
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

TEST_F(StretchCommand, LeavesNoOldResultBehindAMisspeltOption) {
  fs::copy(file("p.csv"), file("out.csv"));
  fs::copy(file("p.csv"), file("report.json"));
  EXPECT_EQ(run("r.ply", "d.ply", "p.csv", "--tolerence 0.001"), 1);
  EXPECT_NE(text_of("stderr").find("did you mean --tolerance?"), std::string::npos);
  EXPECT_TRUE(left_no_path());
  EXPECT_FALSE(fs::exists(file("report.json")));
  EXPECT_TRUE(fs::exists(file("p.csv")) && fs::exists(file("d.ply")));
}

TEST_F(StretchCommand, RefusesCloudsWithNan) {
  scan_cell_common::Cloud cloud = scan_cell_common::load_cloud(file("d.ply"));
  cloud[5].x = std::numeric_limits<float>::quiet_NaN();
  scan_cell_common::save_cloud(file("nan.ply"), cloud);
  EXPECT_EQ(run("r.ply", "nan.ply", "p.csv"), 1);
  EXPECT_NE(text_of("stderr").find("1 of 20000 points are not finite"), std::string::npos);
}

TEST_F(StretchCommand, SaysWhatItUnderstoodOfThePath) {
  std::ofstream(file("words.csv")) << "x,y,z,segment,speed\n";
  std::ofstream words(file("words.csv"), std::ios::app);
  const ToolPath on_rim = synthetic::path_on(part_, 100);
  for (const Waypoint& waypoint : on_rim.segments[0].waypoints) {
    const Eigen::Vector3d at = waypoint.pose.translation();
    words << at.x() << ',' << at.y() << ',' << at.z() << ",rim,0.5\n";
  }
  words.close();
  ASSERT_EQ(run("r.ply", "d.ply", "words.csv"), 0) << text_of("stderr");
  EXPECT_NE(text_of("stdout").find("path: 50 waypoints in 1 segment, in m; orientations: none; "
                                   "process values: speed"),
            std::string::npos)
      << text_of("stdout");
  const nlohmann::json path = report()["path"];
  EXPECT_EQ(path["waypoints"], 50);
  EXPECT_EQ(path["segments"], 1);
  EXPECT_EQ(path["orientations"], "none");
  EXPECT_EQ(path["process_values"], nlohmann::json::array({"speed"}));
}

TEST_F(StretchCommand, HeadsItsReportWithWhatToLookAt) {
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0) << text_of("stderr");
  const nlohmann::json all = report();
  std::size_t measured = 0;
  double displacement = 0, normal = 0, tangential = 0;
  for (const nlohmann::json& each : all["quality"]) {
    measured += each["measured"].get<bool>() ? 1 : 0;
    displacement = std::max(displacement, each["displacement"].get<double>());
    normal = std::max(normal, each["expected_error_normal"].get<double>());
    tangential = std::max(tangential, each["expected_error_tangential"].get<double>());
  }
  EXPECT_EQ(all["measured_waypoints"], measured);
  EXPECT_EQ(all["inferred_waypoints"], 100 - measured);
  EXPECT_EQ(all["largest_displacement"], displacement);
  EXPECT_EQ(all["largest_expected_error_normal"], normal);
  EXPECT_EQ(all["largest_expected_error_tangential"], tangential);
  const std::string said = text_of("stdout");
  EXPECT_NE(
      said.find("accepted: 100 waypoints, " + std::to_string(measured) + " measured and " +
                std::to_string(100 - measured) + " inferred, 0 in the air, displaced by up to "),
      std::string::npos)
      << said;
  EXPECT_NE(said.find("expected error up to "), std::string::npos) << said;
}

TEST_F(StretchCommand, ReportsTheWholeTimeWithItsParts) {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const nlohmann::json parts = report()["seconds_of"];
  const double seconds = report()["seconds"];
  EXPECT_GT(parts["reading"], 0);
  EXPECT_GT(parts["adapting"], 0);
  EXPECT_GT(parts["writing"], 0);
  EXPECT_NEAR(seconds,
              parts["reading"].get<double>() + parts["adapting"].get<double>() +
                  parts["writing"].get<double>(),
              1e-9);
  EXPECT_LT(seconds, wall);
}

TEST_F(StretchCommand, ReportsNullForWhatItDoesNotKnow) {
  ASSERT_EQ(run("no.ply", "d.ply", "p.csv"), 1);
  for (const char* const figure :
       {"scale", "translation", "rotation", "transform", "deformation_nodes", "rms", "inlier_ratio",
        "overlap", "reference_points", "object_points", "measured_waypoints", "inferred_waypoints",
        "waypoints_in_air", "largest_displacement", "largest_expected_error_normal"}) {
    EXPECT_TRUE(report()[figure].is_null()) << figure;
  }
  EXPECT_EQ(report()["path"]["waypoints"], 100);
  EXPECT_TRUE(report()["files"]["reference"].is_null());
  std::ofstream(file("bad.csv")) << "no path";
  ASSERT_EQ(run("r.ply", "d.ply", "bad.csv"), 1);
  EXPECT_TRUE(report()["path"].is_null());
}

TEST_F(StretchCommand, ReportsTheHashesOfItsFiles) {
  std::ofstream(file("abc")) << "abc";  // the example of FIPS 180-2
  EXPECT_EQ(record_of(file("abc"), "m").sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const std::map<std::string, std::string> files = {
      {"reference", "r.ply"}, {"object", "d.ply"}, {"path", "p.csv"}, {"output", "out.csv"}};
  for (const auto& [role, name] : files) {
    EXPECT_EQ(report()["files"][role]["name"], file(name));
    EXPECT_EQ(report()["files"][role]["sha256"], record_of(file(name), "m").sha256) << role;
  }
}

TEST_F(StretchCommand, RefusesBadEndingsBeforeTheWork) {
  EXPECT_EQ(run_into("out.txt", "report.json", "no.ply"), 1);
  EXPECT_NE(text_of("stderr").find("extension '.txt'"), std::string::npos) << text_of("stderr");
  EXPECT_EQ(run_into("no/folder/out.csv", "report.json", "no.ply"), 1);
  EXPECT_NE(text_of("stderr").find("no folder"), std::string::npos) << text_of("stderr");
  std::ofstream(file("out.csv")) << "an old path";
  EXPECT_EQ(run_into("out.csv", "report.txt", "no.ply"), 1);
  EXPECT_NE(text_of("stderr").find("report.txt: extension '.txt'"), std::string::npos)
      << text_of("stderr");
  EXPECT_TRUE(left_no_path());
}

TEST_F(StretchCommand, TakesACadReferenceInMillimetresAndAScanInMetres) {
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const ToolPath expected = tool_paths::load_tool_path(file("out.csv"));
  scan_cell_common::save_cloud(
      file("r_mm.ply"),
      to_cloud(scaled(to_points(scan_cell_common::load_cloud(file("r.ply"))), 1000)));
  tool_paths::PathLayout millimetres = tool_paths::load_tool_path_file(file("p.csv")).layout;
  millimetres.pose.units = "mm";
  tool_paths::save_tool_path(file("p_mm.csv"), tool_paths::load_tool_path(file("p.csv")),
                             millimetres);
  ASSERT_EQ(run("r_mm.ply", "d.ply", "p_mm.csv", "--units mm --object-units m"), 0)
      << text_of("stderr");
  EXPECT_EQ(report()["path"]["units"], "mm");
  EXPECT_EQ(report()["files"]["object"]["units"], "m");
  EXPECT_NEAR(report()["scale"], 1.08, 0.001);
  tool_paths::PathConventions in_millimetres;
  in_millimetres.units = "mm";
  const ToolPath found = tool_paths::load_tool_path(file("out.csv"), in_millimetres);
  EXPECT_LT(synthetic::error_of(found, expected).rms, 1e-5);
  EXPECT_EQ(run("r_mm.ply", "d.ply", "p_mm.csv", "--units ell"), 1);
  EXPECT_NE(text_of("stderr").find("'ell'; give m, mm or inch"), std::string::npos)
      << text_of("stderr");
}

TEST_F(StretchCommand, TurnsEulerAnglesAndNeverCopiesThem) {
  ASSERT_EQ(run("r.ply", "d.ply", "p.csv"), 0);
  const ToolPath expected = tool_paths::load_tool_path(file("out.csv"));
  tool_paths::PathLayout angles = tool_paths::load_tool_path_file(file("p.csv")).layout;
  angles.columns.clear();
  angles.pose.orientation = tool_paths::OrientationKind::kEuler;
  angles.pose.euler = "zyx";
  angles.pose.degrees = true;
  angles.pose.names = {"rz", "ry", "rx"};
  tool_paths::save_tool_path(file("angles.csv"), tool_paths::load_tool_path(file("p.csv")), angles);
  EXPECT_EQ(run("r.ply", "d.ply", "angles.csv"), 1);
  EXPECT_NE(text_of("stderr").find("'rx', 'ry', 'rz' could be an orientation"), std::string::npos)
      << text_of("stderr");
  EXPECT_EQ(report()["reason"], "unusable_input");
  EXPECT_TRUE(left_no_path());
  ASSERT_EQ(run("r.ply", "d.ply", "angles.csv", "--euler zyx --degrees"), 0) << text_of("stderr");
  const std::string written = text_of("out.csv");
  EXPECT_EQ(written.substr(0, written.find('\n')),
            text_of("angles.csv").substr(0, text_of("angles.csv").find('\n')));
  tool_paths::PathConventions given;
  given.euler = "zyx";
  given.angles = tool_paths::AngleUnit::kDegrees;
  const ToolPath found = tool_paths::load_tool_path(file("out.csv"), given);
  for (std::size_t i = 0; i < found.segments[0].waypoints.size(); ++i) {
    EXPECT_TRUE(
        found.segments[0].waypoints[i].pose.isApprox(expected.segments[0].waypoints[i].pose, 1e-6));
  }
}
