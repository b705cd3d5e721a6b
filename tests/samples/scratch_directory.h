// A folder for the files of one test.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isoloop {

/// A directory of its own for one test, removed with all that is in it at the end.
class ScratchDirectory {
 public:
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Names of all files in it, sorted.
  std::vector<std::string> files() const;

  /// Creates a file of these bytes.
  void write(const std::string& name, const std::string& bytes) const;

  /// Bytes of a file; empty if it does not exist.
  std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace isoloop
