// Files for the tests of the readers: packed, cut short, in either byte order.
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/errors.h"
#include "tests/volume_test_files.h"
#include "volume/byte_order.h"

namespace isoloop::test {

/// The bytes of a number in a byte order.
template <class T>
std::string number_bytes(T value, Endian endian) {
  if (endian != native_endian) swap_bytes(std::span(&value, 1));
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

/// Voxels 0 to 11 of 16 bits.
inline std::string dozen_voxels(Endian endian) {
  std::string bytes;
  for (std::int16_t i = 0; i < 12; ++i) bytes += number_bytes(i, endian);
  return bytes;
}

template <class T>
void put(std::string& bytes, std::size_t at, T value, Endian endian) {
  bytes.replace(at, sizeof(T), number_bytes(value, endian));
}

/// As gzip (window_bits 31) or zlib (15) writes them.
inline std::string packed_bytes(const std::string& bytes, int window_bits) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string gzip_bytes(const std::string& bytes) { return packed_bytes(bytes, 31); }
inline std::string zlib_bytes(const std::string& bytes) { return packed_bytes(bytes, 15); }

/// `read` must take the whole file, and refuse each of its beginnings as invalid input.
template <class Read>
void expect_no_beginning_is_read(const std::filesystem::path& path, const std::string& whole,
                                 const Read& read) {
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read(), InvalidInput) << path << " cut to " << length << " of " << whole.size();
  }
  write_bytes(path, whole);
  EXPECT_NO_THROW(read()) << path;
}

}  // namespace isoloop::test
