// The formats of files: one table says which extensions each has and what isoloop does with it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/finding.h"

namespace isoloop {

enum class FileKind {
  raw,
  vdb,
  nifti,
  nrrd,
  meta_image,
  dicom,
  tiff,
  png,
  bmp,
  npy,
  vti,
  stl,
  ply,
  obj,
  off
};

/// How volumes are written in a format.
enum class Written { no, as_they_are, as_floats };

/// The frames that a format has names for, where volumes are written in it. `none`: it says nothing
/// of where voxels lie. `any` is all.
enum class WrittenFrame { none, world, lps, ras, any };

struct FileFormat {
  FileKind kind;
  std::string_view name;                         // "NIfTI", for messages
  std::array<std::string_view, 3> extensions{};  // ".nii", ...; the rest empty
  bool is_mesh = false;                          // triangles, which become voxels
  bool is_slice = false;                         // a folder of such files may be one volume
  bool may_be_packed = false;                    // also with ".gz" behind the extension
  bool may_be_patched = false;    // single voxels can be replaced in a copy of the file
  Written written = Written::no;  // under the first extension alone, also packed if it may be
  WrittenFrame written_frame = WrittenFrame::none;
  bool writes_unit = false;  // of lengths, all or some
  std::uint32_t takes = 0;   // options that mean something: takes_option()
};

/// In the order in which messages list them.
std::span<const FileFormat> file_formats();

/// By the extension, whatever its case; null for one that isoloop does not know.
const FileFormat* file_format(const std::filesystem::path& path);
std::optional<FileKind> file_kind(const std::filesystem::path& path);

/// Whether the option means something for files of the format, or for folders of slices.
bool takes_option(const FileFormat& format, Option option);
bool folders_take_option(Option option);

/// ".raw, .vdb, ... or .vti", for messages: of the volumes that isoloop reads.
std::string supported_extensions();

/// ".stl, .ply, .obj and .off", for messages.
std::string mesh_extensions();

/// Whether isoloop writes volumes to files of this name too.
bool is_written(const std::filesystem::path& path);

/// ".raw, .nii, … or .vdb", for messages: those first that keep the type of the voxels.
std::string written_extensions();

/// ".raw", ".nii.gz", in lower case.
std::string extension_of(const std::filesystem::path& path);

}  // namespace isoloop
