// How .vti files hold the bytes of an array: base64 or raw, plain or in compressed blocks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "volume/base/byte_order.h"

namespace isoloop {

struct VtiEncoding {
  Endian endian = Endian::little;
  std::uint64_t size_bytes = 4;  // of the numbers that state sizes: 4 or 8
  bool base64 = false;
  bool packed = false;  // zlib
};

/// The `wanted` bytes that `stored` begins with. Throws InvalidInput, opening with `what`, if they
/// are not there, if the sizes stated are others, or if compressed bytes are damaged; before memory
/// is asked for.
std::string vti_bytes(std::string_view stored, const VtiEncoding& encoding, std::uint64_t wanted,
                      const std::string& what);

}  // namespace isoloop
