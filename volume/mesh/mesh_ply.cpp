#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "volume/mesh/mesh_text.h"

namespace isoloop {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct ScalarName {
  std::string_view name;
  std::string_view old_name;
  std::size_t bytes;
};

constexpr std::array<ScalarName, 8> scalars{{{"int8", "char", 1},
                                             {"uint8", "uchar", 1},
                                             {"int16", "short", 2},
                                             {"uint16", "ushort", 2},
                                             {"int32", "int", 4},
                                             {"uint32", "uint", 4},
                                             {"float32", "float", 4},
                                             {"float64", "double", 8}}};

std::size_t bytes_of(Scalar scalar) { return scalars.at(static_cast<std::size_t>(scalar)).bytes; }

bool is_whole(Scalar scalar) { return scalar < Scalar::float32; }

enum class Use { none, x, y, z, corners };

struct Property {
  Use use = Use::none;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count{};  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Format { ascii, little, big };

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
};

Scalar scalar_of(const LineReader& lines, std::string_view word) {
  for (std::size_t s = 0; s < scalars.size(); ++s) {
    if (word == scalars[s].name || word == scalars[s].old_name) return static_cast<Scalar>(s);
  }
  throw lines.error("a property is of no type that PLY has");
}

Use use_of(const Element& element, std::string_view name, bool list) {
  if (element.name == "face" && list && (name == "vertex_indices" || name == "vertex_index")) {
    return Use::corners;
  }
  if (element.name != "vertex" || list) return Use::none;
  if (name == "x") return Use::x;
  if (name == "y") return Use::y;
  return name == "z" ? Use::z : Use::none;
}

Property property_of(const LineReader& lines, const Element& element) {
  const auto& words = lines.words();
  Property property;
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) throw lines.error("a property is not stated as PLY has it");
  if (list) {
    property.count = scalar_of(lines, words[2]);
    if (!is_whole(*property.count)) throw lines.error("the length of a list is a whole number");
  }
  property.type = scalar_of(lines, words[list ? 3 : 1]);
  property.use = use_of(element, words[list ? 4 : 2], list);
  for (const Property& other : element.properties) {
    if (property.use != Use::none && other.use == property.use) {
      throw lines.error("a property is stated twice");
    }
  }
  return property;
}

Format format_of(const LineReader& lines) {
  const auto& words = lines.words();
  if (words.size() == 3 && words[2] == "1.0") {
    if (words[1] == "ascii") return Format::ascii;
    if (words[1] == "binary_little_endian") return Format::little;
    if (words[1] == "binary_big_endian") return Format::big;
  }
  throw lines.error("no format that PLY has");
}

Element element_of(const LineReader& lines) {
  const auto& words = lines.words();
  if (words.size() != 3) throw lines.error("an element has a name and a count");
  constexpr std::int64_t most = std::int64_t{1} << 62;
  const auto count = static_cast<std::uint64_t>(lines.whole(words[2], 0, most));
  if (words[1] == "tristrips" && count > 0) {
    throw lines.error("triangle strips are not read; export triangles");
  }
  return {std::string(words[1]), count, {}};
}

/// Leaves `lines` at the line "end_header".
Header parse_header(LineReader& lines, const std::string& what) {
  Header header;
  bool has_format = false;
  const bool begins = lines.next() && lines.words()[0] == "ply";
  while (begins && lines.next() && lines.line_ends()) {
    const auto& words = lines.words();
    if (words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (!has_format) throw lines.error("the format is missing");
      return header;
    }
    if (words[0] == "format") {
      header.format = format_of(lines);
      has_format = true;
    } else if (words[0] == "element") {
      header.elements.push_back(element_of(lines));
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(lines, header.elements.back()));
    } else {
      throw lines.error("no line of a PLY header begins so");
    }
  }
  throw InvalidInput({.file = what,
                      .text = "no whole PLY header, from 'ply' to 'end_header'; fetch or export "
                              "the file again"});
}

/// Where the body begins, after the line whose first word is `last`, which ends as the first line
/// does: where lines end with "\r", a "\n" that follows is the body's.
std::size_t body_begin(std::string_view bytes, std::string_view last) {
  const std::size_t first = bytes.find_first_of("\r\n");
  const bool returns_alone = bytes[first] == '\r' && !bytes.substr(first).starts_with("\r\n");
  const auto word = static_cast<std::size_t>(last.data() - bytes.data());
  const std::size_t end = bytes.find_first_of("\r\n", word);
  return end + (!returns_alone && bytes.substr(end).starts_with("\r\n") ? 2 : 1);
}

/// The values of the body, one after the other.
class Body {
 public:
  virtual ~Body() = default;
  virtual void begin_item() = 0;
  virtual double value(Scalar type) = 0;
  virtual void skip(Scalar type) = 0;  // a value that need be no number
  virtual InvalidInput error(const std::string& why) const = 0;
  virtual std::uint64_t bytes_left() const = 0;
  virtual std::uint64_t least_bytes(Scalar type) const = 0;
  /// No list of this item is longer.
  virtual std::uint64_t most_values(Scalar type) const = 0;
};

class BinaryBody : public Body {
 public:
  BinaryBody(std::string_view bytes, std::size_t at, bool big, std::string what)
      : bytes_(bytes),
        at_(at),
        swap_(big != (std::endian::native == std::endian::big)),
        what_(std::move(what)) {}

  void begin_item() override {}
  double value(Scalar type) override {
    switch (type) {
      case Scalar::int8:
        return stored<std::int8_t>();
      case Scalar::uint8:
        return stored<std::uint8_t>();
      case Scalar::int16:
        return stored<std::int16_t>();
      case Scalar::uint16:
        return stored<std::uint16_t>();
      case Scalar::int32:
        return stored<std::int32_t>();
      case Scalar::uint32:
        return stored<std::uint32_t>();
      case Scalar::float32:
        return stored<float>();
      case Scalar::float64:
        return stored<double>();
    }
    return 0.0;
  }
  void skip(Scalar type) override { value(type); }
  InvalidInput error(const std::string& why) const override {
    return InvalidInput({.file = what_,
                         .place = "byte " + std::to_string(at_),
                         .text = why + "; fetch or export the file again"});
  }
  std::uint64_t bytes_left() const override { return bytes_.size() - at_; }
  std::uint64_t least_bytes(Scalar type) const override { return bytes_of(type); }
  std::uint64_t most_values(Scalar type) const override { return bytes_left() / bytes_of(type); }

 private:
  template <class T>
  T stored() {
    if (bytes_left() < sizeof(T)) throw error("the file ends too early");
    std::array<char, sizeof(T)> raw{};
    bytes_.copy(raw.data(), sizeof(T), at_);
    at_ += sizeof(T);
    if (swap_) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

  std::string_view bytes_;
  std::size_t at_;
  bool swap_;
  std::string what_;
};

/// One item in each line, as PLY asks for.
class AsciiBody : public Body {
 public:
  explicit AsciiBody(LineReader lines) : lines_(std::move(lines)) {}

  void begin_item() override {
    expect_end_of_line();
    if (!lines_.next()) throw lines_.error("the file ends too early");
    word_ = 0;
  }
  double value(Scalar) override { return lines_.number(word_++); }
  void skip(Scalar) override {
    if (word_++ >= lines_.words().size()) throw lines_.error("a number is missing");
  }
  InvalidInput error(const std::string& why) const override { return lines_.error(why); }
  // The last line may do without its end.
  std::uint64_t bytes_left() const override { return lines_.bytes_left() + 1; }
  std::uint64_t least_bytes(Scalar) const override { return 2; }
  std::uint64_t most_values(Scalar) const override { return lines_.words().size(); }
  void expect_end() {
    expect_end_of_line();
    if (lines_.next()) throw lines_.error("more lines than the header states");
  }
  bool line_ends() const { return lines_.line_ends(); }

 private:
  void expect_end_of_line() const {
    if (word_ != lines_.words().size()) throw lines_.error("more numbers than the header states");
  }

  LineReader lines_;
  std::size_t word_ = lines_.words().size();  // the last line of the header is done with
};

std::int64_t whole(const Body& body, double value, double least, double most) {
  if (value >= least && value <= most && value == std::floor(value)) {
    return static_cast<std::int64_t>(value);
  }
  const std::string range = std::to_string(static_cast<std::int64_t>(least)) + " to " +
                            std::to_string(static_cast<std::int64_t>(most));
  throw body.error("a whole number from " + range + " is expected");
}

/// Throws before anything is allocated if the rest of the file cannot hold the element.
void check_room(const Body& body, const Element& element) {
  std::uint64_t item = 0;
  for (const Property& property : element.properties) {
    item += body.least_bytes(property.count ? *property.count : property.type);
  }
  if (element.count == 0) return;
  if (item == 0) throw body.error("an element without properties");
  if (element.count > body.bytes_left() / item) {
    throw body.error("the rest of the file is too short for what the header states");
  }
}

void read_corners(Body& body, const Property& property, std::size_t points,
                  std::vector<std::uint32_t>& polygon) {
  const double stated = body.value(*property.count);
  const auto most = static_cast<double>(body.most_values(property.type));
  const std::int64_t count = whole(body, stated, 0.0, most);
  polygon.clear();
  for (std::int64_t c = 0; c < count; ++c) {
    if (property.use != Use::corners) {
      body.skip(property.type);
      continue;
    }
    const double last = static_cast<double>(points) - 1.0;
    polygon.push_back(
        static_cast<std::uint32_t>(whole(body, body.value(property.type), 0.0, last)));
  }
}

void check_properties(const Body& body, const Element& element) {
  std::array<bool, 5> has{};
  for (const Property& property : element.properties) {
    has.at(static_cast<std::size_t>(property.use)) = true;
  }
  if (element.name == "vertex" && !(has[1] && has[2] && has[3])) {
    throw body.error("vertices have no x, y and z");
  }
  if (element.name == "face" && !has[4]) throw body.error("faces have no vertex_indices");
}

/// Returns how many faces have fewer than three corners.
std::size_t read_element(Body& body, const Element& element, Mesh& mesh) {
  check_room(body, element);
  check_properties(body, element);
  const bool vertex = element.name == "vertex";
  if (vertex) mesh.points.reserve(mesh.points.size() + element.count);
  std::vector<std::uint32_t> polygon;
  std::size_t too_small = 0;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin_item();
    Vec3 point{};
    for (const Property& property : element.properties) {
      if (property.count) {
        read_corners(body, property, mesh.points.size(), polygon);
        if (property.use != Use::corners) continue;
        append_fan(mesh, polygon);
        too_small += polygon.size() < 3 ? 1 : 0;
      } else if (property.use == Use::none) {
        body.skip(property.type);
      } else {
        const double value = body.value(property.type);
        if (!std::isfinite(value)) throw body.error("a coordinate is not finite");
        point.at(static_cast<std::size_t>(property.use) - 1) = value;
      }
    }
    if (vertex) mesh.points.push_back(point);
  }
  return too_small;
}

Mesh read_elements(Body& body, const Header& header, const std::string& what) {
  Mesh mesh;
  int vertices = 0;
  std::size_t too_small = 0;
  for (const Element& element : header.elements) {
    vertices += element.name == "vertex" ? 1 : 0;
    if (vertices > 1) throw body.error("two lists of vertices");
    if (element.count > static_cast<std::uint64_t>(most_points)) {
      throw body.error("the header states more than isoloop can number");
    }
    too_small += read_element(body, element, mesh);
  }
  if (too_small > 0) mesh.warnings.push_back(small_faces_warning(too_small, what));
  return mesh;
}

/// Whether the last number of the body is a corner to which a digit could be added.
bool ends_within_corner(const Header& header, const Mesh& mesh) {
  const auto last = std::find_if(header.elements.rbegin(), header.elements.rend(),
                                 [](const Element& element) { return element.count > 0; });
  return last != header.elements.rend() && last->properties.back().use == Use::corners &&
         last_corner_could_go_on(mesh);
}

}  // namespace

ParsedMesh parse_ply(std::string_view bytes, const std::string& what) {
  LineReader lines(bytes, what);
  const Header header = parse_header(lines, what);
  if (header.format == Format::ascii) {
    AsciiBody body(std::move(lines));
    ParsedMesh parsed{.mesh = read_elements(body, header, what)};
    body.expect_end();
    if (body.line_ends()) return parsed;
    parsed.mesh.warnings.push_back(unended_warning(what));
    parsed.last_face_may_be_cut = ends_within_corner(header, parsed.mesh);
    return parsed;
  }
  BinaryBody body(bytes, body_begin(bytes, lines.words()[0]), header.format == Format::big, what);
  ParsedMesh parsed{.mesh = read_elements(body, header, what)};
  if (body.bytes_left() > 0) {
    throw body.error("the file is longer than its header states, by " +
                     std::to_string(body.bytes_left()) + " bytes");
  }
  return parsed;
}

}  // namespace isoloop
