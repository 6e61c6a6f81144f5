#include "solver/case/spelling.hpp"

#include <algorithm>
#include <cctype>

namespace softwall {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> before(columns), above(columns), row(columns);
  for (std::size_t j = 0; j < columns; ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < columns; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> suggestion(std::string_view given, const std::vector<std::string>& known) {
  constexpr std::size_t kLongestWord = 64;  // what is longer is no misspelling, and would cost time
  if (given.empty() || given.size() > kLongestWord) return std::nullopt;
  std::optional<std::string> best;
  int least = std::max<int>(2, static_cast<int>(given.size()) / 3) + 1;
  for (const auto& word : known) {
    const int distance = edit_distance(given, word);
    const bool some_letters_agree = distance < static_cast<int>(std::max(given.size(), word.size()));
    if (distance < least && some_letters_agree) {
      least = distance;
      best = word;
    }
  }
  return best;
}

}  // namespace softwall
