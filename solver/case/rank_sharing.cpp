#include "solver/case/rank_sharing.hpp"

namespace softwall {

std::string sharing_problem(int ranks, int nx, int nz) {
  for (int px = 1; px <= ranks; ++px) {
    const int pz = ranks / px;
    if (px * pz == ranks && can_be_shared(nx, px) && can_be_shared(nz, pz)) return "";
  }
  return "a grid of " + std::to_string(nx) + " x " + std::to_string(nz) + " columns cannot be shared among " +
         std::to_string(ranks) + " ranks: each needs at least " + std::to_string(kNarrowestPart) +
         " columns in every direction that is shared";
}

}  // namespace softwall
