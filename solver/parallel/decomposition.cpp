#include "solver/parallel/decomposition.hpp"

#include <algorithm>
#include <string>

#include "solver/case/rank_sharing.hpp"

namespace softwall::parallel {

Range share(int n, int parts, int index) {
  const int base = n / parts, extra = n % parts;
  const int begin = index * base + (index < extra ? index : extra);
  return {begin, begin + base + (index < extra ? 1 : 0)};
}

std::vector<Range> shares(int n, int parts) {
  std::vector<Range> all;
  for (int index = 0; index < parts; ++index) all.push_back(share(n, parts, index));
  return all;
}

std::vector<Layout> possible_layouts(int ranks, int nx, int nz) {
  static_assert(Decomposition::kMinimumWidth == kNarrowestPart);
  std::vector<Layout> possible;
  for (int px = 1; px <= ranks; ++px) {
    const int pz = ranks / px;
    if (px * pz == ranks && can_be_shared(nx, px) && can_be_shared(nz, pz)) possible.push_back({px, pz});
  }
  return possible;
}

Decomposition::Decomposition(MPI_Comm comm, int nx, int nz, std::optional<Layout> layout)
    : all_(Communicator::duplicate(comm)) {
  const int ranks = all_.size(), rank = all_.rank();
  const auto possible = possible_layouts(ranks, nx, nz);
  const std::string grid = "a grid of " + std::to_string(nx) + " x " + std::to_string(nz) + " columns";
  if (possible.empty()) {
    throw std::invalid_argument(sharing_problem(ranks, nx, nz));
  }
  layout_ = layout.value_or(possible.front());
  if (std::find(possible.begin(), possible.end(), layout_) == possible.end()) {
    throw std::invalid_argument(grid + " cannot be shared as " + std::to_string(layout_.px) + " x " +
                                std::to_string(layout_.pz) + " parts among " + std::to_string(ranks) +
                                " ranks");
  }
  const int ix = rank % layout_.px, iz = rank / layout_.px;
  x_line_ = Communicator::split(all_.get(), iz, ix);
  z_line_ = Communicator::split(all_.get(), ix, iz);
  x_ = share(nx, layout_.px, ix);
  z_ = share(nz, layout_.pz, iz);
}

}  // namespace softwall::parallel
