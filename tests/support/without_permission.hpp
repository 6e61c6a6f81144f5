#pragma once

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace softwall::test {

/// For its lifetime this process may not open a file, as if that were another user's and for that one alone;
/// root becomes nobody for it.
class WithoutPermission {
 public:
  explicit WithoutPermission(std::filesystem::path file) : file_(std::move(file)), before_(geteuid()) {
    chmod(file_.c_str(), 0);
    if (before_ == 0 && seteuid(kNobody) != 0) throw std::runtime_error("root cannot become nobody");
  }
  ~WithoutPermission() {
    if (seteuid(before_) == 0) chmod(file_.c_str(), S_IRUSR | S_IWUSR);
  }
  WithoutPermission(const WithoutPermission&) = delete;
  WithoutPermission& operator=(const WithoutPermission&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  std::filesystem::path file_;
  uid_t before_;
};

}  // namespace softwall::test
