#include "volume/formats/vti_data.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <zlib.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& complaint) {
  throw InvalidInput({.file = what, .text = complaint + "; fetch the file again"});
}

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Takes stored bytes from the front, decoded.
class Stored {
 public:
  Stored(std::string_view text, bool base64, const std::string& what)
      : text_(text), base64_(base64), what_(what) {}

  /// The next `bytes` bytes; of base64 they are a run of their own, with its padding.
  std::string take(std::uint64_t bytes) {
    std::string taken = peek(bytes);
    text_.remove_prefix(base64_ ? (bytes + 2) / 3 * 4 : bytes);
    return taken;
  }

  /// The next bytes, which stay; of base64 they may be the beginning of a longer run.
  std::string peek(std::uint64_t bytes) const {
    const std::uint64_t letters = base64_ ? (bytes / 3 + (bytes % 3 != 0 ? 1 : 0)) * 4 : bytes;
    if (bytes > text_.size() || letters > text_.size()) {
      refuse(what_, "ends within its voxels: " + std::to_string(text_.size()) + " of " +
                        std::to_string(letters) + " bytes are there");
    }
    return base64_ ? decoded(text_.substr(0, letters), bytes) : std::string(text_.substr(0, bytes));
  }

  /// Nothing may follow but what a run's padding leaves.
  std::string_view rest() const { return text_; }

 private:
  std::string decoded(std::string_view letters, std::uint64_t bytes) const {
    std::string out;
    out.reserve(bytes + 3);
    for (std::size_t i = 0; i < letters.size(); i += 4) {
      std::uint32_t bits = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        const char letter = letters[i + j];
        // Padding stands only where no byte is wanted any more.
        const bool unwanted = out.size() + j > bytes && j > 1;
        const int value = letter == '=' && unwanted ? 0 : base64_value(letter);
        if (value < 0) refuse(what_, "its base64 text is damaged");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
      }
      for (const int shift : {16, 8, 0}) out.push_back(static_cast<char>(bits >> shift & 0xff));
    }
    out.resize(bytes);
    return out;
  }

  std::string_view text_;
  bool base64_;
  const std::string& what_;
};

std::uint64_t size_at(const std::string& bytes, std::size_t i, const VtiEncoding& encoding) {
  const auto view = std::as_bytes(std::span(bytes));
  return encoding.size_bytes == 8 ? load<std::uint64_t>(view, 8 * i, encoding.endian)
                                  : load<std::uint32_t>(view, 4 * i, encoding.endian);
}

std::string plain_bytes(Stored stored, const VtiEncoding& encoding, std::uint64_t wanted,
                        const std::string& what) {
  const std::uint64_t stated = size_at(stored.peek(encoding.size_bytes), 0, encoding);
  if (stated != wanted) {
    refuse(what, "states " + std::to_string(stated) + " bytes of voxels, but they take " +
                     std::to_string(wanted));
  }
  std::string bytes = stored.take(encoding.size_bytes + wanted);
  bytes.erase(0, encoding.size_bytes);
  return bytes;
}

/// [blocks][bytes of a block][bytes of the last, 0: as the others][compressed bytes of each]
std::string unpacked_bytes(Stored stored, const VtiEncoding& encoding, std::uint64_t wanted,
                           const std::string& what) {
  const std::string start = stored.peek(3 * encoding.size_bytes);
  const std::uint64_t blocks = size_at(start, 0, encoding);
  const std::uint64_t block_bytes = size_at(start, 1, encoding);
  const std::uint64_t last = size_at(start, 2, encoding);
  const bool sensible = blocks > 0 && block_bytes > 0 && blocks <= stored.rest().size() &&
                        last <= block_bytes && last <= wanted;
  // Counted so that nothing overflows: the blocks but the last are whole.
  const std::uint64_t whole = sensible && last > 0 ? blocks - 1 : blocks;
  if (!sensible || whole > wanted / block_bytes || whole * block_bytes != wanted - last) {
    refuse(what, "its compressed blocks do not make the " + std::to_string(wanted) +
                     " bytes that its voxels take");
  }
  const std::string header = stored.take((3 + blocks) * encoding.size_bytes);
  std::uint64_t total = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t bytes = size_at(header, 3 + i, encoding);
    if (bytes > stored.rest().size()) refuse(what, "ends within its compressed voxels");
    total += bytes;
    if (total > stored.rest().size()) refuse(what, "ends within its compressed voxels");
  }
  // Deflate makes at most 1032 bytes of one.
  if (wanted / 1032 > total) refuse(what, "its compressed bytes are too few for its voxels");
  const std::string packed = stored.take(total);
  std::string bytes(wanted, '\0');
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t stated = size_at(header, 3 + i, encoding);
    const std::uint64_t expected = i == whole ? last : block_bytes;
    uLongf made = expected;
    uLong used = stated;
    const int status = uncompress2(reinterpret_cast<Bytef*>(bytes.data() + to), &made,
                                   reinterpret_cast<const Bytef*>(packed.data() + from), &used);
    if (status != Z_OK || made != expected || used != stated) {
      refuse(what, "its compressed voxels are damaged");
    }
    from += stated;
    to += expected;
  }
  return bytes;
}

}  // namespace

std::string vti_bytes(std::string_view stored, const VtiEncoding& encoding, std::uint64_t wanted,
                      const std::string& what) {
  const Stored bytes(stored, encoding.base64, what);
  return encoding.packed ? unpacked_bytes(bytes, encoding, wanted, what)
                         : plain_bytes(bytes, encoding, wanted, what);
}

}  // namespace isoloop
