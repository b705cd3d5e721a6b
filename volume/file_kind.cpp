#include "volume/file_kind.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace isoloop {
namespace {

struct Extension {
  std::string_view text;
  FileKind kind;
};

// In the order in which messages list them.
constexpr std::array<Extension, 14> extensions{{{".raw", FileKind::raw},
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
                                                {".npy", FileKind::npy},
                                                {".vti", FileKind::vti}}};

}  // namespace

std::optional<FileKind> file_kind(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
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

bool is_written(FileKind kind) { return kind == FileKind::raw || kind == FileKind::vdb; }

std::string written_extensions() { return ".raw or .vdb"; }

}  // namespace isoloop
