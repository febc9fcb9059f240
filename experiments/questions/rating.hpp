// A rating on a scale with words at both ends, by key or mouse: what practice, the summary of a
// protocol and the check of a study have to know of it. (Dingliana 2002, sec. 6.2)
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

/// The points of a scale and the words at its ends.
struct RatingScale {
  std::int64_t minimum{1};
  std::int64_t maximum{3};
  std::int64_t best{1};  ///< which end is good: minimum or maximum
  std::string low_anchor;
  std::string high_anchor;

  /// Points of the scale.
  [[nodiscard]] std::int64_t points() const { return maximum - minimum + 1; }
  /// "“Very believable”", or where the point lies between the two anchors.
  [[nodiscard]] std::string meaning(std::int64_t rating, const Language& language) const;
  bool operator==(const RatingScale&) const = default;
};

/// It has a table of its own; only that the time was up is kept beside the other responses.
class RatingQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows();
  void check_block(const JsonDocument& protocol) const override;

  [[nodiscard]] const RatingScale& scale() const { return scale_; }
  [[nodiscard]] const ResponseKind& kind() const override;
  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override;
  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override;
  [[nodiscard]] Text feedback(const AttemptRecord& record, const Language& language) const override;
  [[nodiscard]] double timeout_ms() const override { return timeout_ms_; }
  [[nodiscard]] std::string explanation(const Words& words) const override;

 private:
  std::string question_;
  RatingScale scale_;
  double timeout_ms_{0.0};  ///< 0: none
};

/// The scale on which every trial of a script is rated; null: none is.
inline const RatingScale* find_scale(const Script& script) {
  const auto* rating = find_question<RatingQuestion>(script);
  return rating == nullptr ? nullptr : &rating->scale();
}

}  // namespace impetus::inline questions
