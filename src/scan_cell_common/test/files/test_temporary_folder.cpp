// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/temporary_folder.h"

namespace fs = std::filesystem;
using scan_cell_common::TemporaryFolder;

TEST(TemporaryFolder, GoesWithAllThatIsInIt) {
  auto folder = std::make_unique<TemporaryFolder>("test_temporary_folder");
  const TemporaryFolder other("test_temporary_folder");
  const fs::path path = folder->path();
  EXPECT_NE(path, other.path());
  fs::create_directory(path / "below");
  std::ofstream(path / "below" / "file") << "text";
  std::ofstream(folder->file("beside")) << "text";
  ASSERT_TRUE(fs::exists(path / "beside"));
  folder.reset();
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::is_directory(other.path()));
}

TEST(TemporaryFolder, SaysWhereItCannotBeMade) {
  EXPECT_THROW(TemporaryFolder("no/such/folder"), scan_cell_common::FileError);
}
