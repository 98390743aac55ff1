// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"
#include "tool_path_stretcher/report.h"

namespace tool_path_stretcher {
namespace {

std::string sha256_of(const std::string& bytes, const std::string& file) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw scan_cell_common::FileError(file, "its SHA-256 could not be computed",
                                      "check the installation of OpenSSL");
  }
  constexpr const char* kDigits = "0123456789abcdef";
  constexpr unsigned int kBase = 16;
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += kDigits[digest.at(i) / kBase];
    text += kDigits[digest.at(i) % kBase];
  }
  return text;
}

/// The larger of two, of which one may not be known.
double larger(double one, double other) {
  return std::fmax(one, other);
}

std::string millimetres(double metres) {
  if (!std::isfinite(metres)) return "unknown";
  std::ostringstream text;
  text.precision(3);
  text << 1e3 * metres << " mm";
  return text.str();
}

}  // namespace

FileRecord record_of(const std::string& file, const std::string& units) {
  return {file, sha256_of(scan_cell_common::read_file(file), file), units};
}

double total_seconds(const StretchResult& result, const RunRecord& record) {
  return record.seconds_reading + result.seconds + record.seconds_writing;
}

QualitySummary summary_of(const std::vector<WaypointQuality>& quality) {
  QualitySummary summary;
  for (const WaypointQuality& each : quality) {
    ++(each.measured ? summary.measured : summary.inferred);
    summary.largest_displacement = larger(summary.largest_displacement, each.displacement);
    summary.largest_expected_error_normal =
        larger(summary.largest_expected_error_normal, each.expected_error_normal);
    summary.largest_expected_error_tangential =
        larger(summary.largest_expected_error_tangential, each.expected_error_tangential);
  }
  return summary;
}

std::string to_string(const QualitySummary& summary) {
  return std::to_string(summary.measured + summary.inferred) + " waypoints, " +
         std::to_string(summary.measured) + " measured and " + std::to_string(summary.inferred) +
         " inferred, displaced by up to " + millimetres(summary.largest_displacement) +
         ", expected error up to " + millimetres(summary.largest_expected_error_normal) +
         " along the normal and " + millimetres(summary.largest_expected_error_tangential) +
         " along the surface";
}

}  // namespace tool_path_stretcher
