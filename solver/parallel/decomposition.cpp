#include "solver/parallel/decomposition.hpp"

#include <optional>
#include <string>

namespace softwall::parallel {

namespace {

/// The largest pz (fewest x parts, thus fewest transposes) whose parts are all wide enough.
std::optional<int> choose_pz(int ranks, int nx, int nz) {
  for (int pz = ranks; pz >= 1; --pz) {
    if (ranks % pz != 0) continue;
    const int px = ranks / pz;
    const auto wide_enough = [](int n, int parts) { return n / parts >= Decomposition::kMinimumWidth; };
    if (wide_enough(nz, pz) && wide_enough(nx, px)) return pz;
  }
  return std::nullopt;
}

}  // namespace

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

Decomposition::Decomposition(MPI_Comm comm, int nx, int nz) : all_(Communicator::duplicate(comm)) {
  const int ranks = all_.size(), rank = all_.rank();
  const auto pz = choose_pz(ranks, nx, nz);
  if (!pz) {
    throw std::invalid_argument("a grid of " + std::to_string(nx) + " x " + std::to_string(nz) +
                                " columns cannot be shared among " + std::to_string(ranks) +
                                " ranks: each needs at least " + std::to_string(kMinimumWidth) +
                                " columns in x and in z");
  }
  pz_ = *pz;
  px_ = ranks / pz_;
  const int ix = rank % px_, iz = rank / px_;
  x_line_ = Communicator::split(all_.get(), iz, ix);
  z_line_ = Communicator::split(all_.get(), ix, iz);
  x_ = share(nx, px_, ix);
  z_ = share(nz, pz_, iz);
}

}  // namespace softwall::parallel
