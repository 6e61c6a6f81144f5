#include "campaign/system/own_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "solver/case/bad_input.hpp"

namespace softwall::campaign {

FileDescriptor open_own_file(const std::filesystem::path& file, int flags, mode_t mode) {
  FileDescriptor opened(open(file.c_str(), flags | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, mode));
  const int error = errno;
  struct stat status {};
  const bool other = opened && (fstat(opened.get(), &status) != 0 || !S_ISREG(status.st_mode));
  if (other || (!opened && (error == ELOOP || error == ENXIO || error == EISDIR))) {
    throw BadInput(file.string(),
                   {{"", "a link, a folder or a device", "a file that softwall has made: remove it"}});
  }
  if (!opened)
    throw std::system_error(error, std::generic_category(),
                            "cannot write in the campaign folder " + file.parent_path().string());
  return opened;
}

}  // namespace softwall::campaign
