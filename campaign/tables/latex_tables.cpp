#include "campaign/tables/latex_tables.hpp"

#include <ostream>
#include <regex>
#include <span>
#include <string>

#include "campaign/tables/comparison.hpp"

namespace softwall::campaign {
namespace {

/// Text between cells: what LaTeX would read as a command is written out.
std::string latex_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\')
      safe += "\\textbackslash{}";
    else if (c == '~' || c == '^')
      safe += std::string("\\") + c + "{}";
    else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos)
      safe += std::string("\\") + c;
    else
      safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return safe;
}

/// "1.2e-09" as "1.2\cdot10^{-9}".
std::string with_powers_of_ten(const std::string& numbers) {
  static const std::regex exponent("e[+]?(-?)0*([0-9]+)");
  return std::regex_replace(numbers, exponent, "\\cdot10^{$1$2}");
}

/// "240.5 +- 3.2" as "$240.5 \pm 3.2$", "240.5 (*)" as "$240.5{}^{*}$".
std::string in_mathematics(const std::string& measured) {
  if (measured == "-") return "--";
  const auto sign = measured.find("+-");
  if (sign == std::string::npos)
    return "$" + with_powers_of_ten(measured.substr(0, measured.find(' '))) + "{}^{*}$";
  return "$" + with_powers_of_ten(measured.substr(0, sign) + "\\pm" + measured.substr(sign + 2)) + "$";
}

void write_cells(std::ostream& out, const std::string& name, std::span<const Quantity> quantities,
                 const auto& cell) {
  out << "  " << name;
  for (const Quantity& quantity : quantities) out << " & " << cell(quantity);
  out << " \\\\\n";
}

void write_tabular(std::ostream& out, const Reading& reading, std::span<const Quantity> quantities,
                   const std::vector<MeasuredCase>& cases) {
  out << "\\begin{tabular}{l" << std::string(quantities.size(), 'r') << "}\n\\hline\n";
  write_cells(out, "case", quantities,
              [](const Quantity& quantity) { return "$" + std::string(quantity.latex) + "$"; });
  out << "\\hline\n";
  for (const PaperCase& paper : paper_cases()) {
    write_cells(out, latex_text(paper.name) + " (paper)", quantities, [&](const Quantity& quantity) {
      const std::string printed = paper.digits(quantity.column);
      return printed.empty() ? std::string("--") : "$" + printed + "$";
    });
    for (const MeasuredCase& measured : cases) {
      if (!is_match(measured, paper, reading)) continue;
      const std::string state = measured.state == "finished" ? "" : " (" + measured.state + ")";
      write_cells(out, "\\quad " + latex_text(measured.label + state), quantities,
                  [&](const Quantity& quantity) {
                    return in_mathematics(measured_text(measured.value(quantity.column), quantity.decimals));
                  });
    }
  }
  out << "\\hline\n\\end{tabular}\n";
}

}  // namespace

void write_latex_tables(std::ostream& out, Connection& store) {
  const auto cases = measured_cases(store);
  out << "% Rosti & Brandt (2017), tables 1 and 2, and what was measured: value and half width of its 95 %\n"
         "% confidence interval; * marks a value without one. Lengths in h, velocities in U_b.\n";
  for (const Reading& reading : kReadings) {
    out << "\n% " << reading.title << "\n";
    write_tabular(out, reading, kTable1, cases);
    out << "\n";
    write_tabular(out, reading, kTable2, cases);
  }
}

}  // namespace softwall::campaign
