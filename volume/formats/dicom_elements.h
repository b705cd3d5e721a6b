// The elements of a DICOM file (DICOM PS3.5, PS3.10): every byte of it accounted for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "volume/base/byte_order.h"

namespace isoloop {

/// Group in the upper 16 bits, element in the lower ones.
using DicomTag = std::uint32_t;

struct DicomElements {
  /// The values of the top level's short elements, bytes as stored; without sequences.
  std::map<DicomTag, std::string> values;
  Endian endian = Endian::little;  // of the data set
  std::string transfer_syntax;     // a UID; 1.2.840.10008.1.2 and the like
  std::uint64_t pixels_from = 0;   // byte of the file
  std::uint64_t pixel_bytes = 0;   // 0: no pixels
  bool packed_pixels = false;      // in fragments (JPEG and the like)
};

/// Walks the elements to the file's end. Pixels are not read. Throws InvalidInput if an element
/// reaches beyond the file or its sequence, if the file ends within one, if sequences nest deeper
/// than 32 times, and for deflated files. A file without the 128 bytes and "DICM" must begin with
/// the data set itself, its group 8, little-endian, and is refused otherwise.
DicomElements read_dicom_elements(const std::filesystem::path& path);

/// Whether the file begins as DICOM files do, or as the data set of one without their first 132
/// bytes. Throws InvalidInput if it cannot be read.
bool looks_like_dicom(const std::filesystem::path& path);

/// A text value without its padding; empty if it is missing.
std::string text_of(const DicomElements& elements, DicomTag tag);

/// The numbers of a decimal text, "1.5\2"; nothing if missing. Throws InvalidInput.
std::optional<std::vector<double>> decimals_of(const DicomElements& elements, DicomTag tag,
                                               const std::string& what);

/// A 16-bit number; nothing if missing. Throws InvalidInput if it has another size.
std::optional<std::int64_t> whole_of(const DicomElements& elements, DicomTag tag,
                                     const std::string& what);

}  // namespace isoloop
