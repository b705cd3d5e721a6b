// What every fuzz target does: read the bytes as one format and expect an answer or an error of
// core/base/errors.h. A target is one file that names the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "core/base/errors.h"
#include "volume/voxels/crop.h"

namespace isoloop::fuzz {

constexpr std::uint64_t most_bytes = std::uint64_t{8} << 20;  // of voxels: more cost time alone

/// A part of any volume of two voxels or more along x and y.
constexpr CropBox part{CropRange{1, {}}, CropRange{0, 2}, CropRange{}};

/// A folder of this process's own, in memory where there is such a place.
class Folder {
 public:
  Folder() : path_(root() / ("isoloop_fuzz_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  static std::filesystem::path root() {
    const std::filesystem::path memory = "/dev/shm";
    return std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  }
  std::filesystem::path path_;
};

inline const std::filesystem::path& own_folder() {
  static const Folder folder;
  return folder.path();
}

/// A folder called `name` without files.
inline std::filesystem::path empty_folder(const std::string& name) {
  const std::filesystem::path folder = own_folder() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  return folder;
}

/// The bytes as a file called `name`, for readers that want a path.
inline std::filesystem::path file_of(std::string_view bytes, const std::string& name) {
  const std::filesystem::path file = own_folder() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

/// Runs `read` on the bytes. Any exception but isoloop's own ends the process: a finding.
template <class Read>
int expect_answer_or_error(const std::uint8_t* data, std::size_t size, const Read& read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const InvalidInput&) {
  } catch (const InvalidArgument&) {
  } catch (const LimitExceeded&) {
  }
  return 0;
}

}  // namespace isoloop::fuzz
