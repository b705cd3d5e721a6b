// What somebody may have meant who typed a word that is none.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isoloop {

/// Letters to insert, leave out, replace or swap with the next one, at least, to make b of a.
std::size_t word_distance(std::string_view a, std::string_view b);

/// The word of `words` that begins with `typed` (three letters or more) or is nearest to it, a
/// third of its letters off at most; of several the first. Empty if there is none.
std::string nearest_word(std::string_view typed, std::span<const std::string> words);

}  // namespace isoloop
