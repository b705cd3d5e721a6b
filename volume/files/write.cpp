#include "volume/files/write.h"

#include "core/base/errors.h"
#include "volume/base/atomic_file.h"
#include "volume/base/file_kind.h"
#include "volume/formats/nrrd.h"
#include "volume/formats/raw.h"
#include "volume/vdb/vdb.h"

namespace isoloop {

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  if (!is_written(path)) {
    throw InvalidArgument(
        {.file = path.string(), .text = "volumes are written as " + written_extensions()});
  }
  AtomicFile file(path);
  write_volume(file.stream(), volume, path);
  file.commit();
}

void write_volume(std::ostream& out, const Volume& volume, const std::filesystem::path& path) {
  switch (file_kind(path).value_or(FileKind::raw)) {
    case FileKind::vdb:
      write_vdb(out, volume, path.string());
      break;
    case FileKind::nrrd:
      write_nrrd(out, volume);
      break;
    default:
      write_raw(out, volume);
  }
}

}  // namespace isoloop
