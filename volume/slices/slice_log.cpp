#include "volume/slices/slice_log.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

/// What one log states; µm.
struct Stated {
  std::optional<double> reconstructed{};  // of a voxel
  std::optional<double> recorded{};       // of a pixel of the scanner's images
  double step = 1.0;                      // slices from one to the next
  std::string odd{};                      // a line that states no length
};

Stated stated_in(const std::string& text) {
  Stated stated;
  std::string section;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string all = lower_case(trimmed(line));
    if (all.starts_with('[')) section = all;
    const std::size_t equals = all.find('=');
    if (equals == std::string::npos) continue;
    const std::string key(trimmed(std::string_view(all).substr(0, equals)));
    const bool is_reconstruction = section == "[reconstruction]";
    const bool is_voxel = is_reconstruction && key == "pixel size (um)";
    const bool is_pixel = key == "image pixel size (um)";
    const bool is_step = is_reconstruction && key == "section to section step";
    if (!is_voxel && !is_pixel && !is_step) continue;
    const auto number = number_of(trimmed(std::string_view(all).substr(equals + 1)));
    if (!number || !is_spacing(*number)) {
      stated.odd = trimmed(line);
    } else if (is_step) {
      stated.step = *number;
    } else {
      (is_voxel ? stated.reconstructed : stated.recorded) = *number;
    }
  }
  return stated;
}

std::string beginning_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::size_t{1} << 20, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

}  // namespace

std::optional<SliceLog> read_slice_logs(const std::vector<std::filesystem::path>& logs,
                                        std::optional<Finding>& warning) {
  std::vector<SliceLog> reconstructed;
  std::vector<SliceLog> recorded;
  for (const auto& file : logs) {
    const Stated stated = stated_in(beginning_of(file));
    if (!stated.odd.empty()) {
      warning = Finding{.text = file.filename().string() + " states '" + stated.odd +
                                "', which is no length, so that line is passed over",
                        .advice = {Advice::state_spacing}};
    }
    if (stated.reconstructed) {
      const double size = *stated.reconstructed;
      reconstructed.push_back({file, {size, size, size * stated.step}});
    } else if (stated.recorded) {
      const double size = *stated.recorded;
      recorded.push_back({file, {size, size, size}});
    }
  }
  const std::vector<SliceLog>& best = reconstructed.empty() ? recorded : reconstructed;
  if (best.empty()) return std::nullopt;
  for (const SliceLog& log : best) {
    if (log.spacing == best.front().spacing) continue;
    warning = Finding{.text = best.front().file.filename().string() + " and " +
                              log.file.filename().string() +
                              " state different pixel sizes, so none is taken",
                      .advice = {Advice::state_spacing}};
    return std::nullopt;
  }
  return best.front();
}

}  // namespace isoloop
