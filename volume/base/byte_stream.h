// A file's bytes in order, each one accounted for, before and after decompression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace isoloop {

/// How bytes are stored in a file. zlib: either of zlib's own formats, or gzip.
enum class Packing { plain, gzip, zlib };

/// Reads on from a byte of a file. Several gzip members in a row are one stream. A stream is never
/// taken as complete unless its checksum was there and right.
class ByteStream {
 public:
  /// From byte `first` (not above the file's size) to the file's end. Throws InvalidInput if the
  /// file cannot be read.
  ByteStream(const std::filesystem::path& path, Packing packing, std::uint64_t first = 0);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// Fills `to`. Throws InvalidInput, saying how much of `what` is there, if the file ends before,
  /// and if compressed bytes are damaged.
  void read(std::span<std::byte> to, const std::string& what);

  /// Reads `bytes` bytes and drops them. Throws as read() does.
  void skip(std::uint64_t bytes, const std::string& what);

  /// Reads to the end, and returns how many bytes that were. Throws InvalidInput as expect_end()
  /// does, and if there are more than 16 MiB.
  std::uint64_t skip_rest(const std::string& what);

  /// Throws InvalidInput if anything follows, or if the end of compressed bytes is missing.
  void expect_end(const std::string& what);

  /// Bytes read and dropped so far.
  std::uint64_t position() const;

  /// What the stream was made from.
  const std::filesystem::path& path() const;
  Packing packing() const;
  std::uint64_t first() const;

  /// No more bytes than this are to come: exact where they are plain, else what the stored bytes
  /// can expand to at most (deflate: a factor of 1032).
  std::uint64_t most_left() const;

  /// Throws InvalidInput if `bytes` are more than can be to come: before memory is asked for.
  void check_room(std::uint64_t bytes, const std::string& what) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws InvalidInput, naming the file, if its size cannot be told.
std::uint64_t stored_bytes(const std::filesystem::path& path);

/// Throws InvalidInput, naming the file, unless it is a regular file.
void check_is_file(const std::filesystem::path& path);

}  // namespace isoloop
