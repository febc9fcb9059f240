// QUEST+ (Watson 2017): the next level is the one whose answer should leave the least entropy in
// the posterior over the candidates for the participant's psychometric function.
//
// What is expected to be left after a level is the entropy now − the information in its answer:
//
//   H(answer) − Σ posterior · H(answer | candidate)
//
// so one table of H(answer | candidate), made beforehand, replaces a posterior for every level and
// answer. Of equal levels the first is taken. Entropies are natural logarithms'.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "experiments/design/psychometric.hpp"

namespace impetus::inline design {

/// The chance of a positive answer to every level under every candidate.
class PsychometricTable {
 public:
  /// `places`: the levels on the scale. Both lists have an entry at least, and the function is
  /// defined for all of them.
  PsychometricTable(QuestPlus::Function function, QuestPlus::Scale scale,
                    const std::vector<double>& places,
                    std::vector<PsychometricParameters> candidates);

  [[nodiscard]] const std::vector<PsychometricParameters>& candidates() const {
    return candidates_;
  }
  [[nodiscard]] std::size_t level_count() const { return chances_.size() / candidates_.size(); }
  /// By candidate, in their order.
  [[nodiscard]] const double* chances(std::size_t level) const {
    return &chances_[level * candidates_.size()];
  }
  /// Entropy of the answer under each candidate.
  [[nodiscard]] const double* entropies(std::size_t level) const {
    return &entropies_[level * candidates_.size()];
  }

 private:
  std::vector<PsychometricParameters> candidates_;
  std::vector<double> chances_;
  std::vector<double> entropies_;
};

/// Every combination of the grids, the lapse rates varying fastest.
std::vector<PsychometricParameters> candidates_of(const QuestPlus& method);

/// The table of a method for a factor's levels.
std::shared_ptr<const PsychometricTable> table_of(const QuestPlus& method,
                                                  const std::vector<double>& levels);

/// What one track knows of the participant's function, and where it asks next.
class QuestPlusTrack {
 public:
  /// Begins with a uniform prior.
  explicit QuestPlusTrack(std::shared_ptr<const PsychometricTable> table);

  /// The level of the next trial.
  [[nodiscard]] std::size_t level() const;

  /// The answer to a trial at `level`. An answer that no candidate allows changes nothing.
  void answer(std::size_t level, bool positive);

  [[nodiscard]] PsychometricParameters mean() const;
  /// Of the first candidate of the greatest probability.
  [[nodiscard]] PsychometricParameters mode() const;
  [[nodiscard]] double threshold_sd() const;
  [[nodiscard]] double entropy() const;

  /// The posterior's mean, the threshold's standard deviation and the entropy, by name.
  [[nodiscard]] std::vector<FactorLevel> state() const;

 private:
  [[nodiscard]] double information(std::size_t level) const;

  std::shared_ptr<const PsychometricTable> table_;
  std::vector<double> posterior_;  ///< by candidate; adds up to 1
};

}  // namespace impetus::inline design
