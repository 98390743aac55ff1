// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <lzf.h>

#include <algorithm>
#include <array>
#include <limits>

#include "clouds/carried_fields.h"
#include "files/scalars.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

using Words = std::vector<std::string_view>;

struct Field {
  std::string name;
  std::uint64_t size = 4;  // [bytes] of one value
  std::string_view type = "F";
  std::uint64_t count = 1;
};

struct Header {
  std::vector<Field> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  std::optional<std::uint64_t> points;
  std::string_view data;
};

/// Location of a number of a point.
struct Number {
  std::size_t word = 0;    // index in a line
  std::size_t offset = 0;  // [bytes] of the fields before it in a point
  Scalar type = Scalar::kFloat;
};

/// Location and size of all numbers of a point.
struct Layout {
  std::array<Number, 3> xyz;
  std::vector<Number> carried;  // besides
  std::size_t words = 0;
  std::size_t size = 0;  // [bytes]
};

std::uint64_t count_of(std::string_view word, std::uint64_t most, const std::string& where) {
  const std::optional<std::uint64_t> count = parse_count(word);
  if (count && *count <= most) return *count;
  throw FileError(where, "'" + excerpt(word) + "'",
                  fmt::format("give a whole number up to {}", most));
}

void set_fields(Header& header, const Words& words, const std::string& where) {
  const std::string_view key = words[0];
  if (key == "FIELDS" || key == "COLUMNS") {
    header.fields.assign(words.size() - 1, {});
    for (std::size_t i = 0; i < header.fields.size(); ++i)
      header.fields[i].name = words[i + 1];
    return;
  }
  if (header.fields.size() != words.size() - 1) {
    throw FileError(where,
                    fmt::format("{} values for {} fields", words.size() - 1, header.fields.size()),
                    "correct the header");
  }
  constexpr std::uint64_t kMaxSize = 8;
  constexpr std::uint64_t kMaxCount = 1000000;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    if (key == "SIZE") header.fields[i].size = count_of(words[i + 1], kMaxSize, where);
    if (key == "TYPE") header.fields[i].type = words[i + 1];
    if (key == "COUNT") header.fields[i].count = count_of(words[i + 1], kMaxCount, where);
  }
}

void set_size(Header& header, const Words& words, const std::string& where) {
  constexpr std::uint64_t kMost = 0x7fffffff;
  const std::string_view key = words[0];
  if (words.size() != 2) throw FileError(where, "not exactly one number", "correct the header");
  const std::uint64_t count = count_of(words[1], kMost, where);
  if (key == "WIDTH") header.width = count;
  if (key == "HEIGHT") header.height = count;
  if (key == "POINTS") header.points = count;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> known) {
  return std::find(known.begin(), known.end(), word) != known.end();
}

Header header_of(LineReader& lines, const std::string& source) {
  Header header;
  while (lines.next_filled()) {
    const Words& words = lines.words();
    const std::string_view key = words[0];
    if (key[0] == '#' || is_one_of(key, {"VERSION", "VIEWPOINT"})) continue;
    if (is_one_of(key, {"FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT"})) {
      set_fields(header, words, lines.where());
    } else if (is_one_of(key, {"WIDTH", "HEIGHT", "POINTS"})) {
      set_size(header, words, lines.where());
    } else if (key == "DATA" && words.size() == 2) {
      header.data = words[1];
      return header;
    } else {
      throw FileError(lines.where(), "'" + excerpt(key) + "' in the header of a PCD file",
                      "give a cloud as PLY or PCD");
    }
  }
  throw FileError(source, "not a PCD file, or its header has no end", "write the file again");
}

/// @return number of points that the header promises
std::uint64_t points_of(const Header& header, const std::string& source) {
  const std::uint64_t points = header.width * header.height;
  if (!header.points || *header.points == points) return points;
  throw FileError(source,
                  fmt::format("{} points in {} x {}", *header.points, header.width, header.height),
                  "correct WIDTH, HEIGHT and POINTS");
}

/// None if the field is not a single number, or has 64 bits and is not a double.
std::optional<Scalar> scalar_of(const Field& field) {
  constexpr std::string_view kPadding = "_";
  struct Known {
    std::string_view type;
    std::uint64_t size;
    Scalar scalar;
  };
  constexpr Known kKnown[] = {{"I", 1, Scalar::kInt8},  {"U", 1, Scalar::kUint8},
                              {"I", 2, Scalar::kInt16}, {"U", 2, Scalar::kUint16},
                              {"I", 4, Scalar::kInt32}, {"U", 4, Scalar::kUint32},
                              {"F", 4, Scalar::kFloat}, {"F", 8, Scalar::kDouble}};
  if (field.count != 1 || field.name == kPadding) return std::nullopt;
  for (const Known& known : kKnown)
    if (field.type == known.type && field.size == known.size) return known.scalar;
  return std::nullopt;
}

/// @param carried receives the fields; null: not wanted
Layout layout_of(const Header& header, const std::string& source, FieldedCloud* carried) {
  Layout layout;
  if (carried != nullptr) add_coordinates(*carried);
  std::array<int, 3> times{};
  for (const Field& field : header.fields) {
    const std::size_t axis = std::string_view("xyz").find(field.name);
    const std::optional<Scalar> scalar = scalar_of(field);
    if (field.name.size() == 1 && axis != std::string_view::npos && scalar && is_real(*scalar)) {
      layout.xyz[axis] = {layout.words, layout.size, *scalar};
      ++times[axis];
    } else if (carried != nullptr && scalar && add_field(*carried, field.name, *scalar)) {
      layout.carried.push_back({layout.words, layout.size, *scalar});
    }
    layout.words += field.count;
    layout.size += field.count * field.size;
  }
  if (times == std::array<int, 3>{1, 1, 1}) return layout;
  throw FileError(source, "not exactly one x, y and z as float or double",
                  "write it again with x, y and z as float or double");
}

[[noreturn]] void refuse_truncated(const std::string& source, std::uint64_t points,
                                   std::size_t bytes) {
  throw FileError(source,
                  fmt::format("truncated: its header promises {} points, but only {} bytes follow",
                              points, bytes),
                  "write the file again");
}

/// Refuses a header that promises more than the file can hold, before any memory is allocated.
void check_count(std::uint64_t points, std::size_t size, std::size_t bytes,
                 const std::string& source) {
  if (points > bytes / size) refuse_truncated(source, points, bytes);
}

void read_ascii(LineReader& lines, const Layout& layout, std::uint64_t points,
                const std::string& source, Cloud& cloud, FieldedCloud* carried) {
  check_count(points, 2 * layout.words, lines.left() + 1, source);
  const auto number = [&lines](std::string_view word) {
    const std::optional<double> value = parse_number(word);
    if (!value) throw FileError(lines.where(), "'" + excerpt(word) + "'", "give a number");
    return *value;
  };
  for (std::uint64_t i = 0; i < points; ++i) {
    if (!lines.next_filled()) {
      throw FileError(source, fmt::format("truncated: it has {} of {} points", i, points),
                      "write the file again");
    }
    const Words& words = lines.words();
    if (words.size() != layout.words) {
      throw FileError(lines.where(), fmt::format("{} values", words.size()),
                      fmt::format("give {}, as the header says", layout.words));
    }
    cloud.points.emplace_back(to_float(number(words[layout.xyz[0].word])),
                              to_float(number(words[layout.xyz[1].word])),
                              to_float(number(words[layout.xyz[2].word])));
    if (carried == nullptr) continue;
    append_place(cloud.points.back(), *carried);
    for (const Number& each : layout.carried)
      append_scalar(number(words[each.word]), each.type, *carried);
  }
  if (lines.next_filled()) {
    throw FileError(lines.where(), "more than the header promises", "correct the header");
  }
}

/// @param place of a number of a point: place(point, number)
template <class Place>
void read_numbers(const Layout& layout, std::uint64_t points, const Place& place, Cloud& cloud,
                  FieldedCloud* carried) {
  constexpr bool kBigEndian = false;
  for (std::uint64_t i = 0; i < points; ++i) {
    const auto number = [&](const Number& at) {
      return load_float(place(i, at), at.type, kBigEndian);
    };
    cloud.points.emplace_back(number(layout.xyz[0]), number(layout.xyz[1]), number(layout.xyz[2]));
    if (carried == nullptr) continue;
    append_place(cloud.points.back(), *carried);
    for (const Number& each : layout.carried)
      append_scalar(place(i, each), each.type, kBigEndian, *carried);
  }
}

void read_binary(std::string_view bytes, const Layout& layout, std::uint64_t points,
                 const std::string& source, Cloud& cloud, FieldedCloud* carried) {
  check_count(points, layout.size, bytes.size(), source);
  read_numbers(
      layout, points,
      [&](std::uint64_t point, const Number& at) {
        return bytes.data() + point * layout.size + at.offset;
      },
      cloud, carried);
  const std::string_view rest = bytes.substr(points * layout.size);
  if (rest.find_first_not_of(std::string_view("\0 \t\r\n", 5)) != std::string_view::npos) {
    throw FileError(source, fmt::format("{} bytes more than its header promises", rest.size()),
                    "write the file again");
  }
}

/// Unpacks LZF: two sizes, then field by field, each for all points.
std::string unpacked(std::string_view bytes, std::uint64_t wanted, const std::string& source) {
  constexpr std::size_t kSizes = 8;
  constexpr std::uint64_t kMaxRatio = 264 / 3;  // three bytes of LZF give at most 264
  if (bytes.size() <= kSizes) refuse_truncated(source, wanted, bytes.size());
  const auto packed_size = load_as<std::uint32_t>(bytes.data(), false);
  const auto size = load_as<std::uint32_t>(bytes.data() + 4, false);
  const std::string_view packed = bytes.substr(kSizes);
  if (packed_size == 0 || packed_size > packed.size() || size != wanted ||
      size > kMaxRatio * packed_size) {
    throw FileError(source, "truncated, or its sizes contradict each other",
                    "write the file again");
  }
  std::string result(size, '\0');
  if (lzf_decompress(packed.data(), packed_size, result.data(), size) != size) {
    throw FileError(source, "its compressed points are corrupt", "write the file again");
  }
  return result;
}

void read_compressed(std::string_view bytes, const Layout& layout, std::uint64_t points,
                     const std::string& source, Cloud& cloud, FieldedCloud* carried) {
  check_count(points, layout.size, std::numeric_limits<std::uint32_t>::max(), source);
  const std::string fields = unpacked(bytes, points * layout.size, source);
  read_numbers(
      layout, points,
      [&](std::uint64_t point, const Number& at) {
        return fields.data() + at.offset * points + point * size_of(at.type);
      },
      cloud, carried);
}

}  // namespace

Cloud parse_pcd(std::string_view file, const std::string& source, FieldedCloud* carried) {
  const std::string_view bytes = without_byte_order_mark(file);
  LineReader lines(bytes, source);
  const Header header = header_of(lines, source);
  const std::uint64_t points = points_of(header, source);
  const Layout layout = layout_of(header, source, carried);
  Cloud cloud;
  if (header.data == "ascii") {
    read_ascii(lines, layout, points, source, cloud, carried);
  } else if (header.data == "binary") {
    read_binary(bytes.substr(lines.position()), layout, points, source, cloud, carried);
  } else if (header.data == "binary_compressed" && points > 0) {
    read_compressed(bytes.substr(lines.position()), layout, points, source, cloud, carried);
  } else if (header.data != "binary_compressed") {
    throw FileError(source, "DATA '" + excerpt(header.data) + "'",
                    "write it as ascii, binary or binary_compressed");
  }
  cloud.width = static_cast<std::uint32_t>(header.width);
  cloud.height = static_cast<std::uint32_t>(header.height);
  return cloud;
}

Cloud parse_pcd(std::string_view bytes, const std::string& source) {
  return parse_pcd(bytes, source, nullptr);
}

}  // namespace scan_cell_common
