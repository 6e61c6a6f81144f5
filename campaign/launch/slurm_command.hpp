#pragma once

#include <string>
#include <vector>

#include "campaign/launch/ask_program.hpp"

/// Slurm's own programs, as its users call them.
namespace softwall::campaign {

/// Runs sbatch, squeue, sacct or scancel of the PATH.
[[nodiscard]] Answer ask_slurm(const std::string& program, std::vector<std::string> arguments,
                               double seconds);

/// "--user=1000": of all jobs, ours.
[[nodiscard]] std::string of_this_user();

/// A text in one line, no longer than a user reads.
[[nodiscard]] std::string in_one_line(const std::string& text);
/// Why an answer is none, in the program's own words where it has any.
[[nodiscard]] std::string trouble_in(const Answer& answer, const std::string& program);

}  // namespace softwall::campaign
