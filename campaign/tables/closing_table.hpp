#pragma once

#include <iosfwd>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// Writes the table that a run ends with: one line a case, its window and its main results with 95 %
/// intervals, units in the heading. Throws SqliteError when the store cannot be read.
void write_closing_table(std::ostream& out, Connection& store);

}  // namespace softwall::campaign
