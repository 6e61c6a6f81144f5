#include <gtest/gtest.h>

#include <unistd.h>

#include <array>

#include "solver/output/checkpoint_reader.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/restart/solver_run.hpp"

// physics.precision chooses the program: softwall-dns is started, and becomes the right one.
namespace softwall::support {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json in(const std::string& precision, json definition) {
  definition["physics"]["precision"] = precision;
  return definition;
}

/// An elastic case that begins with the last checkpoint of a rigid one.
json after(const SolverRun& precursor, json definition) {
  const auto file = precursor.newest_checkpoint();
  const CheckpointHeader header = read_checkpoint_header(file);
  definition["physics"]["initial"] = {
      {"type", "precursor"}, {"precursor", header.case_id}, {"precursor_time", header.time}};
  definition["run"]["initial_checkpoint"] = file.string();
  return definition;
}

std::vector<double> field(const fs::path& checkpoint, const std::string& name) {
  const output::CheckpointFile file(checkpoint);
  const auto [nz, rows, nx] = file.extents(name);
  static_cast<void>(rows);
  return file.columns(name, {0, nx, 0, nz});
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double top = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) top = std::fmax(top, std::abs(a[n] - b[n]));
  return top;
}

bool holds_only_floats(const std::vector<double>& values) {
  for (const double value : values)
    if (value != static_cast<float>(value)) return false;
  return true;
}

TEST(Precision, IsThatOfTheCheckpoint) {
  const SolverRun twice(in("double", elastic_case(20))), once(in("single", elastic_case(20)));
  ASSERT_EQ(twice.run(2).code, 0);
  const Ended ended = once.run(2);
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_NE(ended.output.find("in single precision"), std::string::npos) << ended.output;
  EXPECT_EQ(read_checkpoint_header(twice.newest_checkpoint()).precision, "double");
  EXPECT_EQ(read_checkpoint_header(once.newest_checkpoint()).precision, "single");
  const auto u = field(once.newest_checkpoint(), "fields/u"),
             exact = field(twice.newest_checkpoint(), "fields/u");
  EXPECT_TRUE(holds_only_floats(u));
  EXPECT_FALSE(holds_only_floats(exact));
  EXPECT_LT(largest_difference(u, exact), 1e-4);
  EXPECT_GT(largest_difference(u, exact), 0);
  EXPECT_LT(once.summary().at("diagnostics").at("max_divergence"), 1e-5);
  EXPECT_LT(std::abs(once.summary().at("diagnostics").at("solid_fraction_drift").get<double>()), 1e-6);
}

TEST(Precision, OfAPrecursorMayBeTheOther) {
  for (const auto& [first, second] : {std::pair("double", "single"), std::pair("single", "double")}) {
    const SolverRun precursor(in(first, rigid_case(10)));
    ASSERT_EQ(precursor.run(2).code, 0);
    SolverRun wall(after(precursor, in(second, elastic_case(10))));
    const Ended ended = wall.run(2);
    ASSERT_EQ(ended.code, 0) << ended.output;
    EXPECT_EQ(read_checkpoint_header(wall.newest_checkpoint()).precision, second);
  }
}

TEST(Precision, OfACheckpointMustFit) {
  const SolverRun twice(in("double", elastic_case(5))), once(in("single", elastic_case(5)));
  ASSERT_EQ(twice.run(1).code, 0);
  fs::create_directories(once.files().checkpoints());
  fs::copy_file(twice.newest_checkpoint(), once.files().checkpoint(5));
  EXPECT_EQ(once.run(1).code, 77);
}

TEST(Precision, NeedsTheProgramBesideTheOther) {
  const SolverRun run(in("single", rigid_case(5)));
  const fs::path alone = run.files().directory / "softwall-dns";
  fs::copy_file(SOFTWALL_DNS, alone);
  const std::string log = (run.files().directory / "log").string();
  const std::string command = std::string(SOFTWALL_MPIEXEC) + " -n 2 --oversubscribe " + alone.string() +
                              " " + run.files().directory.string() + " >" + log + " 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_NE(contents(log).find("cannot start " + alone.string() + "-single"), std::string::npos)
      << contents(log);
}

TEST(Precision, OfACaseIsFoundFromEitherProgram) {
  const SolverRun twice(in("double", rigid_case(5)));
  const std::string log = (twice.files().directory / "log").string();
  const std::string command = std::string(SOFTWALL_MPIEXEC) + " -n 2 --oversubscribe '" + SOFTWALL_DNS +
                              "-single' '" + twice.files().directory.string() + "' >'" + log + "' 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << contents(log);
  EXPECT_EQ(read_checkpoint_header(twice.newest_checkpoint()).precision, "double");
}

}  // namespace
}  // namespace softwall::support
