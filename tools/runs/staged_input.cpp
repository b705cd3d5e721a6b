#include "tools/runs/staged_input.h"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <system_error>

#include "core/base/errors.h"
#include "volume/base/file_kind.h"

namespace isoloop {
namespace {

namespace fs = std::filesystem;

bool is_pipe(const std::string& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::is_fifo(status) || fs::is_character_file(status);
}

/// As the bytes are of no known kind without it.
std::string extension_for(const VolumeFlags& flags) {
  if (!flags.type.empty()) return ".raw";
  if (flags.file != "-" && file_format(flags.file) != nullptr) return extension_of(flags.file);
  throw InvalidArgument(flags.file +
                        ": standard input and pipes want --dims and --type, which say that they "
                        "are raw voxels, or a name with the extension of their format");
}

StagedFile new_file(const std::string& extension) {
  std::string folder = (fs::temp_directory_path() / "isoloop-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    throw InvalidInput(
        {.file = folder, .text = "cannot be made: " + std::generic_category().message(errno)},
        Fault::unwritable);
  return {new fs::path(fs::path(folder) / ("input" + extension)), [](const fs::path* file) {
            std::error_code ignored;
            fs::remove_all(file->parent_path(), ignored);
            delete file;
          }};
}

}  // namespace

StagedFile staged_input(const VolumeFlags& flags) {
  if (flags.file != "-" && !is_pipe(flags.file)) return nullptr;
  StagedFile staged = new_file(extension_for(flags));
  std::ofstream copy(*staged, std::ios::binary);
  std::ifstream pipe;
  if (flags.file != "-") pipe.open(flags.file, std::ios::binary);
  std::istream& from = flags.file == "-" ? std::cin : pipe;
  if (from.peek() != std::istream::traits_type::eof()) copy << from.rdbuf();
  copy.close();
  if (!copy)
    throw LimitExceeded({.file = flags.file,
                         .text = "cannot be copied to " + staged->parent_path().string() +
                                 ": no room; make room or set TMPDIR"});
  return staged;
}

}  // namespace isoloop
