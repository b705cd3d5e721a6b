#include "volume/files/patch.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <vector>

#include "volume/base/byte_order.h"
#include "volume/base/byte_sink.h"
#include "volume/base/byte_stream.h"

namespace isoloop {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;  // whole voxels of any type

/// Copies the next bytes of a stream, after `change(bytes, place of the first)`.
template <class Change>
void copy(ByteStream& from, std::uint64_t bytes, ByteSink& to, const Change& change) {
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
                 std::span<const std::size_t> voxels, ByteStream& from, ByteSink& to) {
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
    ByteSink plain(out, false);
    copy(before, at.first, plain, no_change);
  }
  ByteStream from(at.file, at.packed ? Packing::gzip : Packing::plain, at.first);
  ByteSink to(out, at.packed);
  copy(from, at.offset, to, no_change);
  std::visit([&](const auto& values) { copy_voxels(values, at, voxels, from, to); }, volume.values);
  copy(from, at.size - from.position(), to, no_change);
  from.expect_end("what it held before");
  to.finish();
}

}  // namespace isoloop
