#include "volume/base/byte_sink.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <ostream>

#include <zlib.h>

namespace isoloop {

struct ByteSink::Deflater {
  z_stream stream{};

  Deflater() {
    constexpr int largest_window = 15;
    constexpr int gzip = 16;
    constexpr int memory_level = 8;
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, largest_window + gzip,
                     memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflater() { deflateEnd(&stream); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
};

ByteSink::ByteSink(std::ostream& out, bool packed)
    : out_(out), deflater_(packed ? std::make_unique<Deflater>() : nullptr) {}

ByteSink::~ByteSink() = default;

void ByteSink::write(std::span<const std::byte> bytes) {
  if (!deflater_) return put(bytes);
  constexpr std::size_t most = std::numeric_limits<uInt>::max();
  while (!bytes.empty()) {
    const std::size_t piece = std::min(bytes.size(), most);
    deflate_all(bytes.first(piece), Z_NO_FLUSH);
    bytes = bytes.subspan(piece);
  }
}

void ByteSink::finish() {
  if (deflater_) deflate_all({}, Z_FINISH);
}

void ByteSink::put(std::span<const std::byte> bytes) {
  out_.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

void ByteSink::deflate_all(std::span<const std::byte> bytes, int flush) {
  std::array<std::byte, 1 << 16> packed{};
  z_stream& stream = deflater_->stream;
  // zlib reads through a pointer that is not const.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  do {
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, flush);
    put(std::span(packed).first(packed.size() - stream.avail_out));
  } while (stream.avail_out == 0);
}

}  // namespace isoloop
