#include "solver/parallel/line_memory.hpp"

#include <cstdlib>
#include <memory>

#include <sys/mman.h>

namespace softwall::parallel {

namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;

bool is_large(std::size_t bytes) { return bytes >= 2 * kHugePage; }

/// For whole pages; a wish: without it everything works, more slowly.
void want_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace

void* allocate_lines(std::size_t bytes) {
  void* memory = nullptr;
  if (posix_memalign(&memory, is_large(bytes) ? kHugePage : kLineBytes, bytes) != 0) throw std::bad_alloc();
  if (is_large(bytes)) want_huge_pages(memory, bytes);
  return memory;
}

void* allocate_untouched(std::size_t bytes) {
  void* const memory = std::calloc(bytes, 1);
  if (!memory) throw std::bad_alloc();
  void* first = memory;
  std::size_t space = bytes;
  if (is_large(bytes) && std::align(kHugePage, kHugePage, first, space))
    want_huge_pages(first, space / kHugePage * kHugePage);
  return memory;
}

void free_lines(void* memory) noexcept { std::free(memory); }

}  // namespace softwall::parallel
