// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <map>

#include "scalars.h"
#include "scan_cell_common/cloud_files.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/text.h"

namespace scan_cell_common {
namespace {

enum class Format { kAscii, kLittleEndian, kBigEndian };

struct Property {
  std::string name;
  Scalar type;
  bool is_list = false;
  Scalar count_type = Scalar::kUint8;  // of a list

  std::size_t least_size() const { return size_of(is_list ? count_type : type); }
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::kAscii;
  std::vector<Element> elements;
};

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

using Words = std::vector<std::string_view>;

Format format_of(const Words& words, const std::string& where) {
  if (words.size() >= 2 && words[1] == "ascii") return Format::kAscii;
  if (words.size() >= 2 && words[1] == "binary_little_endian") return Format::kLittleEndian;
  if (words.size() >= 2 && words[1] == "binary_big_endian") return Format::kBigEndian;
  throw FileError(where, "an unknown format",
                  "write it as ascii, binary_little_endian or binary_big_endian");
}

Element element_of(const Words& words, const std::string& where) {
  const auto count = words.size() == 3 ? parse_count(words[2]) : std::nullopt;
  if (!count) throw FileError(where, "no name and count of an element", "correct the header");
  return {std::string(words[1]), *count, {}};
}

Property property_of(const Words& words, const std::string& where) {
  if (words.size() == 5 && words[1] == "list") {
    const Scalar count_type = scalar_of(words[2], where);
    if (is_real(count_type)) {
      throw FileError(where, "a list counted in '" + excerpt(words[2]) + "'", "count in integers");
    }
    return {std::string(words[4]), scalar_of(words[3], where), true, count_type};
  }
  if (words.size() == 3) return {std::string(words[2]), scalar_of(words[1], where)};
  throw FileError(where, "no type and name of a property", "correct the header");
}

Header header_of(LineReader& lines, const std::string& source) {
  if (!lines.next() || lines.words() != Words{"ply"}) {
    throw FileError(source, "no PLY file", "give a cloud as PLY or PCD");
  }
  Header header;
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

/// Which properties of a vertex are x, y and z.
std::array<std::size_t, 3> find_coordinates(const Element& vertex, const std::string& source) {
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  std::array<std::size_t, 3> found{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t times = 0;
    for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
      if (vertex.properties[i].name != kNames[axis]) continue;
      found[axis] = i;
      ++times;
    }
    if (times == 1 && !vertex.properties[found[axis]].is_list &&
        is_real(vertex.properties[found[axis]].type)) {
      continue;
    }
    throw FileError(
        source, "its vertices have no single " + std::string(kNames[axis]) + " as float or double",
        "write it again with x, y and z as float or double");
  }
  return found;
}

[[noreturn]] void refuse_truncated(const std::string& source, const Element& element,
                                   std::uint64_t read) {
  throw FileError(source,
                  "truncated: " + std::to_string(read) + " of " + std::to_string(element.count) +
                      " of its element '" + excerpt(element.name) + "' are there",
                  "write the file again");
}

/// A header that promises more than the file can hold is refused before anything is made for it.
void check_count(const Element& element, std::size_t least_size, std::size_t left,
                 const std::string& source) {
  if (element.count <= left / least_size) return;
  throw FileError(source,
                  "truncated: its header promises " + std::to_string(element.count) +
                      " of the element '" + excerpt(element.name) + "', it has " +
                      std::to_string(left) + " bytes for them",
                  "write the file again");
}

class AsciiBody {
 public:
  AsciiBody(LineReader& lines, const std::string& source) : lines_(lines), source_(source) {}

  /// @param take gets the word of each property's value, that of the length for lists
  template <class Take>
  void read(const Element& element, const Take& take) {
    check_count(element, 2 * element.properties.size(), lines_.left() + 1, source_);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (!lines_.next_filled()) refuse_truncated(source_, element, row);
      split(element);
      take(values_);
    }
  }

  float number(std::string_view word) const {
    const std::optional<double> value = parse_number(word);
    if (!value) throw FileError(lines_.where(), "'" + excerpt(word) + "'", "give a number");
    return to_float(*value);
  }

  void end() {
    if (!lines_.next_filled()) return;
    throw FileError(lines_.where(), "more than the header promises", "correct the header");
  }

 private:
  void split(const Element& element) {
    const Words& words = lines_.words();
    values_.clear();
    std::size_t at = 0;
    for (const Property& property : element.properties) {
      if (at >= words.size()) refuse_row(element);
      values_.push_back(words[at++]);
      if (!property.is_list) continue;
      const std::optional<std::uint64_t> length = parse_count(values_.back());
      if (!length || *length > words.size() - at) refuse_row(element);
      at += *length;
    }
    if (at != words.size()) refuse_row(element);
  }

  [[noreturn]] void refuse_row(const Element& element) const {
    throw FileError(lines_.where(), std::to_string(lines_.words().size()) + " values",
                    "give as many as the header names for each '" + excerpt(element.name) + "'");
  }

  LineReader& lines_;
  const std::string& source_;
  Words values_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, bool big_endian, const std::string& source)
      : bytes_(bytes), big_endian_(big_endian), source_(source) {}

  /// @param take gets the bytes of each property's value, none for lists
  template <class Take>
  void read(const Element& element, const Take& take) {
    std::size_t least_size = 0;
    for (const Property& property : element.properties)
      least_size += property.least_size();
    check_count(element, least_size, bytes_.size() - at_, source_);
    std::vector<const char*> values(element.properties.size());
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = next(element.properties[i], element, row);
      take(values);
    }
  }

  float number(const char* value, Scalar type) const {
    return load_float(value, type, big_endian_);
  }

  void end() const {
    if (bytes_.find_first_not_of(std::string_view("\0 \t\r\n", 5), at_) == std::string_view::npos)
      return;
    throw FileError(source_,
                    std::to_string(bytes_.size() - at_) + " bytes more than its header promises",
                    "write the file again");
  }

 private:
  const char* next(const Property& property, const Element& element, std::uint64_t row) {
    const char* value = advance(property.least_size(), element, row);
    if (!property.is_list) return value;
    advance(length(value, property.count_type) * size_of(property.type), element, row);
    return nullptr;
  }

  const char* advance(std::uint64_t size, const Element& element, std::uint64_t row) {
    if (size > bytes_.size() - at_) refuse_truncated(source_, element, row);
    const char* place = bytes_.data() + at_;
    at_ += size;
    return place;
  }

  /// A negative length becomes one that no file holds.
  std::uint64_t length(const char* value, Scalar type) const {
    switch (type) {
      case Scalar::kInt8:
      case Scalar::kUint8:
        return load_as<std::uint8_t>(value, big_endian_);
      case Scalar::kInt16:
      case Scalar::kUint16:
        return load_as<std::uint16_t>(value, big_endian_);
      default:
        return load_as<std::uint32_t>(value, big_endian_);
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool big_endian_;
  const std::string& source_;
};

/// Goes through all elements, so that a truncated file is seen also where its vertices are whole.
template <class Body, class TakeVertex>
void read_body(const Header& header, Body& body, const TakeVertex& take_vertex) {
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.name == "vertex") {
      body.read(element, take_vertex);
    } else {
      body.read(element, [](const auto&) {});
    }
  }
  body.end();
}

const Element& vertex_of(const Header& header, const std::string& source) {
  const auto is_vertex = [](const Element& element) { return element.name == "vertex"; };
  if (std::count_if(header.elements.begin(), header.elements.end(), is_vertex) != 1) {
    throw FileError(source, "no single element 'vertex'", "write it again with x, y and z");
  }
  return *std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
}

}  // namespace

Cloud parse_ply(std::string_view file, const std::string& source) {
  const std::string_view bytes = without_byte_order_mark(file);
  LineReader lines(bytes, source);
  const Header header = header_of(lines, source);
  const Element& vertex = vertex_of(header, source);
  const std::array<std::size_t, 3> xyz = find_coordinates(vertex, source);
  Cloud cloud;
  if (header.format == Format::kAscii) {
    AsciiBody body(lines, source);
    read_body(header, body, [&](const Words& values) {
      cloud.points.emplace_back(body.number(values[xyz[0]]), body.number(values[xyz[1]]),
                                body.number(values[xyz[2]]));
    });
  } else {
    BinaryBody body(bytes.substr(lines.position()), header.format == Format::kBigEndian, source);
    const auto number = [&](const std::vector<const char*>& values, std::size_t axis) {
      return body.number(values[xyz[axis]], vertex.properties[xyz[axis]].type);
    };
    read_body(header, body, [&](const std::vector<const char*>& values) {
      cloud.points.emplace_back(number(values, 0), number(values, 1), number(values, 2));
    });
  }
  cloud.width = static_cast<std::uint32_t>(cloud.points.size());
  cloud.height = 1;
  return cloud;
}

}  // namespace scan_cell_common
