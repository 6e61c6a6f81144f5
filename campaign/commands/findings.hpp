#pragma once

#include <iostream>
#include <string>

namespace softwall::campaign {

/// Counts what `verify` has looked at, and tells what is wrong.
struct Findings {
  int checked = 0;
  int wrong = 0;
  void add(const std::string& what, const std::string& trouble) {
    ++checked;
    if (trouble.empty()) return;
    ++wrong;
    std::cout << "BAD  " << what << ": " << trouble << "\n";
  }
};

}  // namespace softwall::campaign
