// Bytes on their way to a file, packed or as they are.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <span>

namespace isoloop {

/// Passes bytes on to a stream, whose state shows a failure.
class ByteSink {
 public:
  /// `packed`: by gzip. `out` must outlive the object. Throws std::bad_alloc.
  ByteSink(std::ostream& out, bool packed);
  ~ByteSink();
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  void write(std::span<const std::byte> bytes);

  /// Must be called once, after the last byte.
  void finish();

 private:
  struct Deflater;

  void put(std::span<const std::byte> bytes);
  void deflate_all(std::span<const std::byte> bytes, int flush);

  std::ostream& out_;
  std::unique_ptr<Deflater> deflater_;  // null: as they are
};

}  // namespace isoloop
