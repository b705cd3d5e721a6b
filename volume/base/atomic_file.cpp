#include "volume/base/atomic_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

namespace fs = std::filesystem;

InvalidInput write_error(const fs::path& target, const std::string& why) {
  return InvalidInput({.file = target.string(), .text = "cannot be written: " + why},
                      Fault::unwritable);
}

std::string text_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void throw_write_error(const fs::path& target, int error) {
  if (!is_out_of_room(error)) throw write_error(target, text_of(error));
  throw LimitExceeded(
      {.file = target.string(),
       .text = "cannot be written: " + text_of(error) + "; make room or choose another place"});
}

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

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// A name beside the target that is probably free.
fs::path hidden_name(const fs::path& target) {
  static thread_local std::random_device random;
  const std::uint64_t number = std::uint64_t{random()} << 32 | random();
  return folder_of(target) / (".isoloop-" + std::to_string(number) + ".tmp");
}

/// Calls `create` with free names until it succeeds; it says so, or sets errno.
template <class Create>
fs::path create_beside(const fs::path& target, const Create& create) {
  constexpr int attempts = 8;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    fs::path path = hidden_name(target);
    if (create(path)) return path;
    if (errno != EEXIST) break;
  }
  throw_write_error(target, errno);
}

bool create_empty(const fs::path& path) {
  std::FILE* const file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) return false;
  std::fclose(file);
  return true;
}

std::string path_of(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

bool link_to(int descriptor, const fs::path& path) {
  return linkat(AT_FDCWD, path_of(descriptor).c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) ==
         0;
}

/// What one more byte at the file's end meets: the stream does not keep the reason it failed for.
int reason_of_failure(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const std::string block(1U << 16, '\0');
  const ssize_t written = write(descriptor, block.data(), block.size());
  const int error = errno;
  close(descriptor);
  return written == static_cast<ssize_t>(block.size()) ? EIO : (written < 0 ? error : ENOSPC);
}

}  // namespace

bool is_out_of_room(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG; }

AtomicFile::AtomicFile(const fs::path& target) : target_(writable_target(target)) {
  constexpr mode_t everybody = 0666;  // less the umask
  descriptor_ = open(folder_of(target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, everybody);
  if (descriptor_ < 0) {
    temporary_ = create_beside(target_, create_empty);
  }
  errno = 0;
  stream_.open(descriptor_ < 0 ? temporary_.string() : path_of(descriptor_), std::ios::binary);
  if (stream_) return;
  const int error = errno;
  discard();
  throw_write_error(target_, error);
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() {
  stream_.close();
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  temporary_.clear();
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) {
    throw_write_error(
        target_, reason_of_failure(descriptor_ < 0 ? temporary_ : fs::path(path_of(descriptor_))));
  }
  if (descriptor_ >= 0) {
    if (link_to(descriptor_, target_)) return;  // there was no such file before
    if (errno != EEXIST) throw_write_error(target_, errno);
    temporary_ =
        create_beside(target_, [&](const fs::path& path) { return link_to(descriptor_, path); });
  }
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw write_error(target_, error.message());
  temporary_.clear();
}

}  // namespace isoloop
