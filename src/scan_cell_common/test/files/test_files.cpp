// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace fs = std::filesystem;
using namespace scan_cell_common;

namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  fs::path folder_ = fs::temp_directory_path() / ("files_" + std::to_string(getpid()));
};

std::string complaint(const std::string& path) {
  try {
    read_file(path);
  } catch (const FileError& error) {
    EXPECT_EQ(error.thing(), path);
    return error.value();
  }
  return "";
}

}  // namespace

TEST_F(Files, ComeBackByteByByte) {
  const std::string bytes("\0\r\n\xff text", 9);
  save_text(path("a"), bytes);
  EXPECT_EQ(read_file(path("a")), bytes);
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, AreRefusedByNameWhereTheyAreNone) {
  EXPECT_EQ(complaint(path("missing")), "no such file");
  EXPECT_EQ(complaint(path("")), "a folder, a device or a pipe, not a file");
  EXPECT_EQ(complaint("/dev/null"), "a folder, a device or a pipe, not a file");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(complaint(path("pipe")), "a folder, a device or a pipe, not a file");
  save_text(path("file"), "text");
  EXPECT_NE(complaint(path("file/below")), "");
}

TEST_F(Files, AreNotReadWhereTheyWouldFillTheMemory) {
  std::ofstream(path("huge")).put('x');
  std::error_code failure;
  fs::resize_file(path("huge"), std::uintmax_t{1} << 36, failure);  // with a hole
  if (failure) GTEST_SKIP() << failure.message();
  EXPECT_EQ(complaint(path("huge")), "larger than 2 GiB");
}

TEST_F(Files, AreRefusedWithoutPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  save_text(path("secret"), "text");
  fs::permissions(path("secret"), fs::perms::none);
  EXPECT_EQ(complaint(path("secret")), "cannot be read: Permission denied");
}

TEST_F(Files, AreWrittenWholeOrNotAtAll) {
  save_text(path("a"), "old");
  EXPECT_THROW(save_whole(path("a"),
                          [](const std::string& partial) {
                            std::ofstream(partial) << "half";
                            return false;
                          }),
               FileError);
  EXPECT_THROW(save_whole(path("a"),
                          [](const std::string& partial) -> bool {
                            std::ofstream(partial) << "half";
                            throw std::runtime_error("full");
                          }),
               std::runtime_error);
  EXPECT_EQ(read_file(path("a")), "old");
  EXPECT_EQ(entries(), 1U);
  fs::create_directory(path("taken"));
  EXPECT_THROW(save_text(path("taken"), "text"), FileError);
  EXPECT_THROW(save_text(path("no/such/folder/a"), "text"), FileError);
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Files, AreNotWrittenOverWhatIsRead) {
  save_text(path("scan.ply"), "text");
  fs::create_symlink(path("scan.ply"), path("link.ply"));
  fs::create_directory(path("folder"));
  for (const std::string same : {"scan.ply", "link.ply", "folder/../scan.ply", "./scan.ply"})
    EXPECT_THROW(refuse_overwriting(path(same), {path("other"), path("scan.ply")}), FileError);
  EXPECT_THROW(refuse_overwriting(path("new"), {path("folder/../new")}), FileError);
  EXPECT_NO_THROW(refuse_overwriting(path("new"), {path("scan.ply"), ""}));
}

TEST_F(Files, ToWriteAreRefusedByTheirEndingOrFolderBeforeTheWork) {
  EXPECT_NO_THROW(check_output(path("a.PLY"), {".ply", ".pcd"}, "cure"));
  EXPECT_NO_THROW(check_output("a.ply", {".ply"}, "cure"));
  const auto refused = [](const std::string& name) -> std::string {
    try {
      check_output(name, {".ply", ".pcd"}, "write clouds as .ply or .pcd");
    } catch (const FileError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(refused("a.xyz"), "a.xyz: extension '.xyz'; write clouds as .ply or .pcd");
  EXPECT_EQ(refused("a"), "a: extension ''; write clouds as .ply or .pcd");
  EXPECT_NE(refused(path("none/a.ply")).find("no folder"), std::string::npos);
}
