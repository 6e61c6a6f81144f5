#pragma once

#include <iosfwd>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// Tables 1 and 2 of Rosti & Brandt (2017) with the measured value and its 95 % interval beside each printed
/// one, for each reading of the paper's G (its tables say 4.0 to 0.5, its text 2.0 to 0.25), and how well
/// each reading fits. Plain text,
/// at most 120 columns. Throws SqliteError when the store cannot be read.
void write_paper_tables(std::ostream& out, Connection& store);

}  // namespace softwall::campaign
