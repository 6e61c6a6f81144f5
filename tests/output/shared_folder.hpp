#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "solver/output/agree.hpp"

namespace softwall::support {

/// A folder under the system's temporary one that all ranks of `comm` share; gone with its owner.
class SharedFolder {
 public:
  explicit SharedFolder(const parallel::Communicator& comm) : comm_(comm) {
    std::string name = (std::filesystem::temp_directory_path() / "softwall-output-XXXXXX").string();
    if (comm.rank() == 0 && ::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = output::from_root(comm, name);
  }
  ~SharedFolder() {
    MPI_Barrier(comm_.get());
    std::error_code ignored;
    if (comm_.rank() == 0) std::filesystem::remove_all(path_, ignored);
  }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  const parallel::Communicator& comm_;
  std::filesystem::path path_;
};

}  // namespace softwall::support
