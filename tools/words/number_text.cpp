#include "tools/words/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace isoloop {
namespace {

// The largest double has 309 digits before the point.
constexpr std::size_t longest_number = 400;
constexpr int most_decimals = 12;

}  // namespace

std::string shortest_text(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, longest_number> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value == 0.0 ? 0.0 : value).ptr;
  return {text.begin(), end};
}

std::string fixed_text(double value, int decimals) {
  if (!std::isfinite(value)) return shortest_text(value);
  std::array<char, longest_number> text{};
  const auto end =
      std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, decimals).ptr;
  std::string result(text.begin(), end);
  if (result.find_first_not_of("-0.") == std::string::npos && result.front() == '-') {
    result.erase(0, 1);
  }
  return result;
}

int length_decimals(const Vec3& spacing) {
  const double smallest = *std::min_element(spacing.begin(), spacing.end());
  if (!(smallest > 0.0) || !std::isfinite(smallest)) return 2;
  // The small addend keeps 0.1 and its like, whose logarithm is not exact, on their own side.
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(smallest) + 1e-9));
  return std::clamp(decimals, 0, most_decimals);
}

std::string counted(std::int64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace isoloop
