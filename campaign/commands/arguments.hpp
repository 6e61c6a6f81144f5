#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/commands/commands.hpp"

namespace softwall::campaign {

/// What was given after the name of a command.
struct Arguments {
  std::filesystem::path path, file;
  std::string sql, chosen;
  bool json = false, csv = false, latex = false, vertical = false, watch = false, remove = false,
       no_caption = false, why = false;
  std::string picture = "png", style = "screen", shell;
  std::optional<double> from;
  RunOptions run;
  [[nodiscard]] OutputFormat format() const {
    return json       ? OutputFormat::kJson
           : csv      ? OutputFormat::kCsv
           : latex    ? OutputFormat::kLatex
           : vertical ? OutputFormat::kVertical
                      : OutputFormat::kText;
  }
  [[nodiscard]] WantedResults results() const { return {path, from}; }
  [[nodiscard]] std::optional<std::filesystem::path> output() const {
    return file.empty() ? std::nullopt : std::optional(file);
  }
};

}  // namespace softwall::campaign
