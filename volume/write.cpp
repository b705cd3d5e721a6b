#include "volume/write.h"

#include "core/errors.h"
#include "volume/atomic_file.h"
#include "volume/file_kind.h"
#include "volume/raw.h"
#include "volume/vdb.h"

namespace isoloop {

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  const std::optional<FileKind> kind = file_kind(path);
  if (!kind || !is_written(*kind)) {
    throw InvalidArgument(path.string() + ": volumes are written as " + written_extensions());
  }
  AtomicFile file(path);
  if (*kind == FileKind::raw) {
    write_raw(file.stream(), volume);
  } else {
    write_vdb(file.stream(), volume, path.string());
  }
  file.commit();
}

}  // namespace isoloop
