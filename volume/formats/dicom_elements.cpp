#include "volume/formats/dicom_elements.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "core/base/errors.h"
#include "volume/base/byte_stream.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"

namespace isoloop {
namespace {

constexpr std::uint32_t undefined_length = 0xffffffffU;
constexpr DicomTag item_tag = 0xfffee000U;
constexpr DicomTag item_end_tag = 0xfffee00dU;
constexpr DicomTag sequence_end_tag = 0xfffee0ddU;
constexpr DicomTag syntax_tag = 0x00020010U;
constexpr DicomTag pixels_tag = 0x7fe00010U;
constexpr std::uint32_t longest_value = 65536;  // that is kept
constexpr int deepest = 32;

struct Header {
  DicomTag tag = 0;
  std::array<char, 2> kind{};  // value representation; zero where it is implicit
  std::uint32_t length = 0;
};

/// How a file begins: with the 132 bytes of DICOM files, with the last four of them, with the group
/// 2 that follows, or with a data set by itself, which has explicit or implicit types.
enum class DicomStart { unknown, preamble, magic, first_group, explicit_data, implicit_data };

constexpr std::size_t preamble_bytes = 132;
constexpr std::string_view magic = "DICM";
constexpr const char* implicit_little = "1.2.840.10008.1.2";
constexpr const char* explicit_little = "1.2.840.10008.1.2.1";

bool is_tag_of_group_8(std::span<const std::byte> bytes, std::size_t at) {
  return load<std::uint16_t>(bytes, at, Endian::little) == 8;
}

/// Of a data set without what DICOM files begin with: two elements of group 8 in ascending order,
/// the first of them short, so that other files are not taken for one.
DicomStart start_of_data_set(std::span<const std::byte> bytes) {
  if (bytes.size() < 8 || !is_tag_of_group_8(bytes, 0)) return DicomStart::unknown;
  const auto is_letter = [&](std::size_t at) {
    const char letter = std::to_integer<char>(bytes[at]);
    return letter >= 'A' && letter <= 'Z';
  };
  const bool with_types = is_letter(4) && is_letter(5);
  const std::uint64_t length = with_types ? load<std::uint16_t>(bytes, 6, Endian::little)
                                          : load<std::uint32_t>(bytes, 4, Endian::little);
  const std::uint64_t next = 8 + length;
  if (length % 2 != 0 || next + 4 > bytes.size() || !is_tag_of_group_8(bytes, next)) {
    return DicomStart::unknown;
  }
  const auto first_element = load<std::uint16_t>(bytes, 2, Endian::little);
  if (load<std::uint16_t>(bytes, next + 2, Endian::little) <= first_element) {
    return DicomStart::unknown;
  }
  return with_types ? DicomStart::explicit_data : DicomStart::implicit_data;
}

DicomStart start_of(const std::filesystem::path& path) {
  ByteStream stream(path, Packing::plain);
  std::array<std::byte, 256> bytes{};
  const std::span<std::byte> start =
      std::span(bytes).first(std::min<std::uint64_t>(bytes.size(), stream.most_left()));
  stream.read(start, "its first bytes");
  const auto has = [&](std::string_view text, std::size_t at) {
    return start.size() >= at + text.size() &&
           std::equal(text.begin(), text.end(), start.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
  };
  // The length of group 2, of type UL and 4 bytes long.
  constexpr std::string_view length_of_first_group("\2\0\0\0UL\4\0", 8);
  if (has(magic, preamble_bytes - magic.size())) return DicomStart::preamble;
  if (has(magic, 0) && has(length_of_first_group, magic.size())) return DicomStart::magic;
  if (has(length_of_first_group, 0)) return DicomStart::first_group;
  return start_of_data_set(start);
}

class Walker {
 public:
  Walker(const std::filesystem::path& path, DicomElements& found)
      : stream_(path, Packing::plain),
        size_(stream_.most_left()),
        what_(path.string()),
        found_(found) {}

  void walk(DicomStart start) {
    if (start == DicomStart::unknown) refuse("is no DICOM file, or is cut short");
    if (start != DicomStart::explicit_data && start != DicomStart::implicit_data) {
      if (start == DicomStart::preamble) stream_.skip(preamble_bytes, "its first 132 bytes");
      if (start == DicomStart::magic) stream_.skip(magic.size(), "its first 4 bytes");
      first_group();
      start_data_set();
    } else {
      found_.transfer_syntax =
          start == DicomStart::implicit_data ? implicit_little : explicit_little;
      explicit_ = start == DicomStart::explicit_data;
    }
    while (stream_.most_left() > 0) top_level_element();
  }

 private:
  [[noreturn]] void refuse(const std::string& complaint, Fault fault = Fault::damaged,
                           std::vector<Advice> advice = {}) const {
    isoloop::refuse(what_, complaint, fault, std::move(advice));
  }

  std::uint64_t position() const { return size_ - stream_.most_left(); }

  template <class T>
  T number() {
    std::array<std::byte, sizeof(T)> bytes{};
    stream_.read(bytes, "an element");
    return load<T>(bytes, 0, endian_);
  }

  DicomTag tag() {
    const auto group = number<std::uint16_t>();
    return DicomTag{group} << 16 | number<std::uint16_t>();
  }

  Header header() { return header_after(tag()); }

  Header header_after(DicomTag tag) {
    Header header{.tag = tag};
    const bool delimiter = header.tag >> 16 == item_tag >> 16;
    if (!explicit_ || delimiter) {
      header.length = number<std::uint32_t>();
      return header;
    }
    std::array<std::byte, 2> kind{};
    stream_.read(kind, "an element");
    header.kind = {static_cast<char>(kind[0]), static_cast<char>(kind[1])};
    for (const char letter : header.kind) {
      if (letter < 'A' || letter > 'Z') refuse("an element has no type; fetch the file again");
    }
    constexpr std::array<std::string_view, 13> wide{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                    "SV", "UC", "UN", "UR", "UT", "UV"};
    const std::string_view name(header.kind.data(), 2);
    for (const std::string_view one : wide) {
      if (name != one) continue;
      number<std::uint16_t>();  // reserved
      header.length = number<std::uint32_t>();
      return header;
    }
    header.length = number<std::uint16_t>();
    return header;
  }

  void top_level_element() {
    const DicomTag first = tag();
    if (first == 0 && found_.pixel_bytes > 0) return padding();
    const Header element = header_after(first);
    if (element.tag == pixels_tag) {
      pixels(element);
    } else if (element.length == undefined_length) {
      sequence(element, 0);
    } else if (element.length <= longest_value && element.tag >> 16 < 0x7fe0U) {
      found_.values.insert_or_assign(element.tag, value_of(element));
    } else {
      stream_.skip(element.length, "an element");
    }
  }

  std::string value_of(const Header& element) {
    stream_.check_room(element.length, "an element");
    std::string value(element.length, '\0');
    stream_.read(std::as_writable_bytes(std::span(value)), "an element");
    return value;
  }

  // The file's own group 2 says how the rest is written. It is always little-endian and explicit.
  void first_group() {
    const Header first = header();
    const std::string damage = "its first group is damaged; fetch the file again";
    if (first.tag != 0x00020000U || first.length != 4) refuse(damage);
    const auto bytes = number<std::uint32_t>();
    const std::uint64_t end = position() + bytes;
    while (position() < end) {
      const Header element = header();
      if (element.tag >> 16 != 2 || element.length > longest_value ||
          position() + element.length > end) {
        refuse(damage);
      }
      found_.values.insert_or_assign(element.tag, value_of(element));
    }
  }

  void start_data_set() {
    found_.transfer_syntax = text_of(found_, syntax_tag);
    if (found_.transfer_syntax.empty()) refuse("does not state its transfer syntax");
    if (found_.transfer_syntax == "1.2.840.10008.1.2.1.99") {
      refuse("is deflated as a whole", Fault::unsupported, {Advice::unpack_slices});
    }
    explicit_ = found_.transfer_syntax != implicit_little;
    endian_ = found_.transfer_syntax == "1.2.840.10008.1.2.2" ? Endian::big : Endian::little;
    found_.endian = endian_;
  }

  // Some programs fill the file up with zeros.
  void padding() {
    std::array<std::byte, 4096> bytes{};
    while (stream_.most_left() > 0) {
      const auto now =
          static_cast<std::size_t>(std::min<std::uint64_t>(stream_.most_left(), bytes.size()));
      const std::span<std::byte> part = std::span(bytes).first(now);
      stream_.read(part, "its padding");
      const auto zero = [](std::byte byte) { return byte == std::byte{0}; };
      if (!std::all_of(part.begin(), part.end(), zero)) refuse("other bytes follow its pixels");
    }
  }

  void pixels(const Header& element) {
    if (found_.pixel_bytes > 0) refuse("holds pixels twice");
    found_.pixels_from = position();
    if (element.length == undefined_length) {
      found_.packed_pixels = true;
      fragments();
      found_.pixel_bytes = position() - found_.pixels_from;
      return;
    }
    found_.pixel_bytes = element.length;
    stream_.skip(element.length, "its pixels");
  }

  void fragments() {
    while (true) {
      const Header item = header();
      if (item.tag == sequence_end_tag) return;
      if (item.tag != item_tag || item.length == undefined_length) {
        refuse("its compressed pixels are damaged; fetch the file again");
      }
      stream_.skip(item.length, "its pixels");
    }
  }

  // Items up to the delimiter. Of unknown type their elements state none either (PS3.5, 6.2.2).
  void sequence(const Header& opened, int depth) {
    if (depth > deepest) refuse("its sequences nest too deep");
    const bool was_explicit = explicit_;
    if (opened.kind == std::array<char, 2>{'U', 'N'}) explicit_ = false;
    for (Header item = header(); item.tag != sequence_end_tag; item = header()) {
      if (item.tag != item_tag) refuse("a sequence of it is damaged; fetch the file again");
      if (item.length == undefined_length) {
        item_elements(depth);
      } else {
        stream_.skip(item.length, "a sequence");
      }
    }
    explicit_ = was_explicit;
  }

  void item_elements(int depth) {
    for (Header element = header(); element.tag != item_end_tag; element = header()) {
      if (element.length == undefined_length) {
        sequence(element, depth + 1);
      } else {
        stream_.skip(element.length, "a sequence");
      }
    }
  }

  ByteStream stream_;
  std::uint64_t size_;
  std::string what_;
  DicomElements& found_;
  Endian endian_ = Endian::little;
  bool explicit_ = true;
};

}  // namespace

DicomElements read_dicom_elements(const std::filesystem::path& path) {
  DicomElements found;
  Walker(path, found).walk(start_of(path));
  return found;
}

bool looks_like_dicom(const std::filesystem::path& path) {
  return start_of(path) != DicomStart::unknown;
}

std::string text_of(const DicomElements& elements, DicomTag tag) {
  const auto found = elements.values.find(tag);
  if (found == elements.values.end()) return {};
  std::string text = found->second;
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return std::string(trimmed(text));
}

std::optional<std::vector<double>> decimals_of(const DicomElements& elements, DicomTag tag,
                                               const std::string& what) {
  std::string text = text_of(elements, tag);
  if (text.empty()) return std::nullopt;
  for (char& c : text) c = c == '\\' ? ' ' : c;
  return numbers_of(text, 0, what);
}

std::optional<std::int64_t> whole_of(const DicomElements& elements, DicomTag tag,
                                     const std::string& what) {
  const auto found = elements.values.find(tag);
  if (found == elements.values.end()) return std::nullopt;
  if (found->second.size() != 2)
    throw InvalidInput({.file = what, .text = "a number of its header is damaged"});
  return load<std::uint16_t>(std::as_bytes(std::span(found->second)), 0, elements.endian);
}

}  // namespace isoloop
