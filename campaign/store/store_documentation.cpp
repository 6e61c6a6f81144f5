#include "campaign/store/store_documentation.hpp"

#include <cctype>
#include <sstream>

namespace softwall::campaign {

namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1));
}

/// A name at the begin of a line of SQL; empty when the line begins otherwise.
std::string leading_name(std::string_view line) {
  std::string name;
  for (const char c : line) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') break;
    name += c;
  }
  return name;
}

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() ? second : first + " " + second;
}

class Reader {
 public:
  void read(const std::string& line);
  [[nodiscard]] std::vector<ColumnDocumentation> take() { return std::move(found_); }

 private:
  void read_outside(const std::string& line);
  void read_inside(const std::string& line);
  void read_derived(const std::string& line);

  std::vector<ColumnDocumentation> found_;
  std::string object_;   ///< table or view whose columns are being read; empty: outside
  std::string comment_;  ///< comment lines directly above
  std::string column_;   ///< last column whose definition has begun
};

void Reader::read(const std::string& line) {
  if (object_.empty()) {
    read_outside(line);
  } else {
    read_inside(line);
  }
}

void Reader::read_outside(const std::string& line) {
  if (line.starts_with("--")) {
    comment_ = joined(comment_, trimmed(std::string_view(line).substr(2)));
    return;
  }
  for (const std::string_view create : {"CREATE TABLE ", "CREATE VIEW "}) {
    if (!line.starts_with(create)) continue;
    object_ = leading_name(std::string_view(line).substr(create.size()));
    found_.push_back({object_, "", "-", comment_});
    if (line.ends_with(";")) read_derived(line);
  }
  comment_.clear();
}

/// "CREATE VIEW a AS SELECT * FROM b ...": the columns of b, and what they mean.
void Reader::read_derived(const std::string& line) {
  constexpr std::string_view kFrom = " AS SELECT * FROM ";
  const std::size_t from = line.find(kFrom);
  const std::string source =
      from == std::string::npos ? "" : leading_name(std::string_view(line).substr(from + kFrom.size()));
  const std::vector<ColumnDocumentation> known = found_;
  for (const ColumnDocumentation& entry : known) {
    if (entry.object == source && !entry.column.empty())
      found_.push_back({object_, entry.column, entry.unit, entry.meaning});
  }
  object_.clear();
}

void Reader::read_inside(const std::string& line) {
  if (line.starts_with(")")) {
    object_.clear();
    return;
  }
  if (line.starts_with("--")) {
    found_.back().meaning = joined(found_.back().meaning, trimmed(std::string_view(line).substr(2)));
    return;
  }
  if (const std::string name = leading_name(line); !name.empty()) column_ = name;
  const std::size_t begin = line.find("-- [");
  const std::size_t end = line.find("] ", begin);
  if (begin == std::string::npos || end == std::string::npos) return;
  found_.push_back({object_, column_, line.substr(begin + 4, end - begin - 4),
                    trimmed(std::string_view(line).substr(end + 2))});
}

}  // namespace

std::vector<ColumnDocumentation> documentation_in(std::string_view sql) {
  std::istringstream lines{std::string(sql)};
  Reader reader;
  for (std::string line; std::getline(lines, line);) reader.read(trimmed(line));
  return reader.take();
}

}  // namespace softwall::campaign
