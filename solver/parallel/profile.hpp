#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Where the time of a run goes on one rank, and what it sends. Always on: a phase costs two readings of the
/// clock.
namespace softwall::parallel {

enum class Phase : std::size_t {
  kOther,
  kTransport,
  kMomentum,
  kPoisson,
  kCorrection,
  kHalo,
  kTransposition,
  kTimeStep,
  kStatistics,
  kOutput
};
inline constexpr std::size_t kPhases = 10;
inline constexpr std::array<const char*, kPhases> kPhaseNames{
    "other", "transport",     "momentum",  "poisson",    "correction",
    "halo",  "transposition", "time_step", "statistics", "output"};

/// What one phase has cost since the last reset.
struct PhaseRecord {
  double seconds = 0;            ///< by the clock on the wall, without the phases inside it
  double processor_seconds = 0;  ///< of this rank's processor; only counted when asked for
  std::int64_t messages = 0;     ///< to other ranks, or pieces of shared memory handed over to them
  std::int64_t bytes = 0;        ///< in them
};

class Profile {
 public:
  /// From construction to destruction the time belongs to a phase, unless to another one inside it.
  class Scope {
   public:
    Scope(Profile* profile, Phase phase) : profile_(profile) {
      if (profile_) before_ = profile_->enter(phase);
    }
    ~Scope() {
      if (profile_) profile_->enter(before_);
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Profile* profile_;
    Phase before_ = Phase::kOther;
  };

  Profile() { reset(); }
  /// Does `work` in a phase and returns what it returns.
  template <class Work>
  decltype(auto) time(Phase phase, const Work& work) {
    const Scope scope(this, phase);
    return work();
  }

  /// Begins again; `with_processor_time` also reads the processor's clock, which costs a system call.
  void reset(bool with_processor_time = false);
  /// The time until now is charged to the current phase before it is read.
  [[nodiscard]] std::array<PhaseRecord, kPhases> read();

  void count_messages(std::int64_t messages, std::size_t bytes) {
    records_[static_cast<std::size_t>(current_)].messages += messages;
    records_[static_cast<std::size_t>(current_)].bytes += static_cast<std::int64_t>(bytes);
  }

 private:
  Phase enter(Phase next);

  std::array<PhaseRecord, kPhases> records_{};
  Phase current_ = Phase::kOther;
  double since_ = 0, processor_since_ = 0;
  bool with_processor_time_ = false;
};

}  // namespace softwall::parallel
