#include "solver/statistics/spectra.hpp"

#include "solver/statistics/interface_columns.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/interface_moments.hpp"
#include "solver/statistics/interface_pairs.hpp"
#include "solver/statistics/spectra_arrays.hpp"

namespace softwall::statistics {

namespace {

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

constexpr const char *kSchedule = "spectra_schedule", *kFlow = "spectra_of_flow",
                     *kBudget = "energy_budget_with_rates", *kBeforeBudget = "energy_before",
                     *kInterface = "interface_moments", *kPairs = "interface_pairs",
                     *kWaves = "interface_waves";

/// Whoever samples again begins a new interval of time, and of the rates of change: nobody looks meanwhile.
Spectra::Packed without_interval_under_way(Spectra::Packed packed) {
  if (const auto clock = packed.find(kSchedule); clock != packed.end()) {
    SampleClock paused;
    paused.unpack(clock->second);
    paused.pause();
    clock->second = copy(paused.pack());
  }
  packed.erase(kBeforeBudget);
  return packed;
}

}  // namespace

Spectra::Spectra(time::Setup& setup, std::int64_t interval_steps)
    : setup_(setup), interval_steps_(interval_steps) {
  if (interval_steps == 0 || is_closed_box(setup.physics.flow)) return;
  const auto& spec = setup.physics.statistics;
  const BlockSchedule shortest{spec.start_time, spec.block_length};
  flow_.emplace(setup.grid, setup.decomposition);
  of_flow_.emplace(shortest, flow_->part_size());
  if (is_driven_channel(setup.physics.flow)) {
    budget_.emplace(setup.grid);
    of_budget_.emplace(shortest, kBudgetKinds.size() * static_cast<std::size_t>(setup.grid.ny));
  }
  if (!setup.solid) return;
  of_interface_.emplace(shortest, kInterfaceMoments.size() + kHeightBins);
  of_pairs_.emplace(shortest, kPairValues);
  waves_.emplace(setup.grid);
}

void Spectra::sample_step(const time::State& s, double dt) {
  if (!flow_ || clock_.counted(s.time, dt, setup_.physics.statistics.start_time) == 0) return;
  const bool wave_is_due = waves_ && InterfaceModes::is_due(s, dt), is_due = s.step % interval_steps_ == 0;
  if (!wave_is_due && !is_due) return;
  std::vector<double> heights;
  if (s.elastic) heights = heights_of_interface(s.material, setup_.grid);
  if (wave_is_due) waves_->add(s, heights, setup_);
  if (is_due) sample_fields(s, clock_.take(s.time), heights);
}

void Spectra::sample_fields(const time::State& s, double weight, const std::vector<double>& heights) {
  of_flow_->add_sample(s.time, weight, flow_->part_of(s, heights, setup_.projection->poisson()));
  if (budget_) {
    if (const auto budget = budget_->sample(s, setup_, weight))
      of_budget_->add_sample(s.time, weight, *budget);
  }
  if (!of_interface_) return;
  const auto columns = interface_columns(s, heights, setup_);
  of_interface_->add_sample(s.time, weight, interface_sample(columns, setup_));
  of_pairs_->add_sample(s.time, weight, interface_pair_sample(columns, setup_));
}

Spectra::Packed Spectra::pack() const {
  if (!flow_) return on_hold_;
  Packed packed;
  packed[kSchedule] = copy(clock_.pack());
  packed[kFlow] = of_flow_->pack([this](std::span<const double> part) { return flow_->whole(part); });
  if (budget_) {
    packed[kBudget] = of_budget_->pack(copy);
    if (!budget_->before().empty()) packed[kBeforeBudget] = budget_->before();
  }
  if (of_interface_) packed[kInterface] = of_interface_->pack(copy);
  if (of_pairs_) packed[kPairs] = of_pairs_->pack(copy);
  if (waves_) packed[kWaves] = waves_->pack();
  return packed;
}

void Spectra::unpack(const Packed& packed) {
  const auto with = [&packed](const char* name, const auto& take) {
    if (const auto found = packed.find(name); found != packed.end()) take(found->second);
  };
  if (!flow_) {
    on_hold_ = without_interval_under_way(packed);
    return;
  }
  with(kSchedule, [this](std::span<const double> values) { clock_.unpack(values); });
  with(kFlow, [this](std::span<const double> values) {
    of_flow_->unpack(values, flow_->whole_size(),
                     [this](std::span<const double> whole) { return flow_->part(whole); });
  });
  const auto replicated = [&with](const char* name, std::optional<MergingBlocks>& blocks) {
    if (!blocks) return;
    with(name, [&](std::span<const double> values) { blocks->unpack(values, blocks->values(), copy); });
  };
  replicated(kBudget, of_budget_);
  if (budget_)
    with(kBeforeBudget, [this](std::span<const double> values) { budget_->continue_from(values); });
  replicated(kInterface, of_interface_);
  replicated(kPairs, of_pairs_);
  if (waves_) with(kWaves, [this](std::span<const double> values) { waves_->unpack(values); });
}

std::vector<analysis::NamedArray> Spectra::arrays() const {
  std::vector<analysis::NamedArray> arrays;
  if (!flow_) return arrays;
  const double last = clock_.last_sample();
  append_grid(setup_, arrays);
  append_spectra(*flow_, *of_flow_, last, setup_, arrays);
  if (of_budget_) append_budget(*of_budget_, last, setup_, arrays);
  if (of_interface_) append_interface(*of_interface_, last, setup_, arrays);
  if (of_pairs_) append_pairs(*of_pairs_, last, setup_, arrays);
  if (waves_) append_waves(*waves_, arrays);
  if (setup_.decomposition.all().rank() != 0) arrays.clear();
  return arrays;
}

}  // namespace softwall::statistics
