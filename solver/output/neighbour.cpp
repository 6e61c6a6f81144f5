#include "solver/output/neighbour.hpp"

#include <string>

#include "solver/output/agree.hpp"
#include "solver/output/checkpoint_reader.hpp"
#include "solver/output/initial_checkpoint.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"

namespace softwall::output {
namespace {

/// An intact checkpoint that cannot be read into this case belongs to one of another kind.
void load_what_fits(const std::filesystem::path& checkpoint, const CheckpointHeader& header,
                    const time::Setup& setup, time::State& state) {
  try {
    static_cast<void>(load_checkpoint(checkpoint, header, setup, state));
  } catch (const AgreedError& error) {
    if (error.code != ExitCode::kCheckpointRefused) throw;
    throw AgreedError(ExitCode::kBadCase,
                      "a case starts from one of the same grid, precision and solid.formulation: " +
                          std::string(error.what()));
  }
}

}  // namespace

time::State start_from_neighbour(const std::filesystem::path& checkpoint, const InitialSpec& initial,
                                 time::Setup& setup) {
  const auto& all = setup.decomposition.all();
  agree_on_root(all, ExitCode::kCheckpointRefused,
                [&] { static_cast<void>(check_initial_checkpoint(checkpoint, initial)); });
  CheckpointHeader header;
  agree(all, ExitCode::kCheckpointRefused, [&] { header = read_checkpoint_header(checkpoint); });
  time::State state = time::state_at_rest(setup);
  load_what_fits(checkpoint, header, setup, state);
  state.time = 0;
  state.step = 0;
  time::start(state, setup);
  return state;
}

}  // namespace softwall::output
