#include "solver/parallel/line_memory.hpp"

#include <cstdlib>

#include <sys/mman.h>

namespace softwall::parallel {

void* allocate_lines(std::size_t bytes) {
  constexpr std::size_t kHugePage = std::size_t(2) << 20;
  const bool large = bytes >= 2 * kHugePage;
  void* memory = nullptr;
  if (posix_memalign(&memory, large ? kHugePage : kLineBytes, bytes) != 0) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (large) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: without it everything works, more slowly
#endif
  return memory;
}

void free_lines(void* memory) noexcept { std::free(memory); }

}  // namespace softwall::parallel
