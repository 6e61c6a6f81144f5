#include "campaign/tables/paper_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>
#include <span>

#include "analysis/log_law.hpp"
#include "campaign/core/words.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/tables/comparison.hpp"
#include "campaign/tables/grid_convergence.hpp"
#include "campaign/tables/page.hpp"
#include "campaign/tables/reading_fit.hpp"

/// The page: a preface, then for each reading of G both tables, then what the grid changes and how each case
/// was measured.
namespace softwall::campaign {

namespace {

/// Line breaks are made anew when it is written. The constant of the log law follows.
constexpr std::string_view kPreface = R"(
beside tables 1 and 2 of M. E. Rosti and L. Brandt, Numerical simulation of turbulent channel flow over a viscous
hyper-elastic wall, J. Fluid Mech. 830 (2017). The paper contradicts itself on G, so every case is shown beside its
values under each reading. Bulk Reynolds number 2800; lengths in h, velocities in U_b. "value +- half width" is a
95 % confidence interval; (*) marks a value without one, and the last section says why. Re_tau^w: rigid wall;
Re_tau: elastic wall; u_M, y_M: maximum of the mean velocity and its place, from the centre plane; delta, delta':
maximum and rms of the wall's deformation; d, k+Dk, DU+: log law at the elastic wall with the constant)";

std::string number_or_dash(std::optional<double> value) {
  if (!value) return "-";
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%g", *value);
  return buffer.data();
}

/// "G3         G=1     mu=10", in the manner of the labels.
std::string paper_name(const PaperCase& paper, const Reading& reading) {
  std::array<char, 64> buffer{};
  if (!paper.viscosity_ratio) {
    std::snprintf(buffer.data(), buffer.size(), "%-10s rigid walls", paper.name.c_str());
  } else {
    std::snprintf(buffer.data(), buffer.size(), "%-10s G=%-5s mu=%s", paper.name.c_str(),
                  number_or_dash(reading.modulus(paper)).c_str(),
                  number_or_dash(paper.viscosity_ratio).c_str());
  }
  return buffer.data();
}

Row paper_row(const PaperCase& paper, const Reading& reading, std::span<const Quantity> quantities) {
  Row row = {paper_name(paper, reading)};
  for (const Quantity& quantity : quantities) {
    const std::string printed = paper.digits(quantity.column);
    row.push_back(printed.empty() ? "-" : printed);
  }
  return row;
}

Row measured_row(const MeasuredCase& measured, std::span<const Quantity> quantities) {
  const std::string state = measured.state == "finished" ? "" : " (" + measured.state + ")";
  Row row = {shortened("  " + printable(measured.label), kFirstColumnWidth - state.size()) + state};
  for (const Quantity& quantity : quantities) {
    row.push_back(measured_text(measured.value(quantity.column), quantity.decimals));
  }
  return row;
}

void write_comparison(std::ostream& out, const Reading& reading, std::span<const Quantity> quantities,
                      const std::vector<MeasuredCase>& cases) {
  std::vector<Row> rows = {{"paper's case, then ours"}};
  std::vector<Column> columns = {{Alignment::kLeft, kFirstColumnWidth}};
  for (const Quantity& quantity : quantities) {
    rows[0].emplace_back(quantity.heading);
    columns.push_back({Alignment::kRight});
  }
  for (const PaperCase& paper : paper_cases()) {
    rows.push_back(paper_row(paper, reading, quantities));
    const std::size_t before = rows.size();
    for (const MeasuredCase& measured : cases) {
      if (is_match(measured, paper, reading)) rows.push_back(measured_row(measured, quantities));
    }
    if (rows.size() == before) rows.push_back({"  (not in this campaign)"});
  }
  write_aligned(out, rows, columns);
}

void write_reading(std::ostream& out, const Reading& reading, const std::vector<MeasuredCase>& cases) {
  out << "\n" << reading.title << "\n\nTable 1\n";
  write_comparison(out, reading, kTable1, cases);
  out << "\nTable 2\n";
  write_comparison(out, reading, kTable2, cases);
}

std::string words_of(const Departure& departure) {
  return number_or_dash(std::round(1e3 * departure.rms) / 1e3) + ", " + counted(departure.values, "value") +
         " of " + counted(departure.rows, "row");
}

/// Which of them the paper means is for the reader to judge; this only says how well each does.
void write_fits(std::ostream& out, const std::vector<MeasuredCase>& cases) {
  const std::vector<ReadingFit> fits = reading_fits(cases);
  const ReadingFit* best = best_of(fits);
  out << "\nHOW WELL EACH READING FITS\n"
      << wrapped(
             "rms of (measured - printed) over the range of the paper's seven cases, of Re_tau^w, Re_tau, "
             "u_M, y_M, delta and delta' of elastic walls, each on its finest grid. Intervals do not enter. "
             "Only rows "
             "with a result under every reading compare the readings",
             kPageWidth)
      << "\n";
  for (const ReadingFit& fit : fits) {
    out << "    " << fit.reading->name << ": ";
    if (fit.all.values == 0) {
      out << "no case with results\n";
      continue;
    }
    out << words_of(fit.all);
    if (best) out << "; over shared rows " << words_of(fit.shared) << (&fit == best ? ", the least" : "");
    out << "\n";
  }
  if (!best) out << "    no row has a result under every reading, so that nothing compares them\n";
}

void write_preface(std::ostream& out, const std::string& campaign) {
  const std::string title = "Campaign " + printable(campaign) + " " + std::string(kPreface);
  out << wrapped(title, kPageWidth) << " B = " << number_or_dash(analysis::kAdditiveConstant) << ".\n";
}

std::string window_text(const MeasuredCase& measured) {
  if (!measured.window_start)
    return measured.state == "finished" ? "no averages in the window that was asked for"
                                        : "nothing measured yet";
  return "mean over t = " + number_or_dash(measured.window_start) + " to " +
         number_or_dash(measured.window_end) + " of " + number_or_dash(measured.end_time) + " h/U_b";
}

void write_case_notes(std::ostream& out, const std::vector<MeasuredCase>& cases) {
  out << "\nHOW EACH CASE WAS MEASURED\n";
  for (const MeasuredCase& measured : cases) {
    std::string text = printable(measured.label) + ": " + measured.state + ", grid " + measured.grid + ", " +
                       window_text(measured);
    if (!measured.stale_reason.empty()) text += "; STALE: " + printable(measured.stale_reason);
    if (!has_counterpart(measured)) text += "; no counterpart in the paper";
    if (!measured.note.empty()) text += "; " + printable(measured.note);
    out << wrapped(text, kPageWidth, "    ") << "\n";
  }
}

}  // namespace

void write_paper_tables(std::ostream& out, Connection& store) {
  const std::vector<MeasuredCase> cases = measured_cases(store);
  Statement campaign = store.query("SELECT name FROM campaign");
  const std::string name = campaign.step() ? campaign.text(0) : store.file().string();
  if (!cases.empty() && std::none_of(cases.begin(), cases.end(), has_counterpart)) {
    out << wrapped("Campaign " + printable(name) + " has no case that the paper's tables show.", kPageWidth)
        << "\n";
  } else {
    write_preface(out, name);
    for (const Reading& reading : kReadings) write_reading(out, reading, cases);
    write_fits(out, cases);
  }
  write_grid_convergence(out, cases);
  write_case_notes(out, cases);
}

}  // namespace softwall::campaign
