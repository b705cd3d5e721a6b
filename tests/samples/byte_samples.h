// Bytes of sample files: numbers in either byte order, voxels, packed as gzip and zlib do.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

#include <zlib.h>

#include "volume/base/byte_order.h"

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
  if (deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib does not begin");
  }
  std::string packed(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int result = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("zlib does not end");
  return packed;
}

inline std::string gzip_bytes(const std::string& bytes) { return packed_bytes(bytes, 31); }
inline std::string zlib_bytes(const std::string& bytes) { return packed_bytes(bytes, 15); }

}  // namespace isoloop::test
