#include "volume/vdb/vdb_message.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <type_traits>
#include <utility>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

constexpr std::uint64_t opening = 0x316264766f73690a;  // "\nisovdb1"
constexpr std::uint32_t most_text_bytes = 1U << 16;
constexpr double right_angle_tolerance = 1e-5;  // cosine between two index axes

enum class Part : std::uint32_t {
  volume = 0,
  argument = 1,
  input = 2,
  tile = 10,
  leaf = 11,
  end = 12
};

template <class T>
void put(std::ostream& out, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_text(std::ostream& out, const std::string& text) {
  const auto bytes =
      static_cast<std::uint32_t>(std::min<std::size_t>(text.size(), most_text_bytes));
  put(out, bytes);
  out.write(text.data(), bytes);
}

void read_bytes(std::istream& in, void* to, std::size_t bytes) {
  if (!in.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes))) {
    throw BrokenMessage("it stopped before the end");
  }
}

template <class T>
T get(std::istream& in) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value{};
  read_bytes(in, &value, sizeof value);
  return value;
}

/// Control characters, which a damaged file may hold anywhere, become question marks.
std::string get_text(std::istream& in) {
  const auto bytes = get<std::uint32_t>(in);
  if (bytes > most_text_bytes) throw BrokenMessage("a text in it is too long");
  std::string text(bytes, '\0');
  read_bytes(in, text.data(), bytes);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
  return text;
}

/// A value of an enumeration that ends with `last`.
template <class Value>
Value get_value(std::istream& in, Value last) {
  const auto number = get<std::uint32_t>(in);
  if (number > static_cast<std::uint32_t>(last))
    throw BrokenMessage("its error is of no known kind");
  return static_cast<Value>(number);
}

template <class Value>
void put_value(std::ostream& out, Value value) {
  put(out, static_cast<std::uint32_t>(value));
}

void put_finding(std::ostream& out, const Finding& finding) {
  put_text(out, finding.file);
  put_text(out, finding.place);
  put_value(out, finding.about);
  put_text(out, finding.text);
  put(out, static_cast<std::uint32_t>(finding.advice.size()));
  for (const Advice advice : finding.advice) put_value(out, advice);
}

Finding get_finding(std::istream& in) {
  Finding finding;
  finding.file = get_text(in);
  finding.place = get_text(in);
  finding.about = get_value(in, last_option);
  finding.text = get_text(in);
  const auto count = get<std::uint32_t>(in);
  if (count > static_cast<std::uint32_t>(last_advice) + 1)
    throw BrokenMessage("its error gives too much advice");
  for (std::uint32_t i = 0; i < count; ++i) finding.advice.push_back(get_value(in, last_advice));
  return finding;
}

[[noreturn]] void throw_argument(std::istream& in) {
  const Option option = get_value(in, last_option);
  throw InvalidArgument(get_finding(in), option);
}

[[noreturn]] void throw_input(std::istream& in) {
  const Fault fault = get_value(in, last_fault);
  throw InvalidInput(get_finding(in), fault);
}

void check_frame(const Volume& volume) {
  const auto finite = [](const Vec3& v) {
    return std::all_of(v.begin(), v.end(), [](double c) { return std::isfinite(c); });
  };
  bool sound = finite(volume.origin) && finite(volume.spacing);
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3& axis = volume.direction[a];
    sound = sound && volume.spacing[a] > 0.0 && finite(axis) &&
            std::abs(dot(axis, axis) - 1.0) < right_angle_tolerance &&
            std::abs(dot(axis, volume.direction[(a + 1) % 3])) < right_angle_tolerance;
  }
  if (!sound) throw BrokenMessage("its transform makes no frame");
}

VdbHeader get_header(std::istream& in) {
  VdbHeader header;
  header.type = get<VoxelType>(in);
  if (header.type != VoxelType::float32 && header.type != VoxelType::float64) {
    throw BrokenMessage("its voxels are of no type that was asked for");
  }
  Volume& volume = header.volume;
  volume.dims = get<Index3>(in);
  for (const std::int64_t dim : volume.dims) {
    if (dim < 1) throw BrokenMessage("it has no voxels");
  }
  volume.spacing = get<Vec3>(in);
  volume.origin = get<Vec3>(in);
  volume.direction = get<std::array<Vec3, 3>>(in);
  volume.frame = Frame::world;
  check_frame(volume);
  header.background = get<double>(in);
  if (header.type == VoxelType::float32 && std::isfinite(header.background) &&
      std::abs(header.background) > std::numeric_limits<float>::max()) {
    throw BrokenMessage("its background is no value of its type");
  }
  volume.level_set = get<std::uint8_t>(in) != 0;
  volume.name = get_text(in);
  return header;
}

/// The voxels of a block, and of all blocks together: each voxel may come once.
class BlockBudget {
 public:
  explicit BlockBudget(const Index3& dims) : dims_(dims), left_(dims[0] * dims[1] * dims[2]) {}

  /// Cuts a block to the volume. Throws BrokenMessage if nothing is left of it, or if the blocks
  /// hold more voxels than the volume.
  void take(Index3& low, Index3& high) {
    std::int64_t voxels = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max<std::int64_t>(low[a], 0);
      high[a] = std::min(high[a], dims_[a] - 1);
      if (low[a] > high[a]) throw BrokenMessage("a block of it lies beyond its voxels");
      voxels *= high[a] - low[a] + 1;
    }
    if (voxels > left_) throw BrokenMessage("its blocks overlap");
    left_ -= voxels;
  }

 private:
  Index3 dims_;
  std::int64_t left_;
};

template <class T>
class Receiver {
 public:
  Receiver(std::istream& in, const Index3& dims, T background)
      : in_(in), dims_(dims), budget_(dims) {
    values_.assign(static_cast<std::size_t>(dims[0] * dims[1] * dims[2]), background);
  }

  std::vector<T> receive() && {
    while (true) {
      switch (get<Part>(in_)) {
        case Part::tile:
          receive_tile();
          break;
        case Part::leaf:
          receive_leaf();
          break;
        case Part::end:
          return std::move(values_);
        default:
          throw BrokenMessage("a part of it is of no known kind");
      }
    }
  }

 private:
  T* row(std::int64_t i, std::int64_t j, std::int64_t k) {
    return values_.data() + (i + dims_[0] * (j + dims_[1] * k));
  }

  void receive_tile() {
    auto low = get<Index3>(in_);
    auto high = get<Index3>(in_);
    const T value = get<T>(in_);
    budget_.take(low, high);
    for (std::int64_t k = low[2]; k <= high[2]; ++k) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        std::fill_n(row(low[0], j, k), high[0] - low[0] + 1, value);
      }
    }
  }

  void receive_leaf() {
    const auto corner = get<Index3>(in_);
    const auto values = get<std::array<T, leaf_voxels>>(in_);
    for (std::size_t a = 0; a < 3; ++a) {
      if (corner[a] <= -leaf_side || corner[a] >= dims_[a]) {
        throw BrokenMessage("a block of it lies beyond its voxels");
      }
    }
    Index3 low = corner;
    Index3 high{corner[0] + leaf_side - 1, corner[1] + leaf_side - 1, corner[2] + leaf_side - 1};
    budget_.take(low, high);
    for (std::int64_t k = low[2]; k <= high[2]; ++k) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        T* const to = row(0, j, k);
        for (std::int64_t i = low[0]; i <= high[0]; ++i) {
          const std::int64_t from =
              ((i - corner[0]) * leaf_side + j - corner[1]) * leaf_side + k - corner[2];
          to[i] = values[static_cast<std::size_t>(from)];
        }
      }
    }
  }

  std::istream& in_;
  Index3 dims_;
  BlockBudget budget_;
  std::vector<T> values_;
};

}  // namespace

void send_header(std::ostream& out, const VdbHeader& header) {
  const Volume& volume = header.volume;
  put(out, opening);
  put(out, Part::volume);
  put(out, header.type);
  put(out, volume.dims);
  put(out, volume.spacing);
  put(out, volume.origin);
  put(out, volume.direction);
  put(out, header.background);
  put(out, static_cast<std::uint8_t>(volume.level_set));
  put_text(out, volume.name);
}

template <class T>
void send_tile(std::ostream& out, const Index3& low, const Index3& high, T value) {
  put(out, Part::tile);
  put(out, low);
  put(out, high);
  put(out, value);
}

template void send_tile(std::ostream&, const Index3&, const Index3&, float);
template void send_tile(std::ostream&, const Index3&, const Index3&, double);

template <class T>
void send_leaf(std::ostream& out, const Index3& corner, std::span<const T, leaf_voxels> values) {
  put(out, Part::leaf);
  put(out, corner);
  out.write(reinterpret_cast<const char*>(values.data()),
            static_cast<std::streamsize>(values.size_bytes()));
}

template void send_leaf(std::ostream&, const Index3&, std::span<const float, leaf_voxels>);
template void send_leaf(std::ostream&, const Index3&, std::span<const double, leaf_voxels>);

void send_end(std::ostream& out) { put(out, Part::end); }

void send_error(std::ostream& out, const InvalidArgument& error) {
  put(out, opening);
  put(out, Part::argument);
  put_value(out, error.option);
  put_finding(out, error.finding);
}

void send_error(std::ostream& out, const InvalidInput& error) {
  put(out, opening);
  put(out, Part::input);
  put_value(out, error.fault);
  put_finding(out, error.finding);
}

Volume receive_volume(std::istream& in, const VoxelLimits& limits, const std::string& what) {
  if (get<std::uint64_t>(in) != opening) throw BrokenMessage("it does not begin as it should");
  switch (get<Part>(in)) {
    case Part::volume:
      break;
    case Part::argument:
      throw_argument(in);
    case Part::input:
      throw_input(in);
    default:
      throw BrokenMessage("it is of no known kind");
  }
  VdbHeader header = get_header(in);
  Volume volume = std::move(header.volume);
  const std::string grid = what + ": grid '" + volume.name + "'";
  check_voxel_memory(volume.dims, bytes_per_voxel(header.type), limits, grid);
  if (header.type == VoxelType::float32) {
    const auto background = static_cast<float>(header.background);
    volume.values = Receiver<float>(in, volume.dims, background).receive();
  } else {
    volume.values = Receiver<double>(in, volume.dims, header.background).receive();
  }
  return volume;
}

}  // namespace isoloop
