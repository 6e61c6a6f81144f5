#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "campaign/runner/case_book.hpp"

namespace softwall::campaign {

/// What became of the campaign when its runner ended.
struct RunnerReport {
  struct Trouble {
    std::string label;
    std::string reason;
    std::string directory;  ///< of the case, relative to the campaign's folder
  };
  std::size_t cases = 0;
  std::size_t finished = 0;
  std::vector<Trouble> failed;      ///< will not be finished by running on
  std::vector<Trouble> unfinished;  ///< `softwall resume` goes on with them
  bool stopped = false;             ///< on the user's request
};

/// without_result: case id -> why a finished case has none.
[[nodiscard]] RunnerReport make_report(const CaseBook& book,
                                       const std::map<std::string, std::string>& without_result,
                                       bool stopped);

}  // namespace softwall::campaign
