#pragma once

#include <optional>
#include <string>

#include "campaign/launch/ask_program.hpp"

/// What an answer of sbatch tells about the job that it was given.
namespace softwall::campaign {

/// Whether a refusal speaks of this hour and not of the campaign: nobody was reached, or what is asked for is
/// not there just now (a node that is down makes a job that needs it "not available").
[[nodiscard]] bool may_pass(const Answer& answer);

/// Whether the job may have been accepted although sbatch did not say so. A refusal has words of its own.
[[nodiscard]] bool is_doubtful(const Answer& answer);

/// The number of the job that was accepted, from "12" or, of one cluster among several, "12;name"; empty
/// where it is not said.
[[nodiscard]] std::optional<std::string> job_number_in(const Answer& answer);

}  // namespace softwall::campaign
