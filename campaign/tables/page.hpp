#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The page of text that `softwall table` writes.
namespace softwall::campaign {

inline constexpr std::size_t kPageWidth = 116;
inline constexpr std::size_t kFirstColumnWidth = 28;  ///< names of cases

using Row = std::vector<std::string>;

}  // namespace softwall::campaign
