#include "volume/base/file_kind.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

constexpr std::uint32_t all_of(std::initializer_list<Option> options) {
  std::uint32_t bits = 0;
  for (const Option option : options) bits |= std::uint32_t{1} << static_cast<unsigned>(option);
  return bits;
}

constexpr std::uint32_t any_volume = all_of({Option::labels, Option::crop, Option::nan_value});
constexpr std::uint32_t spaced = any_volume | all_of({Option::spacing});
constexpr std::uint32_t framed = spaced | all_of({Option::frame});
constexpr std::uint32_t mesh = all_of({Option::voxel_size, Option::automatic_resolution});
constexpr std::uint32_t folder = framed | all_of({Option::channel, Option::series});

constexpr std::array<FileFormat, 15> formats{{
    {.kind = FileKind::raw,
     .name = "raw",
     .extensions = {".raw"},
     .may_be_patched = true,
     .written = Written::as_they_are,
     .takes = spaced | all_of({Option::dims, Option::voxel_type})},
    {.kind = FileKind::vdb,
     .name = "OpenVDB",
     .extensions = {".vdb"},
     .written = Written::as_floats,
     .written_frame = WrittenFrame::world,
     .takes = any_volume | all_of({Option::grid})},
    {.kind = FileKind::nifti,
     .name = "NIfTI",
     .extensions = {".nii", ".hdr", ".img"},
     .may_be_packed = true,
     .may_be_patched = true,
     .written = Written::as_they_are,
     .written_frame = WrittenFrame::ras,
     .writes_unit = true,
     .takes = framed | all_of({Option::transform})},
    {.kind = FileKind::nrrd,
     .name = "NRRD",
     .extensions = {".nrrd", ".nhdr"},
     .may_be_patched = true,
     .written = Written::as_they_are,
     .written_frame = WrittenFrame::any,
     .writes_unit = true,
     .takes = framed},
    {.kind = FileKind::meta_image,
     .name = "MetaImage",
     .extensions = {".mha", ".mhd"},
     .may_be_patched = true,
     .written = Written::as_they_are,
     .written_frame = WrittenFrame::lps,
     .takes = framed},
    {.kind = FileKind::dicom,
     .name = "DICOM",
     .extensions = {".dcm"},
     .takes = framed | all_of({Option::series})},
    {.kind = FileKind::tiff,
     .name = "TIFF",
     .extensions = {".tif", ".tiff"},
     .is_slice = true,
     .takes = framed | all_of({Option::channel})},
    {.kind = FileKind::png,
     .name = "PNG",
     .extensions = {".png"},
     .is_slice = true,
     .takes = spaced},
    {.kind = FileKind::bmp,
     .name = "BMP",
     .extensions = {".bmp"},
     .is_slice = true,
     .takes = spaced},
    {.kind = FileKind::npy,
     .name = "NumPy",
     .extensions = {".npy"},
     .may_be_patched = true,
     .written = Written::as_they_are,
     .takes = framed},
    {.kind = FileKind::vti,
     .name = "VTK",
     .extensions = {".vti"},
     .written = Written::as_they_are,
     .written_frame = WrittenFrame::world,
     .takes = spaced | all_of({Option::grid})},
    {.kind = FileKind::stl, .name = "STL", .extensions = {".stl"}, .is_mesh = true, .takes = mesh},
    {.kind = FileKind::ply, .name = "PLY", .extensions = {".ply"}, .is_mesh = true, .takes = mesh},
    {.kind = FileKind::obj, .name = "OBJ", .extensions = {".obj"}, .is_mesh = true, .takes = mesh},
    {.kind = FileKind::off, .name = "OFF", .extensions = {".off"}, .is_mesh = true, .takes = mesh},
}};

std::string lower_case_name(const std::filesystem::path& path) {
  return lower_case(path.filename().string());
}

bool ends_in(const FileFormat& format, std::string_view name) {
  return std::any_of(format.extensions.begin(), format.extensions.end(), [&](std::string_view end) {
    return !end.empty() && name.size() > end.size() && name.ends_with(end);
  });
}

/// "a, b and c".
std::string list_of(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last : ", ";
    text += words[i];
  }
  return text;
}

std::vector<std::string> extensions_of(bool meshes) {
  std::vector<std::string> extensions;
  for (const FileFormat& format : formats) {
    if (format.is_mesh != meshes) continue;
    for (const std::string_view extension : format.extensions) {
      if (!extension.empty()) extensions.emplace_back(extension);
    }
  }
  return extensions;
}

}  // namespace

std::span<const FileFormat> file_formats() { return formats; }

const FileFormat* file_format(const std::filesystem::path& path) {
  std::string name = lower_case_name(path);
  const bool packed = name.ends_with(".gz");
  if (packed) name.resize(name.size() - 3);
  for (const FileFormat& format : formats) {
    if (ends_in(format, name)) return packed && !format.may_be_packed ? nullptr : &format;
  }
  return nullptr;
}

std::optional<FileKind> file_kind(const std::filesystem::path& path) {
  const FileFormat* const format = file_format(path);
  if (format == nullptr) return std::nullopt;
  return format->kind;
}

bool takes_option(const FileFormat& format, Option option) {
  return (format.takes & all_of({option})) != 0;
}

bool folders_take_option(Option option) { return (folder & all_of({option})) != 0; }

std::string supported_extensions() { return list_of(extensions_of(false), " or "); }

std::string mesh_extensions() { return list_of(extensions_of(true), " and "); }

bool is_written(const std::filesystem::path& path) {
  const FileFormat* const format = file_format(path);
  if (format == nullptr || format->written == Written::no) return false;
  std::string name = lower_case_name(path);
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  return name.ends_with(format->extensions[0]);
}

std::string written_extensions() {
  std::vector<std::string> extensions;
  for (const Written how : {Written::as_they_are, Written::as_floats}) {
    for (const FileFormat& format : formats) {
      if (format.written != how) continue;
      extensions.emplace_back(format.extensions[0]);
      if (format.may_be_packed) extensions.push_back(extensions.back() + ".gz");
    }
  }
  return list_of(extensions, " or ");
}

std::string extension_of(const std::filesystem::path& path) {
  const std::string last = lower_case(path.extension().string());
  return last == ".gz" ? lower_case(path.stem().extension().string()) + last : last;
}

}  // namespace isoloop
