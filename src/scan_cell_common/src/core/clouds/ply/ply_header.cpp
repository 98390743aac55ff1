// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/ply/ply_header.h"

#include <map>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

using Words = std::vector<std::string_view>;

Scalar scalar_of(std::string_view name, const std::string& where) {
  static const std::map<std::string_view, Scalar> kNames = {
      {"char", Scalar::kInt8},     {"int8", Scalar::kInt8},     {"uchar", Scalar::kUint8},
      {"uint8", Scalar::kUint8},   {"short", Scalar::kInt16},   {"int16", Scalar::kInt16},
      {"ushort", Scalar::kUint16}, {"uint16", Scalar::kUint16}, {"int", Scalar::kInt32},
      {"int32", Scalar::kInt32},   {"uint", Scalar::kUint32},   {"uint32", Scalar::kUint32},
      {"float", Scalar::kFloat},   {"float32", Scalar::kFloat}, {"double", Scalar::kDouble},
      {"float64", Scalar::kDouble}};
  const auto found = kNames.find(name);
  if (found == kNames.end()) {
    throw FileError(where, "type '" + excerpt(name) + "'",
                    "give one that PLY knows, such as float");
  }
  return found->second;
}

PlyFormat format_of(const Words& words, const std::string& where) {
  if (words.size() >= 2 && words[1] == "ascii") return PlyFormat::kAscii;
  if (words.size() >= 2 && words[1] == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (words.size() >= 2 && words[1] == "binary_big_endian") return PlyFormat::kBigEndian;
  throw FileError(where, "an unknown format",
                  "write it as ascii, binary_little_endian or binary_big_endian");
}

PlyElement element_of(const Words& words, const std::string& where) {
  const auto count = words.size() == 3 ? parse_count(words[2]) : std::nullopt;
  if (!count) throw FileError(where, "an element without name and count", "correct the header");
  return {std::string(words[1]), *count, {}};
}

PlyProperty property_of(const Words& words, const std::string& where) {
  if (words.size() == 5 && words[1] == "list") {
    const Scalar count_type = scalar_of(words[2], where);
    if (is_real(count_type)) {
      throw FileError(where, "a list with a count of type '" + excerpt(words[2]) + "'",
                      "give an integer type");
    }
    return {std::string(words[4]), scalar_of(words[3], where), true, count_type};
  }
  if (words.size() == 3) return {std::string(words[2]), scalar_of(words[1], where)};
  throw FileError(where, "a property without type and name", "correct the header");
}

}  // namespace

PlyHeader read_ply_header(LineReader& lines, const std::string& source) {
  if (!lines.next() || lines.words() != Words{"ply"}) {
    throw FileError(source, "not a PLY file", "give a cloud as PLY or PCD");
  }
  PlyHeader header;
  bool has_format = false;
  while (lines.next()) {
    const Words& words = lines.words();
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (!has_format) throw FileError(source, "no format in its header", "write it again");
      return header;
    }
    if (words[0] == "format") {
      header.format = format_of(words, lines.where());
      has_format = true;
    } else if (words[0] == "element") {
      header.elements.push_back(element_of(words, lines.where()));
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(words, lines.where()));
    } else {
      throw FileError(lines.where(), "'" + excerpt(words[0]) + "' in the header",
                      "correct the header");
    }
  }
  throw FileError(source, "truncated: its header has no end", "write the file again");
}

}  // namespace scan_cell_common
