#include "campaign/system/clock.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

namespace softwall::campaign {
namespace {

constexpr const char* kUnknown = "unknown";
constexpr double kLongestSeconds = 1000 * 365.25 * 86400;

}  // namespace

std::string local_time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm time{};
  localtime_r(&now, &time);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%H:%M:%S", &time);
  return text.data();
}

double monotonic_seconds() {
  // steady_clock is CLOCK_MONOTONIC: it does not count while the machine is suspended.
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string describe_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return kUnknown;
  if (seconds > kLongestSeconds) return "more than 1000 years";
  const auto total = static_cast<long long>(std::llround(seconds));
  if (total < 60) return std::to_string(total) + " s";
  const long long minutes = (total + 30) / 60;
  if (minutes < 60) return std::to_string(minutes) + " min";
  const long long hours = minutes / 60;
  if (hours < 48) return std::to_string(hours) + " h " + std::to_string(minutes % 60) + " min";
  return std::to_string(hours / 24) + " d " + std::to_string(hours % 24) + " h";
}

std::string describe_about(double seconds) {
  const std::string duration = describe_duration(seconds);
  if (duration == kUnknown) return "an unknown time";
  const bool is_number = duration.front() >= '0' && duration.front() <= '9';
  return is_number ? "about " + duration : duration;
}

}  // namespace softwall::campaign
