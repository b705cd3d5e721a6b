#include "volume/atomic_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include "core/errors.h"

namespace isoloop {
namespace {

namespace fs = std::filesystem;

InvalidInput write_error(const fs::path& target, const std::string& why) {
  return InvalidInput(target.string() + ": cannot be written: " + why);
}

std::string errno_text() { return std::generic_category().message(errno); }

/// The file that the target's name leads to. A rename onto a device or a pipe would destroy it.
fs::path writable_target(const fs::path& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) throw write_error(target, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw write_error(target, "it is not a regular file");
  }
  const fs::path followed = fs::is_symlink(fs::symlink_status(target, ignored))
                                ? fs::weakly_canonical(target, ignored)
                                : target;
  return followed.empty() ? target : followed;
}

/// Creates an empty file that did not exist before.
fs::path create_beside(const fs::path& target) {
  constexpr int attempts = 8;
  std::random_device random;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::uint64_t number = std::uint64_t{random()} << 32 | random();
    fs::path path = target.parent_path() / (".isoloop-" + std::to_string(number) + ".tmp");
    if (std::FILE* file = std::fopen(path.c_str(), "wbx")) {
      std::fclose(file);
      return path;
    }
    if (errno != EEXIST) break;
  }
  throw write_error(target, errno_text());
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target)
    : target_(writable_target(target)), temporary_(create_beside(target_)) {
  stream_.open(temporary_, std::ios::binary);
  if (stream_) return;
  const std::string why = errno_text();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  throw write_error(target, why);
}

AtomicFile::~AtomicFile() {
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) {
    throw write_error(target_, errno == 0 ? "a write failed; is the disk full?" : errno_text());
  }
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw write_error(target_, error.message());
  temporary_.clear();
}

}  // namespace isoloop
