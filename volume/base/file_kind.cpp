#include "volume/base/file_kind.h"

#include <array>
#include <string_view>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

struct Extension {
  std::string_view text;
  FileKind kind;
};

// In the order in which messages list them.
constexpr std::array<Extension, 16> extensions{{{".raw", FileKind::raw},
                                                {".vdb", FileKind::vdb},
                                                {".nii", FileKind::nifti},
                                                {".hdr", FileKind::nifti},
                                                {".img", FileKind::nifti},
                                                {".nrrd", FileKind::nrrd},
                                                {".nhdr", FileKind::nrrd},
                                                {".mha", FileKind::meta_image},
                                                {".mhd", FileKind::meta_image},
                                                {".dcm", FileKind::dicom},
                                                {".tif", FileKind::tiff},
                                                {".tiff", FileKind::tiff},
                                                {".png", FileKind::png},
                                                {".bmp", FileKind::bmp},
                                                {".npy", FileKind::npy},
                                                {".vti", FileKind::vti}}};

std::string lower_case_name(const std::filesystem::path& path) {
  return lower_case(path.filename().string());
}

}  // namespace

std::optional<FileKind> file_kind(const std::filesystem::path& path) {
  std::string name = lower_case_name(path);
  const bool packed = name.ends_with(".gz");
  if (packed) name.resize(name.size() - 3);
  for (const auto& [text, kind] : extensions) {
    if (name.size() <= text.size() || !name.ends_with(text)) continue;
    if (packed && kind != FileKind::nifti) return std::nullopt;
    return kind;
  }
  return std::nullopt;
}

std::string supported_extensions() {
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    if (i > 0) text += i + 1 == extensions.size() ? " or " : ", ";
    text += extensions[i].text;
  }
  return text;
}

bool is_written(const std::filesystem::path& path) {
  const std::optional<FileKind> kind = file_kind(path);
  if (kind == FileKind::nrrd) return lower_case_name(path).ends_with(".nrrd");
  return kind == FileKind::raw || kind == FileKind::vdb;
}

std::string written_extensions() { return ".raw, .nrrd or .vdb"; }

}  // namespace isoloop
