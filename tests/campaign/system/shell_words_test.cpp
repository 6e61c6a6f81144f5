#include "campaign/system/shell_words.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

namespace softwall::campaign {
namespace {

/// What a shell makes of a word.
std::string read_by(const std::string& shell, const std::string& word) {
  const std::string inner = "printf %s " + word;
  std::string quoted = "'";
  for (const char c : inner) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  const std::unique_ptr<FILE, int (*)(FILE*)> out(popen((shell + " -c " + quoted + "'").c_str(), "r"),
                                                  pclose);
  std::string text;
  std::array<char, 256> part{};
  while (out && std::fgets(part.data(), part.size(), out.get()) != nullptr) text += part.data();
  return text;
}

TEST(ShellWord, IsReadAsTheSameText) {
  for (const std::string text :
       {"/data/runs", "/data/soft walls", "it's", "$(touch x)", "`x`", "a;b", "*", "~", "\"", "", "a\nb",
        "\033[31mred", "back\\slash", "back\\slash\n'", "-rf", "\xC3\xA4"}) {
    EXPECT_EQ(read_by("bash", shell_word(text)), text) << shell_word(text);
    EXPECT_EQ(read_by("sh", script_word(text)), text) << "by the shell that runs scripts";
  }
}

TEST(ShellWord, OfAPlainTextIsTheText) {
  EXPECT_EQ(softwall_command("resume", "/data/runs-1/a.json"), "softwall resume /data/runs-1/a.json");
  EXPECT_EQ(softwall_command("resume", "/data/soft walls"), "softwall resume '/data/soft walls'");
}

TEST(ShellWord, ShowsNothingRawToATerminal) {
  for (const char c : shell_word("a\n\033[31m\x7f")) EXPECT_GE(c, ' ');
}

}  // namespace
}  // namespace softwall::campaign
