// What collision detail each body has at a moment: the priority list and the level of its latest
// collision, for as long as that stays in view.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/world/step.hpp"

namespace impetus::inline run {

/// How long a collision, which may last a step, is told.
inline constexpr double kDetailInView_s = 0.25;

/// The detail in which a body's collisions were handled.
struct BodyDetail {
  int list{-1};   ///< the most urgent; −1: none
  int level{-1};  ///< the finest that its collisions reached; −1: none

  friend bool operator==(const BodyDetail&, const BodyDetail&) = default;
};

/// Remembers each body's latest collision while it is told.
class LatestDetail {
 public:
  LatestDetail(std::size_t bodies, double step_hz);

  /// Takes what the step told; steps come in order. Of several collisions of a body in one step the
  /// most urgent list and the finest level count.
  void take(std::int64_t step, const StepReport& report);

  /// Of a body, or of each, at a step: the last that was taken or a later one.
  [[nodiscard]] BodyDetail of(std::size_t body, std::int64_t step) const;
  [[nodiscard]] std::vector<BodyDetail> at(std::int64_t step) const;

 private:
  /// A body's latest collision.
  struct Collided {
    BodyDetail detail;
    std::int64_t step{-1};  ///< −1: not yet
  };

  void take(std::int64_t step, std::int32_t body, const BodyDetail& detail);

  std::int64_t steps_in_view_;
  std::vector<Collided> bodies_;
};

}  // namespace impetus::inline run
