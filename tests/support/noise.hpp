#pragma once

#include <cstdint>

namespace softwall::support {

/// A number in [-1, 1) that depends on nothing but its arguments: random fields that are the same on any
/// ranks.
inline double noise(int seed, int i, int j, int k) {
  std::uint64_t z = 0x9e3779b97f4a7c15ULL;
  for (const int value : {seed, i, j, k}) {  // SplitMix64's finaliser after each
    z += static_cast<std::uint64_t>(value + 1000) * 0xd1b54a32d192ed03ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
  }
  return double(z >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace softwall::support
