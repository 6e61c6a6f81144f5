#include "tests/restart/solver_run.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include "solver/run_directory/checkpoint_header.hpp"

namespace softwall::support {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json small_case(int steps) {
  return {{"format", 1},
          {"physics",
           {{"reynolds", 500},
            {"domain", {{"length_x", 3}, {"length_z", 1.5}}},
            {"grid", {{"nx", 13}, {"ny_fluid", 16}, {"nz", 14}}},
            {"time_step", {{"fixed_dt", 0.01}}},
            {"initial", {{"amplitude", 0.3}}},
            {"statistics", {{"interval_steps", 3}, {"block_length", 0.07}}}}},
          // Half a step less, so that round-off in the sum of steps cannot add one.
          {"run", {{"end_time", 0.01 * steps - 0.005}, {"checkpoint_seconds", 0}, {"spectra_steps", 2}}}};
}

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

json rigid_case(int steps) {
  json c = small_case(steps);
  c["physics"]["flow"] = "rigid_channel";
  return c;
}

json elastic_case(int steps) {
  json c = small_case(steps);
  c["physics"]["flow"] = "elastic_wall";
  c["physics"]["grid"]["ny_solid"] = 4;
  c["physics"]["solid"] = {{"G", 0.5}, {"viscosity_ratio", 0.5}, {"formulation", "transported_B"}};
  return c;
}

json reference_map_case(int steps) {
  json c = elastic_case(steps);
  c["physics"]["solid"]["formulation"] = "reference_map";
  return c;
}

json wave_case(int steps) {
  json c = reference_map_case(steps);
  c["physics"]["flow"] = "interface_wave";
  c["physics"]["grid"]["nz"] = 1;
  c["physics"]["wave"] = {{"decay", 0.112106670118}, {"frequency", 2.55844047078}, {"displacement", 0.01}};
  return c;
}

json driven_wave_case(int steps) {
  json c = wave_case(steps);
  c["physics"]["wave"]["mean_flow"] = "laminar";
  return c;
}

json filmed(json c, double interval) {
  c["run"]["plane_interval"] = interval;
  c["run"]["planes"] = {{"x", {1.5}}, {"y", {0, 1}}, {"z", {0.5}}};
  return c;
}

SolverRun::SolverRun() {
  std::string name = (fs::temp_directory_path() / "softwall-run-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) std::abort();
  files_.directory = name;
}

SolverRun::~SolverRun() {
  if (mpirun_ > 0) {
    ::kill(mpirun_, SIGKILL);
    ::waitpid(mpirun_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(files_.directory, ignored);
}

void SolverRun::write_case(const json& definition) const {
  std::ofstream(files_.case_file()) << definition.dump(2);
}

std::string SolverRun::command(int ranks, const std::string& options, const std::string& prelude) const {
  const std::string rank =
      prelude + "; exec '" + SOFTWALL_DNS + "' '" + files_.directory.string() + "' " + options;
  return std::string(SOFTWALL_MPIEXEC) + " -n " + std::to_string(ranks) + " --oversubscribe sh -c \"" + rank +
         "\" >'" + files_.log().string() + "' 2>&1";
}

Ended SolverRun::run(int ranks, const std::string& options, const std::string& prelude) const {
  const int status = std::system(command(ranks, options, prelude).c_str());
  return {exit_code(status), contents(files_.log())};
}

pid_t SolverRun::start(int ranks, const std::string& options) {
  mpirun_ = ::fork();
  if (mpirun_ == 0) {
    ::execl("/bin/sh", "sh", "-c", ("exec " + command(ranks, options)).c_str(), nullptr);
    ::_exit(127);
  }
  return mpirun_;
}

bool SolverRun::wait_for_step(std::int64_t step) const {
  using namespace std::chrono_literals;
  for (int n = 0; n < 6000; ++n, std::this_thread::sleep_for(10ms)) {
    const json status = json::parse(contents(files_.status()), nullptr, false);
    if (status.is_object() && status.at("step") >= step) return true;
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(mpirun_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid == mpirun_) return false;
  }
  return false;
}

Ended SolverRun::wait() {
  int status = 0;
  ::waitpid(mpirun_, &status, 0);
  mpirun_ = -1;
  return {exit_code(status), contents(files_.log())};
}

json SolverRun::summary() const { return json::parse(contents(files_.summary()), nullptr, false); }

fs::path SolverRun::newest_checkpoint() const {
  const auto ladder = checkpoint_ladder(files_);
  return ladder.empty() ? fs::path() : ladder.front();
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string checkpoint_data(const fs::path& file) {
  const std::string all = contents(file);
  return all.size() > kCheckpointHeaderBytes ? all.substr(kCheckpointHeaderBytes) : "";
}

void damage(const fs::path& file) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  const auto middle = static_cast<std::streamoff>(fs::file_size(file) / 2);
  stream.seekg(middle);
  const char byte = static_cast<char>(stream.get() ^ 1);
  stream.seekp(middle);
  stream.put(byte);
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

void expect_same_film(const SolverRun& a, const SolverRun& b, std::size_t moments) {
  const auto names = names_in(a.files().planes());
  EXPECT_EQ(names.size(), moments + 1) << "and their collection";
  EXPECT_EQ(names, names_in(b.files().planes()));
  for (const std::string& name : names)
    EXPECT_TRUE(contents(a.files().planes() / name) == contents(b.files().planes() / name)) << name;
}

void expect_same_results(const SolverRun& a, const SolverRun& b) {
  EXPECT_EQ(a.newest_checkpoint().filename(), b.newest_checkpoint().filename());
  EXPECT_TRUE(checkpoint_data(a.newest_checkpoint()) == checkpoint_data(b.newest_checkpoint()))
      << "final checkpoints differ";
  EXPECT_FALSE(checkpoint_data(a.newest_checkpoint()).empty());
  EXPECT_TRUE(contents(a.files().statistics()) == contents(b.files().statistics())) << "statistics differ";
  EXPECT_FALSE(contents(a.files().statistics()).empty());
  EXPECT_TRUE(contents(a.files().spectra()) == contents(b.files().spectra())) << "spectra differ";
  EXPECT_FALSE(contents(a.files().spectra()).empty());
}

}  // namespace softwall::support
