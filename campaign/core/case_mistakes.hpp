#pragma once

#include <map>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"

namespace softwall::campaign {

/// The mistakes of many cases, each told once with the cases it concerns: what is wrong in the common part of
/// a campaign is wrong in every case of it.
class CaseMistakes {
 public:
  /// `prefix` stands in front of each place: "/precursor: ".
  void add(const std::string& label, const std::string& prefix, std::vector<Mistake> mistakes);

  /// All of them. `cases`: how many were looked at; what is wrong in all names none.
  [[nodiscard]] std::vector<Mistake> all(std::size_t cases) const;
  /// Throws BadInput with them.
  void throw_if_any(const std::string& source, std::size_t cases) const;

 private:
  struct Told {
    Mistake mistake;
    std::vector<std::string> labels;
  };
  std::vector<Told> told_;                    ///< in the order they came
  std::map<std::string, std::size_t> index_;  ///< by the mistake's text
};

}  // namespace softwall::campaign
