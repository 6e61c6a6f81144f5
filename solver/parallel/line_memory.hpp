#pragma once

#include <cstddef>
#include <new>
#include <vector>

/// Memory that begins with a line of the cache, as vector instructions and FFTW like it; large pieces in huge
/// pages where the system grants them, which spares most misses of the address cache.
namespace softwall::parallel {

/// Bytes in a line of the cache.
inline constexpr std::size_t kLineBytes = 64;

/// Uninitialised; throws std::bad_alloc. To be freed with std::free.
[[nodiscard]] void* allocate_lines(std::size_t bytes);
/// Allocates zeros that may begin anywhere; a large piece costs only what is touched of it.
[[nodiscard]] void* allocate_untouched(std::size_t bytes);
void free_lines(void* memory) noexcept;

template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_lines(n * sizeof(T))); }
  void deallocate(T* memory, std::size_t) noexcept { free_lines(memory); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

/// A vector in such memory.
template <class T>
using LineVector = std::vector<T, LineAllocator<T>>;

/// The next length at which every row of an array of T begins a line like the first.
template <class T, class Count>
[[nodiscard]] constexpr Count whole_lines(Count n) {
  constexpr Count kLine = kLineBytes / sizeof(T);
  return (n + kLine - 1) / kLine * kLine;
}

}  // namespace softwall::parallel
