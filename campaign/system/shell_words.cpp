#include "campaign/system/shell_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>

namespace softwall::campaign {
namespace {

bool is_plain(char c) {
  constexpr std::string_view kHarmless = "_@%+=:,./-";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || kHarmless.find(c) != std::string_view::npos;
}

bool is_control(char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }

std::string single_quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string escaped(const std::string& text) {
  std::string word = "$'";
  for (const char c : text) {
    std::array<char, 8> code{};
    std::snprintf(code.data(), code.size(), "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(c)));
    const bool as_code = is_control(c) || c == '\'' || c == '\\';
    word += as_code ? std::string(code.data()) : std::string(1, c);
  }
  return word + "'";
}

}  // namespace

std::string shell_word(const std::string& text) {
  return std::any_of(text.begin(), text.end(), is_control) ? escaped(text) : script_word(text);
}

std::string script_word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), is_plain);
  return plain ? text : single_quoted(text);
}

std::string softwall_command(const std::string& command, const std::filesystem::path& path) {
  return "softwall " + command + " " + shell_word(path.string());
}

}  // namespace softwall::campaign
