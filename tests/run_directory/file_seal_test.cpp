#include "solver/run_directory/file_seal.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace softwall::analysis {
namespace {

TEST(FileSeal, OpensToWhatWasSealed) {
  const std::string contents = "any bytes \0 at all";
  const std::string seal = seal_for(contents);
  EXPECT_EQ(seal.size(), kSealBytes);
  EXPECT_EQ(seal.back(), '\n');
  EXPECT_EQ(open_seal(seal + contents), contents);
}

TEST(FileSeal, RefusesAnyChange) {
  const std::string contents(1000, 'x');
  const std::string good = seal_for(contents) + contents;
  EXPECT_THROW((void)open_seal(good + "x"), std::runtime_error);
  for (std::size_t length = 0; length < good.size(); length += 13) {
    EXPECT_THROW((void)open_seal(good.substr(0, length)), std::runtime_error) << length;
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 4);
    EXPECT_THROW((void)open_seal(bad), std::runtime_error) << at;
  }
}

}  // namespace
}  // namespace softwall::analysis
