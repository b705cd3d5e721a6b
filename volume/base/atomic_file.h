// Output files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <iosfwd>

namespace isoloop {

/// A file that is written without a name and put in the place of its target at the end. Invariant:
/// until commit() succeeds the target is what it was before; without a commit nothing is left
/// behind, whatever ends the process. (On file systems without files that have no name, it has a
/// hidden one beside the target, which SIGINT leaves.)
class AtomicFile {
 public:
  /// Opens a file in the target's folder. Throws InvalidInput, naming the target, if that fails or
  /// if the target is a folder, device or pipe, LimitExceeded if the disk is full.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Binary. Errors need no check while writing: commit() sees them.
  std::ostream& stream() { return stream_; }

  /// Puts the file in place. Call once, last. Throws, naming the target, if any write or the rename
  /// failed: LimitExceeded if the disk or a quota is full, else InvalidInput.
  void commit();

 private:
  void discard();

  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty: the file has no name
  int descriptor_ = -1;              // of a file without a name
  std::ofstream stream_;
};

/// Whether errno's value `error` says that there is no room for more bytes.
bool is_out_of_room(int error);

}  // namespace isoloop
