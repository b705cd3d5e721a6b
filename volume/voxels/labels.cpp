#include "volume/voxels/labels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include "core/base/errors.h"
#include "core/grid/lattice.h"
#include "volume/base/rounded_text.h"

namespace isoloop {
namespace {

constexpr std::size_t most_listed = 20;   // labels in a message
constexpr std::size_t most_examples = 3;  // values in a message

std::string list_of(const std::vector<std::int64_t>& labels) {
  std::string text;
  for (const std::int64_t label : labels)
    text += (text.empty() ? "" : ", ") + std::to_string(label);
  return text;
}

/// What is learnt of the labels on the way over the voxels.
struct Census {
  std::map<std::int64_t, bool> wanted{};  // whether a voxel has it
  std::set<std::int64_t> lowest{};        // of all labels, most_listed at most
  std::int64_t taken_near = 0;            // voxels of wanted labels that are no whole numbers
  double largest_distance = 0.0;          // of those
  std::int64_t strays = 0;                // voxels that have no label
  std::vector<double> examples{};         // of their values

  void list(std::int64_t label) {
    if (lowest.size() == most_listed && label > *lowest.rbegin()) return;
    lowest.insert(label);
    if (lowest.size() > most_listed) lowest.erase(std::prev(lowest.end()));
  }

  void add_stray(double value) {
    ++strays;
    if (examples.size() < most_examples &&
        std::find(examples.begin(), examples.end(), value) == examples.end()) {
      examples.push_back(value);
    }
  }
};

/// Its label, if it has one; no label is so large that doubles do not hold its neighbours.
template <class T>
std::optional<std::int64_t> label_of(T value) {
  if constexpr (std::is_integral_v<T>) {
    return static_cast<std::int64_t>(value);
  } else {
    constexpr double most = 1e15;
    const double nearest = std::round(static_cast<double>(value));
    const double distance = std::abs(static_cast<double>(value) - nearest);
    if (!(std::abs(nearest) < most) || distance > label_tolerance) return std::nullopt;
    return static_cast<std::int64_t>(nearest);
  }
}

template <class T>
std::vector<std::uint8_t> mask_of(const std::vector<T>& values, Census& census) {
  std::vector<std::uint8_t> mask(values.size());
  T last{};  // neighbours are often equal
  std::optional<std::int64_t> label;
  bool wanted = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == 0 || values[i] != last) {
      last = values[i];
      label = label_of(last);
      const auto found = label ? census.wanted.find(*label) : census.wanted.end();
      wanted = found != census.wanted.end();
      if (wanted) found->second = true;
      if (label) census.list(*label);
    }
    if (!label) census.add_stray(static_cast<double>(last));
    if (!wanted) continue;
    mask[i] = 1;
    const double distance = std::abs(static_cast<double>(last) - static_cast<double>(*label));
    if (distance == 0.0) continue;
    ++census.taken_near;
    census.largest_distance = std::max(census.largest_distance, distance);
  }
  return mask;
}

std::string examples_of(const Census& census) {
  std::string list;
  for (const double value : census.examples)
    list += (list.empty() ? "" : ", ") + rounded_text(value, 9);
  return "lie farther than " + rounded_text(label_tolerance, 9) + " from a whole number, such as " +
         list;
}

void check_strays(const Census& census, std::size_t voxels, const std::string& what) {
  if (census.strays <= static_cast<std::int64_t>(voxels) / voxels_for_each_stray) return;
  throw InvalidArgument(
      {.file = what,
       .text = "is no label map: " + std::to_string(census.strays) + " of " +
               std::to_string(voxels) + " voxels " + examples_of(census) +
               "; take an iso value in their place, or resample the labels without "
               "interpolation"},
      Option::labels);
}

void report(const Census& census, const std::vector<std::int64_t>& labels, const std::string& what,
            Volume& volume) {
  std::vector<std::int64_t> missing;
  for (const auto& [label, found] : census.wanted) {
    if (!found) missing.push_back(label);
  }
  if (missing.size() == census.wanted.size()) {
    throw InvalidArgument(
        {.file = what,
         .text = "no voxel has the label " + list_of(labels) + "; the lowest labels in it are " +
                 list_of({census.lowest.begin(), census.lowest.end()})},
        Option::labels);
  }
  if (!missing.empty())
    volume.warnings.push_back({.text = "no voxel has the label " + list_of(missing)});
  if (census.strays > 0) {
    volume.warnings.push_back(
        {.text = "values that " + examples_of(census) +
                 ", are no labels: voxels that are outside for that reason: " +
                 std::to_string(census.strays)});
  }
  volume.notes.push_back({.text = "a mask: 1 where the label is " + list_of(labels) + ", else 0"});
  if (census.taken_near > 0) {
    volume.notes.push_back(
        {.text = std::to_string(census.taken_near) +
                 " voxels of these labels are no whole numbers: the nearest is taken, " +
                 rounded_text(census.largest_distance, 9) + " off at most"});
  }
}

/// Votes of the voxels round one that changes sides.
template <class T>
class LabelVotes {
 public:
  LabelVotes(const GridView<T>& labels, std::span<const SidedVoxel> voxels,
             const std::vector<std::int64_t>& asked)
      : labels_(labels), asked_(asked.begin(), asked.end()) {
    for (const SidedVoxel& sided : voxels) changed_.emplace(sided.voxel, Changed{sided.is_inside});
  }

  /// From the rim inwards: voxels that have got a label vote in the next round.
  std::vector<std::int64_t> decided(std::span<const SidedVoxel> voxels) {
    for (bool goes_on = true; goes_on;) {
      std::vector<std::pair<std::size_t, std::int64_t>> found;
      for (const SidedVoxel& sided : voxels)
        if (!changed_.at(sided.voxel).label)
          if (const std::optional<std::int64_t> label = vote(sided))
            found.emplace_back(sided.voxel, *label);
      for (const auto& [voxel, label] : found) changed_.at(voxel).label = label;
      goes_on = !found.empty();
    }
    std::vector<std::int64_t> result;
    result.reserve(voxels.size());
    for (const SidedVoxel& sided : voxels)
      result.push_back(
          changed_.at(sided.voxel).label.value_or(sided.is_inside ? any_asked() : any_other()));
    return result;
  }

 private:
  struct Changed {
    bool is_inside = false;
    std::optional<std::int64_t> label{};
  };

  std::optional<std::int64_t> vote(const SidedVoxel& sided) const {
    std::map<std::int64_t, int> votes;
    const Index3& dims = labels_.dims;
    const Index3 voxel = voxel_index(sided.voxel, dims);
    for (std::int64_t i = 0; i < 27; ++i) {
      const Index3 near{voxel[0] + i % 3 - 1, voxel[1] + i / 3 % 3 - 1, voxel[2] + i / 9 - 1};
      if (i == 13 || !is_within(near)) continue;
      const auto label =
          label_on_side(static_cast<std::size_t>(near[0] + dims[0] * (near[1] + dims[1] * near[2])),
                        sided.is_inside);
      if (label) ++votes[*label];
    }
    if (votes.empty()) return std::nullopt;
    // The first of the largest has the least label.
    return std::max_element(votes.begin(), votes.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  /// That of a voxel on this side, unless it changes sides and has none yet.
  std::optional<std::int64_t> label_on_side(std::size_t voxel, bool is_inside) const {
    if (const auto changed = changed_.find(voxel); changed != changed_.end())
      return changed->second.is_inside == is_inside ? changed->second.label : std::nullopt;
    const std::optional<std::int64_t> label = label_of(labels_.values[voxel]);
    return label && asked_.contains(*label) == is_inside ? label : std::nullopt;
  }

  bool is_within(const Index3& voxel) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (voxel[a] < 0 || voxel[a] >= labels_.dims[a]) return false;
    return true;
  }

  /// The least of those asked for that a voxel has.
  std::int64_t any_asked() const {
    std::optional<std::int64_t> least;
    for (const T value : labels_.values) {
      const std::optional<std::int64_t> label = label_of(value);
      if (label && asked_.contains(*label) && (!least || *label < *least)) least = label;
    }
    return least.value_or(*asked_.begin());
  }

  std::int64_t any_other() const {
    std::int64_t label = 0;
    while (asked_.contains(label)) ++label;
    return label;
  }

  const GridView<T>& labels_;
  std::set<std::int64_t> asked_;
  std::map<std::size_t, Changed> changed_;  // by voxel
};

}  // namespace

std::vector<std::int64_t> labels_of_sided(const AnyGridView& labels,
                                          std::span<const SidedVoxel> voxels,
                                          const std::vector<std::int64_t>& asked) {
  return std::visit(
      [&]<class T>(const GridView<T>& grid) {
        return LabelVotes<T>(grid, voxels, asked).decided(voxels);
      },
      labels);
}

Volume mask_of_labels(Volume volume, const std::vector<std::int64_t>& labels,
                      const std::string& what) {
  Census census;
  for (const std::int64_t label : labels) census.wanted.emplace(label, false);
  volume.values = std::visit(
      [&](const auto& values) -> VoxelArray {
        std::vector<std::uint8_t> mask = mask_of(values, census);
        check_strays(census, values.size(), what);
        return mask;
      },
      VoxelArray(std::move(volume.values)));
  report(census, labels, what, volume);
  volume.stored_at.reset();
  volume.level_set = false;
  volume.mask = true;
  return volume;
}

}  // namespace isoloop
