// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace scan_cell_common {

std::string sha256_of(const std::string& bytes, const std::string& name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw FileError(name, "its SHA-256 could not be computed", "check the installation of OpenSSL");
  return fmt::format("{:02x}", fmt::join(digest.begin(), digest.begin() + length, ""));
}

std::string sha256_of_file(const std::string& path) {
  return sha256_of(read_file(path), path);
}

}  // namespace scan_cell_common
