#include "volume/base/byte_stream.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <vector>

#include <zlib.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 16;

}  // namespace

struct ByteStream::State {
  std::filesystem::path path;
  Packing packing = Packing::plain;
  std::uint64_t first = 0;     // byte of the file
  std::uint64_t position = 0;  // bytes given out
  std::ifstream file;
  std::uint64_t stored_left = 0;  // bytes of the file not yet read from it
  z_stream inflater{};
  bool inflating = false;  // inflater is initialised
  bool ended = false;      // the compressed stream's end was there, with its checksum
  std::vector<std::byte> stored;

  [[noreturn]] void fail(const std::string& complaint, Fault fault = Fault::damaged) const {
    throw InvalidInput({.file = path.string(), .text = complaint}, fault);
  }

  // As many bytes as are left, at most; throws if the file system does not deliver them.
  std::size_t read_stored(std::byte* to, std::size_t most) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(most, stored_left));
    if (wanted == 0) return 0;
    if (!file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(wanted))) {
      fail("reading stopped before the file's end; fetch the file again");
    }
    stored_left -= wanted;
    return wanted;
  }

  bool refill() {
    if (inflater.avail_in > 0) return true;
    inflater.next_in = reinterpret_cast<Bytef*>(stored.data());
    inflater.avail_in = static_cast<uInt>(read_stored(stored.data(), stored.size()));
    return inflater.avail_in > 0;
  }

  // Gzip files may be put one after the other.
  bool begin_next_member() {
    constexpr Bytef gzip_magic = 0x1f;
    if (packing != Packing::gzip || !refill()) return false;
    if (*inflater.next_in != gzip_magic || inflateReset(&inflater) != Z_OK) {
      fail("other bytes follow the end of its compressed ones; fetch the file again");
    }
    ended = false;
    return true;
  }

  // As many bytes as there are, at most.
  std::size_t inflate_some(std::byte* to, std::size_t most) {
    inflater.next_out = reinterpret_cast<Bytef*>(to);
    inflater.avail_out =
        static_cast<uInt>(std::min<std::size_t>(most, std::numeric_limits<std::int32_t>::max()));
    const uInt wanted = inflater.avail_out;
    while (inflater.avail_out > 0) {
      if (ended && !begin_next_member()) break;
      if (!refill()) break;
      const int status = inflate(&inflater, Z_NO_FLUSH);
      if (status == Z_STREAM_END) {
        ended = true;
      } else if (status != Z_OK) {
        const std::string why = inflater.msg != nullptr ? inflater.msg : "no valid stream";
        fail("its compressed bytes are damaged (" + why + "); fetch the file again");
      }
    }
    return wanted - inflater.avail_out;
  }

  std::size_t read_some(std::byte* to, std::size_t most) {
    const std::size_t got =
        packing == Packing::plain ? read_stored(to, most) : inflate_some(to, most);
    position += got;
    return got;
  }
};

ByteStream::ByteStream(const std::filesystem::path& path, Packing packing, std::uint64_t first)
    : state_(std::make_unique<State>()) {
  check_is_file(path);
  state_->path = path;
  state_->packing = packing;
  state_->first = first;
  const std::uint64_t size = stored_bytes(path);
  if (first > size) {
    state_->fail("has " + std::to_string(size) + " bytes, and its data should begin after " +
                 std::to_string(first) + "; fetch the file again");
  }
  state_->stored_left = size - first;
  state_->file.open(path, std::ios::binary);
  if (!state_->file.seekg(static_cast<std::streamoff>(first))) {
    state_->fail("cannot be opened; check that you may read it", Fault::unreadable);
  }
  if (packing == Packing::plain) return;
  constexpr int largest_window = 15;
  constexpr int gzip_only = 16;
  constexpr int gzip_or_zlib = 32;
  state_->stored.resize(chunk_bytes);
  const int format = packing == Packing::gzip ? gzip_only : gzip_or_zlib;
  if (inflateInit2(&state_->inflater, largest_window + format) != Z_OK) throw std::bad_alloc();
  state_->inflating = true;
}

ByteStream::~ByteStream() {
  if (state_->inflating) inflateEnd(&state_->inflater);
}

void ByteStream::read(std::span<std::byte> to, const std::string& what) {
  std::size_t done = 0;
  while (done < to.size()) {
    const std::size_t got = state_->read_some(to.data() + done, to.size() - done);
    if (got == 0) {
      state_->fail("ends within " + what + ", after " + std::to_string(done) + " of " +
                   std::to_string(to.size()) + " bytes; fetch the file again");
    }
    done += got;
  }
}

void ByteStream::skip(std::uint64_t bytes, const std::string& what) {
  check_room(bytes, what);
  if (state_->packing == Packing::plain && bytes > chunk_bytes) {
    if (!state_->file.seekg(static_cast<std::streamoff>(bytes), std::ios::cur)) {
      state_->fail("reading stopped before the file's end; fetch the file again");
    }
    state_->stored_left -= bytes;
    state_->position += bytes;
    return;
  }
  std::array<std::byte, 4096> dropped{};
  while (bytes > 0) {
    const auto now = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, dropped.size()));
    read(std::span(dropped).first(now), what);
    bytes -= now;
  }
}

std::uint64_t ByteStream::skip_rest(const std::string& what) {
  constexpr std::uint64_t most = std::uint64_t{1} << 24;
  std::array<std::byte, 4096> dropped{};
  std::uint64_t bytes = 0;
  while (bytes < most) {
    const std::size_t got = state_->read_some(dropped.data(), dropped.size());
    if (got == 0) break;
    bytes += got;
  }
  expect_end(what);
  return bytes;
}

void ByteStream::expect_end(const std::string& what) {
  std::byte next{};
  if (state_->read_some(&next, 1) != 0) {
    state_->fail("holds more bytes than " + what + (what.ends_with('s') ? " take" : " takes") +
                 "; its header and its data do not fit");
  }
  if (state_->packing == Packing::plain) return;
  if (!state_->ended) {
    state_->fail("the end of its compressed bytes is missing; fetch the file again");
  }
  if (state_->inflater.avail_in > 0 || state_->stored_left > 0) {
    state_->fail("other bytes follow the end of its compressed ones; fetch the file again");
  }
}

std::uint64_t ByteStream::position() const { return state_->position; }

const std::filesystem::path& ByteStream::path() const { return state_->path; }

Packing ByteStream::packing() const { return state_->packing; }

std::uint64_t ByteStream::first() const { return state_->first; }

std::uint64_t ByteStream::most_left() const {
  if (state_->packing == Packing::plain) return state_->stored_left;
  constexpr std::uint64_t most_expansion = 1032;
  constexpr std::uint64_t pending = std::uint64_t{1} << 16;  // within zlib, generously
  const std::uint64_t left = state_->stored_left + state_->inflater.avail_in;
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return left > (most - pending) / most_expansion ? most : left * most_expansion + pending;
}

void ByteStream::check_room(std::uint64_t bytes, const std::string& what) const {
  const std::uint64_t most = most_left();
  if (bytes <= most) return;
  const bool plain = state_->packing == Packing::plain;
  state_->fail(what + (what.ends_with('s') ? " take " : " takes ") + std::to_string(bytes) +
               " bytes, but " + (plain ? "" : "no more than ") + std::to_string(most) +
               (plain ? " are there" : " can be compressed there") +
               "; fetch the file again or check its header");
}

std::uint64_t stored_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error)
    throw InvalidInput({.file = path.string(), .text = "cannot be read: " + error.message()},
                       Fault::unreadable);
  return size;
}

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InvalidInput({.file = path.string(), .text = "no such file; check the path"},
                       Fault::unreadable);
  }
  if (error)
    throw InvalidInput({.file = path.string(), .text = "cannot be read: " + error.message()},
                       Fault::unreadable);
  if (std::filesystem::is_directory(status)) {
    throw InvalidInput({.file = path.string(), .text = "is a folder, not a file"},
                       Fault::unreadable);
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InvalidInput(
        {.file = path.string(), .text = "is not a regular file; copy its content to one"},
        Fault::unreadable);
  }
}

}  // namespace isoloop
