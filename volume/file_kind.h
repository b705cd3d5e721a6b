// Which format a file's name stands for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace isoloop {

enum class FileKind { raw, vdb };

/// By the extension, whatever its case. Nothing for one that isoloop does not know.
std::optional<FileKind> file_kind(const std::filesystem::path& path);

/// ".raw or .vdb", for messages.
std::string supported_extensions();

}  // namespace isoloop
