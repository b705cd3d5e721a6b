#include "volume/formats/dicom_slice.h"

#include <type_traits>
#include <vector>

#include "volume/base/refuse.h"
#include "volume/formats/dicom_elements.h"

namespace isoloop {
namespace {

std::int64_t required(const DicomElements& elements, DicomTag tag, const char* name,
                      const std::string& what) {
  const auto number = whole_of(elements, tag, what);
  if (!number) refuse(what, std::string("does not state its ") + name);
  return *number;
}

void refuse_what_is_no_slice(const DicomElements& elements, const std::string& what) {
  if (elements.pixel_bytes == 0) {
    refuse(what, "holds no pixels: it is cut short or no image; fetch it again or move it away");
  }
  if (elements.packed_pixels) {
    refuse(what, "its pixels are compressed (transfer syntax " + elements.transfer_syntax + ")",
           Fault::unsupported, {Advice::unpack_slices});
  }
  const std::string frames = text_of(elements, 0x00280008U);
  if (!frames.empty() && frames != "1") {
    refuse(what,
           "holds " + frames +
               " frames in one file, which isoloop does not read; convert "
               "it to single slices or NIfTI",
           Fault::unsupported);
  }
  const std::int64_t samples = whole_of(elements, 0x00280002U, what).value_or(1);
  const std::string colours = text_of(elements, 0x00280004U);
  if (samples != 1 || (!colours.empty() && !colours.starts_with("MONOCHROME"))) {
    refuse(what,
           "holds colour (" + colours + ", " + std::to_string(samples) +
               " samples per pixel), not one value per voxel",
           Fault::unsupported);
  }
}

void set_pixels(const DicomElements& elements, DicomSlice& slice, const std::string& what) {
  const std::int64_t allocated = required(elements, 0x00280100U, "bits allocated", what);
  const std::int64_t stored = whole_of(elements, 0x00280101U, what).value_or(allocated);
  const std::int64_t high = whole_of(elements, 0x00280102U, what).value_or(stored - 1);
  slice.is_signed = whole_of(elements, 0x00280103U, what).value_or(0) != 0;
  const auto bytes = static_cast<std::uint64_t>(allocated / 8);
  if ((allocated != 8 && allocated != 16 && allocated != 32) || stored < 1 || stored > allocated ||
      high < stored - 1 || high >= allocated) {
    refuse(what,
           "states pixels of " + std::to_string(stored) + " bits in " + std::to_string(allocated) +
               ", which isoloop does not read",
           Fault::unsupported);
  }
  slice.stored_bits = static_cast<int>(stored);
  slice.shift = static_cast<int>(high + 1 - stored);
  slice.layout.type = *integer_type(bytes, slice.is_signed);
  slice.layout.endian = elements.endian;
  slice.layout.dims = {required(elements, 0x00280011U, "columns", what),
                       required(elements, 0x00280010U, "rows", what), 1};
  slice.pixels_from = elements.pixels_from;
  const auto scale = decimals_of(elements, 0x00281053U, what);
  const auto shift = decimals_of(elements, 0x00281052U, what);
  if (scale) slice.layout.slope = scale->front();
  if (shift) slice.layout.intercept = shift->front();
}

void check_pixel_bytes(const DicomElements& elements, const DicomSlice& slice,
                       const std::string& what) {
  const auto wanted = static_cast<std::uint64_t>(slice.layout.dims[0] * slice.layout.dims[1]) *
                      bytes_per_voxel(slice.layout.type);
  // Odd lengths are padded.
  if (elements.pixel_bytes == wanted + wanted % 2) return;
  refuse(what, "states " + std::to_string(slice.layout.dims[0]) + " x " +
                   std::to_string(slice.layout.dims[1]) + " pixels, which take " +
                   std::to_string(wanted) + " bytes, but holds " +
                   std::to_string(elements.pixel_bytes) + "; fetch the file again");
}

// As many numbers as there should be, or none.
std::optional<std::vector<double>> vector_of(const DicomElements& elements, DicomTag tag,
                                             std::size_t count, const std::string& what) {
  auto numbers = decimals_of(elements, tag, what);
  if (numbers && numbers->size() != count) {
    refuse(what, "states " + std::to_string(numbers->size()) + " numbers where " +
                     std::to_string(count) + " should be");
  }
  return numbers;
}

void set_place(const DicomElements& elements, DicomSlice& slice, const std::string& what) {
  if (const auto pixel = vector_of(elements, 0x00280030U, 2, what)) {
    slice.spacing = {(*pixel)[1], (*pixel)[0], 1.0};  // rows come first
  }
  const auto between = vector_of(elements, 0x00180088U, 1, what);
  const auto thickness = vector_of(elements, 0x00180050U, 1, what);
  if (thickness) slice.spacing[2] = thickness->front();
  if (between) slice.spacing[2] = between->front();
  const auto position = vector_of(elements, 0x00200032U, 3, what);
  const auto axes = vector_of(elements, 0x00200037U, 6, what);
  if (!position || !axes) return;
  slice.position = Vec3{(*position)[0], (*position)[1], (*position)[2]};
  slice.axes = {Vec3{(*axes)[0], (*axes)[1], (*axes)[2]}, Vec3{(*axes)[3], (*axes)[4], (*axes)[5]}};
}

// The bits between may be used for other things: only the stored ones count.
template <class T>
void keep_stored_bits(std::vector<T>& pixels, const DicomSlice& slice) {
  using Bits = std::make_unsigned_t<T>;
  constexpr int width = 8 * sizeof(T);
  const int up = width - slice.stored_bits - slice.shift;
  const int down = width - slice.stored_bits;
  for (T& pixel : pixels) {
    const auto raised = static_cast<T>(static_cast<Bits>(static_cast<Bits>(pixel) << up));
    pixel = static_cast<T>(raised >> down);  // extends the sign of signed ones
  }
}

}  // namespace

DicomSlice read_dicom_slice(const std::filesystem::path& path) {
  const std::string what = path.string();
  const DicomElements elements = read_dicom_elements(path);
  refuse_what_is_no_slice(elements, what);
  DicomSlice slice;
  slice.path = path;
  slice.series = text_of(elements, 0x0020000eU);
  slice.description = "number " + text_of(elements, 0x00200011U) + ", " +
                      text_of(elements, 0x00080060U) + ", '" + text_of(elements, 0x0008103eU) + "'";
  const auto instance = decimals_of(elements, 0x00200013U, what);
  if (instance && instance->front() > -1e9 && instance->front() < 1e9) {
    slice.instance = static_cast<std::int64_t>(instance->front());
  }
  set_pixels(elements, slice, what);
  check_pixel_bytes(elements, slice, what);
  set_place(elements, slice, what);
  return slice;
}

VoxelArray read_pixels(const DicomSlice& slice) {
  ByteStream stream(slice.path, Packing::plain, slice.pixels_from);
  VoxelArray pixels = read_stored([&](std::span<std::byte> to) { stream.read(to, "its pixels"); },
                                  slice.layout, slice.path.string());
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) keep_stored_bits(values, slice);
      },
      pixels);
  return pixels;
}

}  // namespace isoloop
