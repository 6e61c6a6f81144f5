#include <cmath>
#include <iterator>
#include <stdexcept>

#include "solver/run_directory/file_seal.hpp"
#include "solver/run_directory/hdf5_image.hpp"
#include "solver/run_directory/statistics_checks.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "tests/fuzz/in_memory_file.hpp"

namespace {

using namespace softwall;
using analysis::Hdf5Id;

/// Takes numbers from the input; 0 when there is none left.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  [[nodiscard]] bool empty() const { return at_ == end_; }
  int below(int bound) { return empty() ? 0 : *at_++ % bound; }

 private:
  const std::uint8_t *at_, *end_;
};

constexpr double kValues[] = {0.0, 1.0, -1.0, 1e308, 5e-324, HUGE_VAL, -HUGE_VAL, NAN, 0.5, 2.0, 3.0};

std::vector<double> some_values(Input& input, hsize_t count) {
  std::vector<double> values;
  for (hsize_t n = 0; n < count; ++n)
    values.push_back(input.empty() ? double(n) : kValues[input.below(std::size(kValues))]);
  return values;
}

void write_group(const Hdf5Id& file, const char* name, std::initializer_list<const char*> members,
                 Input& input) {
  if (input.below(16) == 1) return;  // missing
  const Hdf5Id group = analysis::create_group(file.get(), name);
  for (const char* const member : members) {
    const int kind = input.below(8);
    if (kind == 1) continue;  // missing
    const hsize_t rows = hsize_t(input.below(5)), columns = hsize_t(input.below(5));
    const std::vector<hsize_t> shape =
        kind < 4 ? std::vector<hsize_t>{rows} : std::vector<hsize_t>{rows, columns};
    const Hdf5Id dataset = analysis::write_dataset(
        group.get(), member, some_values(input, kind < 4 ? rows : rows * columns), shape);
    const int attributes = input.below(8);
    if (attributes == 1) continue;
    analysis::write_attribute(dataset.get(), "unit", std::string("1"));
    if (attributes == 2) {
      analysis::write_attribute(dataset.get(), "location", 1.0);  // a number where a text belongs
    } else {
      analysis::write_attribute(dataset.get(), "location",
                                std::string(attributes == 3   ? "nowhere"
                                            : attributes >= 6 ? "face"
                                                              : "center"));
    }
    analysis::write_attribute(dataset.get(), "description", std::string("what"));
  }
}

/// A file with a right seal and the layout of statistics.h5, whose sizes and numbers are those of the input.
std::string sealed_image(Input& input) {
  const analysis::QuietHdf5 quiet;
  const Hdf5Id file = analysis::create_image();
  analysis::write_attribute(file.get(), "case_id", std::string("0123456789abcdef"));
  for (const char* const name : {"reynolds", "elastic", "interface_y"})
    analysis::write_attribute(file.get(), name, kValues[input.below(std::size(kValues))]);
  write_group(file, "grid", {"y_center", "y_face"}, input);
  write_group(file, "blocks", {"start", "end", "weight"}, input);
  write_group(file, "profiles", {"u", "uv"}, input);
  write_group(file, "series", {"driving_gradient"}, input);
  const std::string image = analysis::image_bytes(file);
  return analysis::seal_for(image) + image;
}

}  // namespace

/// statistics.h5: is refused, or holds statistics without mistakes that come back when written. A first byte
/// of 0 is followed by the file as it is, any other by what a well sealed file is made of: of changed bytes a
/// seal lets none through to HDF5.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string bytes;
  if (data[0] == 0 || data[0] == 's') {
    const std::size_t skipped = data[0] == 0 ? 1 : 0;  // the text of a seal begins with an s
    bytes.assign(reinterpret_cast<const char*>(data) + skipped, size - skipped);
  } else {
    Input input(data + 1, size - 1);
    bytes = sealed_image(input);
  }
  const fuzz::InMemoryFile file(bytes.data(), bytes.size());
  analysis::BlockStatistics read;
  try {
    read = analysis::read_statistics(file.path());
  } catch (const std::runtime_error&) {
    return 0;
  }
  fuzz::require(analysis::mistakes(read).empty(), "statistics with mistakes were accepted");
  return 0;
}
