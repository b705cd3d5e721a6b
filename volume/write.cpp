#include "volume/write.h"

#include "core/errors.h"
#include "volume/atomic_file.h"
#include "volume/file_kind.h"
#include "volume/raw.h"
#include "volume/vdb.h"

namespace isoloop {

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  const std::optional<FileKind> kind = file_kind(path);
  if (!kind) {
    throw InvalidArgument(path.string() + ": volumes are written as " + supported_extensions());
  }
  AtomicFile file(path);
  switch (*kind) {
    case FileKind::raw:
      write_raw(file.stream(), volume);
      break;
    case FileKind::vdb:
      write_vdb(file.stream(), volume, path.string());
      break;
  }
  file.commit();
}

}  // namespace isoloop
