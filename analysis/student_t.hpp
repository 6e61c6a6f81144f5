#pragma once

namespace softwall::analysis {

/// 97.5 % quantile of Student's t distribution, `degrees` >= 3, error below 0.004.
/// Abramowitz & Stegun, Handbook of Mathematical Functions, 26.7.5.
[[nodiscard]] double student_t_975(double degrees);

}  // namespace softwall::analysis
