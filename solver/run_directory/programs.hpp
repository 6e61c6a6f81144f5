#pragma once

#include <filesystem>

#include "solver/case/case.hpp"

/// The solver is built once for each precision, side by side in one folder. Users and the manager start
/// softwall-dns, which replaces itself by the other one where a case asks for it.
namespace softwall {

/// The program of that precision in `folder`.
[[nodiscard]] std::filesystem::path solver_program(const std::filesystem::path& folder, Precision precision);

/// The folder of the program that runs now.
[[nodiscard]] std::filesystem::path folder_of_this_program();

}  // namespace softwall
