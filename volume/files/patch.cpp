#include "volume/files/patch.h"

#include <algorithm>
#include <array>
#include <new>
#include <ostream>
#include <vector>

#include <zlib.h>

#include "volume/base/byte_order.h"
#include "volume/base/byte_stream.h"

namespace isoloop {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;  // whole voxels of any type

/// Passes bytes on to a stream, packed or as they are.
class Sink {
 public:
  Sink(std::ostream& out, bool packed) : out_(out), packed_(packed) {
    constexpr int largest_window = 15;
    constexpr int gzip = 16;
    constexpr int memory_level = 8;
    if (packed && deflateInit2(&deflater_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, largest_window + gzip,
                               memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Sink() {
    if (packed_) deflateEnd(&deflater_);
  }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  void write(std::span<std::byte> bytes) {
    if (packed_)
      deflate_all(bytes, Z_NO_FLUSH);
    else
      put(bytes);
  }

  void finish() {
    if (packed_) deflate_all({}, Z_FINISH);
  }

 private:
  void put(std::span<const std::byte> bytes) {
    out_.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }

  void deflate_all(std::span<std::byte> bytes, int flush) {
    std::array<std::byte, 1 << 16> packed{};
    deflater_.next_in = reinterpret_cast<Bytef*>(bytes.data());
    deflater_.avail_in = static_cast<uInt>(bytes.size());
    do {
      deflater_.next_out = reinterpret_cast<Bytef*>(packed.data());
      deflater_.avail_out = static_cast<uInt>(packed.size());
      deflate(&deflater_, flush);
      put(std::span(packed).first(packed.size() - deflater_.avail_out));
    } while (deflater_.avail_out == 0);
  }

  std::ostream& out_;
  bool packed_;
  z_stream deflater_{};
};

/// Copies the next bytes of a stream, after `change(bytes, place of the first)`.
template <class Change>
void copy(ByteStream& from, std::uint64_t bytes, Sink& to, const Change& change) {
  std::vector<std::byte> piece(std::min<std::uint64_t>(bytes, piece_bytes));
  for (std::uint64_t done = 0; done < bytes; done += piece.size()) {
    piece.resize(std::min<std::uint64_t>(piece.size(), bytes - done));
    from.read(piece, "what it held before");
    change(std::span(piece), done);
    to.write(piece);
  }
}

void no_change(std::span<std::byte>, std::uint64_t) {}

/// Copies all voxels of the volume, those in `voxels` with their values in memory.
template <class T>
void copy_voxels(const std::vector<T>& values, const StoredAt& at,
                 std::span<const std::size_t> voxels, ByteStream& from, Sink& to) {
  auto next = voxels.begin();
  copy(from, values.size() * sizeof(T), to, [&](std::span<std::byte> piece, std::uint64_t begin) {
    for (; next != voxels.end() && *next * sizeof(T) < begin + piece.size(); ++next) {
      std::array<T, 1> value{values[*next]};
      if (at.swapped) swap_bytes(std::span<T>(value));
      const auto bytes = std::as_bytes(std::span(value));
      std::copy(bytes.begin(), bytes.end(),
                piece.begin() + static_cast<std::ptrdiff_t>(*next * sizeof(T) - begin));
    }
  });
}

}  // namespace

void write_patched(const Volume& volume, std::span<const std::size_t> voxels, std::ostream& out) {
  const StoredAt& at = volume.stored_at.value();
  {
    ByteStream before(at.file, Packing::plain);
    Sink plain(out, false);
    copy(before, at.first, plain, no_change);
  }
  ByteStream from(at.file, at.packed ? Packing::gzip : Packing::plain, at.first);
  Sink to(out, at.packed);
  copy(from, at.offset, to, no_change);
  std::visit([&](const auto& values) { copy_voxels(values, at, voxels, from, to); }, volume.values);
  copy(from, at.size - from.position(), to, no_change);
  from.expect_end("what it held before");
  to.finish();
}

}  // namespace isoloop
