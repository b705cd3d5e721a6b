#include "volume/labels.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/errors.h"

namespace isoloop {
namespace {

std::string list_of(const std::vector<std::int64_t>& labels) {
  std::string text;
  for (const std::int64_t label : labels)
    text += (text.empty() ? "" : ", ") + std::to_string(label);
  return text;
}

// The smallest whole numbers among the values, at most twenty.
template <class T>
std::vector<std::int64_t> labels_in(const std::vector<T>& values) {
  constexpr std::size_t most = 20;
  std::set<std::int64_t> labels;
  for (const T value : values) {
    const auto number = static_cast<double>(value);
    if (!(std::abs(number) < 1e15) || number != std::floor(number)) continue;
    const auto label = static_cast<std::int64_t>(number);
    if (labels.size() == most && label > *labels.rbegin()) continue;
    labels.insert(label);
    if (labels.size() > most) labels.erase(std::prev(labels.end()));
  }
  return {labels.begin(), labels.end()};
}

}  // namespace

Volume mask_of_labels(Volume volume, const std::vector<std::int64_t>& labels,
                      const std::string& what) {
  std::vector<std::int64_t> missing = labels;
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        std::vector<std::uint8_t> mask(values.size());
        for (const std::int64_t label : labels) {
          const auto wanted = static_cast<double>(label);
          bool found = false;
          for (std::size_t i = 0; i < values.size(); ++i) {
            if (static_cast<double>(values[i]) != wanted) continue;
            mask[i] = 1;
            found = true;
          }
          if (found) std::erase(missing, label);
        }
        if (missing.size() == labels.size()) {
          throw InvalidArgument(what + ": no voxel has the label " + list_of(labels) +
                                " (--label); the lowest labels in it are " +
                                list_of(labels_in(values)));
        }
        volume.values = std::move(mask);
        volume.stored_at.reset();
      },
      VoxelArray(std::move(volume.values)));
  if (!missing.empty()) volume.warnings.push_back("no voxel has the label " + list_of(missing));
  volume.notes.push_back("a mask: 1 where the label is " + list_of(labels) + ", else 0");
  volume.level_set = false;
  volume.mask = true;
  return volume;
}

}  // namespace isoloop
