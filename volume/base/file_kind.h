// Which format a file's name stands for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace isoloop {

enum class FileKind { raw, vdb, nifti, nrrd, meta_image, dicom, tiff, png, bmp, npy, vti };

/// By the extension, whatever its case. Nothing for one that isoloop does not know.
std::optional<FileKind> file_kind(const std::filesystem::path& path);

/// ".raw, .vdb, ... or .nii", for messages: of the files that isoloop reads.
std::string supported_extensions();

/// Whether isoloop writes volumes to files of this name too: .raw, .nrrd and .vdb.
bool is_written(const std::filesystem::path& path);

/// ".raw, .nrrd or .vdb", for messages.
std::string written_extensions();

}  // namespace isoloop
