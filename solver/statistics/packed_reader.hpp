#pragma once

#include <span>
#include <stdexcept>

namespace softwall::statistics {

/// Reads numbers from the front of what a checkpoint holds. Throws std::runtime_error at the end of them.
class PackedReader {
 public:
  explicit PackedReader(std::span<const double> packed) : rest_(packed) {}
  double number() { return numbers(1)[0]; }
  std::span<const double> numbers(std::size_t n) {
    if (n > rest_.size()) throw std::runtime_error("statistics of a checkpoint end too early");
    const auto front = rest_.first(n);
    rest_ = rest_.subspan(n);
    return front;
  }
  void must_be_at_the_end() const {
    if (!rest_.empty()) throw std::runtime_error("statistics of a checkpoint are longer than they say");
  }

 private:
  std::span<const double> rest_;
};

}  // namespace softwall::statistics
