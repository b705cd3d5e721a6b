#include "volume/slices/slice_names.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "core/base/errors.h"
#include "volume/base/header_text.h"

namespace isoloop {
namespace {

std::string digits_at(const std::string& text, std::size_t at) {
  const std::size_t end = text.find_first_not_of("0123456789", at);
  return text.substr(at, end == std::string::npos ? end : end - at);
}

/// A name as the text between its numbers, and these.
struct NameParts {
  std::string text;  // '#' in place of each number
  std::vector<std::int64_t> numbers;
};

std::optional<NameParts> parts_of(const std::string& name) {
  NameParts parts;
  for (std::size_t i = 0; i < name.size();) {
    const std::string digits = digits_at(name, i);
    if (digits.empty()) {
      parts.text += name[i++];
      continue;
    }
    const auto number = whole_number_of(digits);
    if (!number) return std::nullopt;
    parts.text += '#';
    parts.numbers.push_back(*number);
    i += digits.size();
  }
  return parts;
}

/// The numbers that differ among names of one text: one list for each, in the order of the names.
std::vector<std::vector<std::int64_t>> varying_numbers(const std::vector<NameParts>& parts) {
  std::vector<std::vector<std::int64_t>> varying;
  for (std::size_t n = 0; n < parts.front().numbers.size(); ++n) {
    std::vector<std::int64_t> column;
    column.reserve(parts.size());
    for (const NameParts& one : parts) column.push_back(one.numbers[n]);
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    if (*least != *most) varying.push_back(std::move(column));
  }
  return varying;
}

void refuse_grid(const std::vector<std::vector<std::int64_t>>& varying, std::size_t count,
                 const std::string& what) {
  std::size_t product = 1;
  std::string list;
  for (const std::vector<std::int64_t>& column : varying) {
    const std::set<std::int64_t> values(column.begin(), column.end());
    if (values.size() == count) return;  // this number alone tells all apart
    product *= std::min(values.size(), count + 1);
    list += (list.empty() ? "" : " times ") + std::to_string(values.size());
    if (product > count) return;
  }
  if (product != count) return;
  throw InvalidInput(
      {.file = what,
       .text = "its names count along two axes (" + list +
               " slices), perhaps of channels or frames; put the slices of one volume in a "
               "folder of their own"});
}

/// The distance that is the most common between numbers in ascending order.
std::int64_t usual_step(const std::vector<std::int64_t>& numbers) {
  std::map<std::int64_t, int> steps;
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) ++steps[numbers[i + 1] - numbers[i]];
  const auto usual = std::max_element(
      steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return usual->first;
}

std::optional<std::string> gaps_in(const std::vector<std::int64_t>& numbers,
                                   const std::string& what) {
  const std::int64_t step = usual_step(numbers);
  std::string first;
  int gaps = 0;
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) {
    const std::int64_t one = numbers[i + 1] - numbers[i];
    if (one == 0) {
      throw InvalidInput({.file = what,
                          .text = "two slices have the number " + std::to_string(numbers[i]) +
                                  "; move one of them away"});
    }
    if (one == step) continue;
    if (gaps++ == 0) {
      first = std::to_string(numbers[i]) + " comes " + std::to_string(numbers[i + 1]);
    }
  }
  if (gaps == 0) return std::nullopt;
  return "the numbers in names of slices have " + std::to_string(gaps) +
         (gaps == 1 ? " gap" : " gaps") + ", the first where after " + first +
         ": slices may be missing, and are read as if none were";
}

}  // namespace

bool name_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    std::string x = digits_at(a, i);
    std::string y = digits_at(b, j);
    if (x.empty() || y.empty()) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
      continue;
    }
    i += x.size();
    j += y.size();
    x.erase(0, std::min(x.find_first_not_of('0'), x.size() - 1));
    y.erase(0, std::min(y.find_first_not_of('0'), y.size() - 1));
    if (x != y) return std::pair(x.size(), x) < std::pair(y.size(), y);
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - j, b);
}

std::optional<std::string> odd_names(const std::vector<std::string>& names,
                                     const std::string& what) {
  if (names.size() < 2) return std::nullopt;
  std::vector<NameParts> parts;
  bool numbered = false;
  for (const std::string& name : names) {
    auto one = parts_of(name);
    if (!one) return std::nullopt;  // numbers of more digits than tell of anything
    numbered = numbered || !one->numbers.empty();
    parts.push_back(std::move(*one));
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].text == parts[0].text) continue;
    if (!numbered) return std::nullopt;
    return "slices differ in more of their names than numbers (" + names[0] + ", " + names[i] +
           "): they are read in the order of their names";
  }
  const auto varying = varying_numbers(parts);
  if (varying.size() > 1) refuse_grid(varying, names.size(), what);
  if (varying.empty()) {  // 1 and 01: the same but for zeros
    throw InvalidInput(
        {.file = what,
         .text = names[0] + " and " + names[1] + " have the same number; move one of them away"});
  }
  const std::vector<std::int64_t>& last = varying.back();
  if (!std::is_sorted(last.begin(), last.end())) return std::nullopt;
  if (varying.size() > 1 && std::adjacent_find(last.begin(), last.end()) != last.end()) {
    return std::nullopt;
  }
  return gaps_in(last, what);
}

}  // namespace isoloop
