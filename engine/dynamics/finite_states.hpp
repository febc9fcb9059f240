// Bodies whose state is no longer a finite number are taken out before they spoil others.
//
//   begin    what a step starts with: a state that somebody put in
//   check    what free motion made of it, before anybody is paired with it
//   check    what impulses made of it, at the end
//
// A body that is found not finite is put back to where it was when the step began, without
// momentum, and stays there for good: it moves no more, touches nobody and takes no part in any
// sum. Two bodies that are finite give each other finite impulses (kMostNumber, limits.hpp), so
// whoever was fine before the response is fine after it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "engine/dynamics/state_hash.hpp"

namespace impetus::inline dynamics {

/// A body that was taken out, and what of its state was not finite; the first of several.
struct NotFiniteBody {
  std::int32_t body{0};
  StateField field{StateField::kPosition};

  friend bool operator==(const NotFiniteBody&, const NotFiniteBody&) = default;
};

/// What of a state is no number, or beyond kMostNumber, or turns by no unit length; nothing when it
/// is as it should be.
std::optional<StateField> not_finite_field(const BodyState& state);

/// Who of a world is out, and where everybody was before the step.
class FiniteStates {
 public:
  /// All of `states` must be finite.
  explicit FiniteStates(const std::vector<BodyState>& states)
      : before_(states), is_out_(states.size(), 0) {}

  /// Takes out whom the step cannot begin with, adds them to `found`, and keeps the states.
  void begin(std::vector<BodyState>& states, std::vector<NotFiniteBody>& found);

  /// Takes the body out if its state is not finite, and adds it to `found`.
  void check(std::size_t body, BodyState& state, std::vector<NotFiniteBody>& found);

  /// Takes the body out because one that it cannot do without is.
  void take_out(std::size_t body, BodyState& state);

  [[nodiscard]] bool is_out(std::size_t body) const { return is_out_[body] != 0; }
  [[nodiscard]] bool any_out() const { return any_out_; }

  /// The states that the step began with.
  [[nodiscard]] const std::vector<BodyState>& before() const { return before_; }

 private:
  std::vector<BodyState> before_;
  std::vector<std::uint8_t> is_out_;
  bool any_out_{false};
};

}  // namespace impetus::inline dynamics
