#pragma once

#include <iosfwd>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// The paper's tables with our values below each of its rows, as two LaTeX tabulars for each reading of G;
/// needs no package. Throws SqliteError when the store cannot be read.
void write_latex_tables(std::ostream& out, Connection& store);

}  // namespace softwall::campaign
