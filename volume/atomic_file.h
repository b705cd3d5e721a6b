// Output files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <iosfwd>

namespace isoloop {

/// A file written beside its target and renamed to it. Invariant: until commit() succeeds the
/// target is what it was before; without a commit nothing is left behind.
class AtomicFile {
 public:
  /// Opens a temporary file in the target's folder. Throws InvalidInput, naming the target, if
  /// that fails or if the target is a folder, device or pipe.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Binary. Errors need no check while writing: commit() sees them.
  std::ostream& stream() { return stream_; }

  /// Puts the file in place. Call once, last. Throws InvalidInput, naming the target, if any
  /// write or the rename failed.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

}  // namespace isoloop
