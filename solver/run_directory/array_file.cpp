#include "solver/run_directory/array_file.hpp"

#include <map>
#include <stdexcept>

#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/file_seal.hpp"
#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::analysis {

void write_arrays(const std::filesystem::path& path, const std::string& case_id,
                  const std::vector<NamedArray>& arrays) {
  std::string sealed;
  try {
    const QuietHdf5 quiet;
    const Hdf5Id file = create_image();
    write_attribute(file.get(), "case_id", case_id);
    std::map<std::string, Hdf5Id> groups;
    for (const NamedArray& array : arrays) {
      auto group = groups.find(array.group);
      if (group == groups.end())
        group = groups.emplace(array.group, create_group(file.get(), array.group)).first;
      const std::vector<hsize_t> shape(array.shape.begin(), array.shape.end());
      const Hdf5Id dataset = write_dataset(group->second.get(), array.name, array.values, shape,
                                           array.exact ? H5T_IEEE_F64LE : H5T_IEEE_F32LE);
      write_attribute(dataset.get(), "unit", array.unit);
      write_attribute(dataset.get(), "description", array.description);
    }
    const std::string image = image_bytes(file);
    sealed = seal_for(image) + image;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("arrays for " + path.string() + ": " + error.what());
  }
  write_atomically(path, sealed);
}

}  // namespace softwall::analysis
