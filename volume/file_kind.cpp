#include "volume/file_kind.h"

#include <algorithm>

namespace isoloop {

std::optional<FileKind> file_kind(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (extension == ".raw") return FileKind::raw;
  if (extension == ".vdb") return FileKind::vdb;
  return std::nullopt;
}

std::string supported_extensions() { return ".raw or .vdb"; }

}  // namespace isoloop
