// Sets of generators as numbers of 64 bits, for searches: a sum is one instruction.
#pragma once

#include <cstdint>
#include <span>

namespace isoloop {

/// The sum modulo 2 of a random number for each generator of a set. Equal sets have equal prints;
/// unequal ones differ but for one pair in 2^64. So what a print decides is looked at again by the
/// sets themselves before it is taken (Freivalds, MFCS 1979).
using ClassPrint = std::uint64_t;

/// splitmix64 of the generator: the same in every run.
constexpr ClassPrint print_of(std::uint32_t generator) {
  std::uint64_t x = (std::uint64_t{generator} + 1) * 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

constexpr ClassPrint print_of(std::span<const std::uint32_t> generators) {
  ClassPrint print = 0;
  for (const std::uint32_t generator : generators) print ^= print_of(generator);
  return print;
}

}  // namespace isoloop
