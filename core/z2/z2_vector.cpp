#include "core/z2/z2_vector.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <iterator>

namespace isoloop {
namespace {

constexpr std::uint64_t bits_per_listed = 32;  // of the memory that an element of a list takes
constexpr std::size_t word_bits = 64;

}  // namespace

Z2Vector::Z2Vector(std::span<const std::uint32_t> ones) : list_(ones.begin(), ones.end()) {}

void Z2Vector::flip(std::uint32_t element) {
  if (element / word_bits >= bits_.size()) bits_.resize(element / word_bits + 1);
  bits_[element / word_bits] ^= std::uint64_t{1} << (element % word_bits);
}

void Z2Vector::become_bits() {
  bits_.resize(1);
  std::for_each(list_.rbegin(), list_.rend(), [&](std::uint32_t element) { flip(element); });
  list_.clear();
}

void Z2Vector::add_listed(std::span<const std::uint32_t> ones) {
  spare_.clear();
  std::set_symmetric_difference(list_.begin(), list_.end(), ones.begin(), ones.end(),
                                std::back_inserter(spare_));
  std::swap(list_, spare_);
  if (!list_.empty() && list_.size() * bits_per_listed > list_.back()) become_bits();
}

void Z2Vector::add(const Z2Vector& other) {
  if (is_list() && other.is_list()) {
    add_listed(other.list_);
    return;
  }
  // A list and bits come to a list only if the bits would have to grow by more words than the list
  // has elements.
  const GeneratorSet& list = is_list() ? list_ : other.list_;
  const std::size_t words = is_list() ? other.bits_.size() : bits_.size();
  if (!list.empty() && list.back() / word_bits >= words + list.size()) {
    if (!is_list()) {
      list_ = ones();
      bits_.clear();
    }
    add_listed(other.ones());
    return;
  }
  if (is_list()) become_bits();
  for (const std::uint32_t element : other.list_) flip(element);
  if (bits_.size() < other.bits_.size()) bits_.resize(other.bits_.size());
  for (std::size_t w = 0; w < other.bits_.size(); ++w) bits_[w] ^= other.bits_[w];
}

std::optional<std::uint32_t> Z2Vector::greatest_below(std::uint64_t bound) const {
  if (is_list()) {
    const auto at = std::lower_bound(list_.begin(), list_.end(), bound);
    if (at == list_.begin()) return std::nullopt;
    return *std::prev(at);
  }
  std::size_t w = static_cast<std::size_t>(bound / word_bits);
  std::uint64_t word = 0;
  if (w < bits_.size())
    word = bits_[w] & ((std::uint64_t{1} << (bound % word_bits)) - 1);
  else
    w = bits_.size();
  while (word == 0) {
    if (w == 0) return std::nullopt;
    word = bits_[--w];
  }
  return static_cast<std::uint32_t>(w * word_bits + std::bit_width(word) - 1);
}

std::optional<std::uint32_t> Z2Vector::greatest() const {
  return greatest_below(std::uint64_t{1} << 32);
}

GeneratorSet Z2Vector::ones() const {
  if (is_list()) return list_;
  GeneratorSet ones;
  for (std::size_t w = 0; w < bits_.size(); ++w)
    for (std::uint64_t word = bits_[w]; word != 0; word &= word - 1)
      ones.push_back(static_cast<std::uint32_t>(w * word_bits +
                                                static_cast<unsigned>(std::countr_zero(word))));
  return ones;
}

}  // namespace isoloop
