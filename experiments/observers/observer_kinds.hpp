// The kinds of simulated participant. Each is one source file in this folder, which says what it is
// made of and what it sees, and one or more files of numbers beside it.
//
//   gap.json, "observer": "gap" ─> the kind ─read─> its parameters ─make─> a participant
//
// How all of them answer by what they saw:
//
// Rating: disbelief grows with it.
//
//   P(disbelief ≤ k) = logistic(cut_k − η),   η = baseline + (effect + s_i) · seen + u_i
//
//   disbelief   0     1     2     3     4        the distance from the scale's good end,
//   rating      1     2     3                    whichever end that is
//   or          5     4     3     2     1
//
// Yes or no: P(yes) = γ + (1 − γ − λ) · seen. Where the study's own `seen` has these rates in it,
// they are 0 here.
//
// Two intervals: P(the first) = ½ + ½ (1 − lapse rate) (seen₁ − seen₂). This is what guessing gives
// where something is seen in both intervals or in neither: with s₁ and s₂ the chances to see it,
// s₁(1 − s₂) + ½[s₁s₂ + (1 − s₁)(1 − s₂)] = ½ + ½(s₁ − s₂), the high-threshold observer (Green and
// Swets 1966). A lapse chooses either, so the asymptote is 1 − ½ lapse rate.
//
// Words are left out. An answer later than a page's time is not given. The kind `psychometric`,
// which goes by any factor or truth, answers every question by one function of its own.
//
// `seen`, from 0 to 1, is the study's own: what a derived observer makes of what was shown. u_i
// and s_i belong to the participant. With a small probability the participant lapses and answers
// anything. All parameters are data, each marked as taken from a source or assumed.
//
// A new kind is such a file and its line in observer_kinds.cpp: CONTRIBUTING.md shows one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/answer_model.hpp"
#include "experiments/observers/draws.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline observers {

/// What a simulated participant goes by, so that one who looks at nothing that varies is told of.
struct Attention {
  std::string words;                  ///< "the delay at contact"
  std::vector<std::string> settings;  ///< of a scene that change it: parts of their JSON Pointers
  std::string factor{};               ///< that is gone by whatever it sets; "": none
  std::vector<std::string> levels{};  ///< the words among its levels, from least to most
};

/// What every simulated participant is made of; each kind adds its own.
struct RatingParameters {
  double baseline{0.0};      ///< logits
  double effect{0.0};        ///< logits, of what was clearly seen
  double effect_sd{0.0};     ///< of s over participants, logits
  double intercept_sd{0.0};  ///< of u over participants, logits
  std::vector<double> cuts;  ///< between neighbouring points from the good end on; logits, rising
  double lapse_rate{0.0};
  double reaction_median_ms{500.0};
  double reaction_sigma_log{0.25};  ///< lognormal
  double yes_guess_rate{0.0};       ///< γ: yes where nothing was seen
  double yes_miss_rate{0.0};        ///< λ: no where it was clearly seen
  Attention attention{};            ///< a kind's, unless the file says it

  /// Points of the scales that can be answered on; 1 of a kind that rates on any.
  [[nodiscard]] std::size_t points() const { return cuts.size() + 1; }
};

/// What a participant is made of besides parameters: its traits and answers follow from `seed` and
/// `pseudonym`. Its answers advance `clock`; its eye, where it has one, lives by `flip_clock`, with
/// which flips are stamped. Both must outlive it, and may be the same.
struct Birth {
  std::uint64_t seed;
  const std::string& pseudonym;
  VirtualClock& clock;
  const Clock& flip_clock;
};

/// Judges what was shown and answers as the kind of each question says.
class RatingObserver : public Input, public Judge {
 public:
  /// A scale must have as many choices as there are points().
  Answer ask(const Page& page) override;
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override;

  /// Lapses included; they add up to 1.
  [[nodiscard]] std::vector<double> probabilities(double seen) const override;
  [[nodiscard]] double yes_probability(double seen) const override;
  [[nodiscard]] double first_probability(double seen_first, double seen_second) const override;
  [[nodiscard]] const std::vector<double>& seen_in_intervals() const override { return seen_; }
  double uniform() override { return stream_.uniform(); }

  /// The eye of an observer that has one; it lives as long as the observer.
  virtual Gaze* eye() { return nullptr; }

 protected:
  /// `study` sets its draws apart from those of other kinds with the same seed.
  RatingObserver(RatingParameters parameters, const Birth& birth, const std::string& study)
      : parameters_(std::move(parameters)),
        clock_(&birth.clock),
        stream_(birth.seed, "observer/" + study + "/" + birth.pseudonym) {}

  /// How clearly something wrong was seen in what was shown, from 0 to 1. Called once per trial,
  /// and once per interval where there are two.
  [[nodiscard]] virtual double seen(const AttemptRecord& shown, const StagedScene& scene) = 0;

  /// Draws the participant's intercept and slope; a derived constructor calls it once, after the
  /// traits of its own.
  void draw_traits();
  double normal() { return draw_normal(stream_); }

  Traits traits_;

 private:
  RatingParameters parameters_;
  VirtualClock* clock_;
  RandomStream stream_;
  std::vector<double> seen_{0.0};  ///< in each interval of the trial
};

/// A number that may be anything.
inline constexpr double kAny = 1e9;

/// One number of a file, the least and the greatest that it may be, where it goes, and what it is.
struct ParameterEntry {
  const char* name;
  double minimum;
  double maximum;
  double* place;
  const char* words;
  bool optional{false};  ///< left out, it stays what it is
};

/// What all participants of a kind have in common.
struct ObserverKind {
  std::string name;   ///< as its files call it
  std::string words;  ///< what it does, in one sentence
  Attention attention{};
  bool clicks{false};                        ///< whether it clicks during the stimulus
  bool has_eye{false};                       ///< whether its gaze can be followed
  std::vector<ParameterEntry> parameters{};  ///< their places are nobody's
  Form settings{};                           ///< what a file says beside its parameters
  /// Reads what a file of the kind gives; throws InputError as read_parameters() does.
  std::shared_ptr<const RatingParameters> (*read)(const JsonDocument& document){nullptr};
  /// The participant with what read() gave.
  std::unique_ptr<RatingObserver> (*make)(const RatingParameters& parameters,
                                          const Birth& birth){nullptr};
  bool has_own_scale{false};     ///< it has no cuts: it rates on any scale
  bool effect_is_of_all{false};  ///< `effect` 0 changes every kind of answer, not ratings alone
  AnswerModel answers{};         ///< of a kind that can be fitted; else without `percept`
};

/// All kinds, by name.
const std::vector<std::reference_wrapper<const ObserverKind>>& observer_kinds();

/// The kind of this name; null when there is none.
const ObserverKind* find_observer_kind(const std::string& name);

/// The kind that a file names. Throws InputError when there is no such kind.
const ObserverKind& named_kind(const JsonDocument& document);

/// The schema of all kinds' files together.
OrderedJson observer_file_schema();

/// A kind's own numbers and those of everybody who judges by how clearly something was seen.
std::vector<ParameterEntry> with_rating_entries(RatingParameters& rating,
                                                std::vector<ParameterEntry> own);

/// The same of a kind with a scale of its own: its numbers, then its lapses and the times of its
/// answers.
std::vector<ParameterEntry> with_answering_entries(RatingParameters& answering,
                                                   std::vector<ParameterEntry> own);

/// Reads these numbers, and the cuts between points where a file of the kind has them. Throws
/// InputError: an unknown number, one that is missing, out of its range or without its unit and
/// source; anything else that `settings` does not allow.
void read_numbers(const JsonDocument& document, const std::vector<ParameterEntry>& entries,
                  const Form& settings, std::vector<double>* cuts);

/// Lists the numbers of `Parameters` that a file gives.
template <typename Parameters>
using Lister = std::vector<ParameterEntry> (*)(Parameters&);

/// A lapse answers yes as often as no.
inline void answer_blindly_by_lapses(RatingParameters& parameters) {
  parameters.yes_guess_rate = 0.5 * parameters.lapse_rate;
  parameters.yes_miss_rate = 0.5 * parameters.lapse_rate;
}

/// The `parameters` and the read() of a kind with a scale of its own, made of `Parameters` with the
/// numbers that `entries` lists of them and no others; then `settle` makes those follow that follow
/// from them.
template <typename Parameters, Lister<Parameters> entries>
std::vector<ParameterEntry> list_of() {
  static Parameters nobody;
  return entries(nobody);
}
template <typename Parameters, Lister<Parameters> entries,
          void (*settle)(RatingParameters&) = nullptr>
std::shared_ptr<const RatingParameters> read_with(const JsonDocument& document) {
  auto parameters = std::make_shared<Parameters>();
  read_numbers(document, entries(*parameters), {}, nullptr);
  if constexpr (settle != nullptr) {
    settle(*parameters);
  }
  return parameters;
}

/// The same of a kind that rates on a scale with cuts: the numbers of all who do come after the
/// ones that `entries` lists.
template <typename Parameters, Lister<Parameters> entries>
std::vector<ParameterEntry> rating_entries(Parameters& parameters) {
  return with_rating_entries(parameters, entries(parameters));
}
template <typename Parameters, Lister<Parameters> entries>
std::vector<ParameterEntry> list_own() {
  return list_of<Parameters, rating_entries<Parameters, entries>>();
}
template <typename Parameters, Lister<Parameters> entries>
std::shared_ptr<const RatingParameters> read_own(const JsonDocument& document) {
  auto parameters = std::make_shared<Parameters>();
  read_numbers(document, rating_entries<Parameters, entries>(*parameters), {}, &parameters->cuts);
  return parameters;
}

/// The make() of a kind whose participants are of the class `Observer`.
template <typename Parameters, typename Observer>
std::unique_ptr<RatingObserver> make_own(const RatingParameters& parameters, const Birth& birth) {
  return std::make_unique<Observer>(static_cast<const Parameters&>(parameters), birth);
}

/// The kind's `answers`, as far as they follow from its numbers; it adds what it sees, and how it
/// answers by that.
template <typename Parameters, Lister<Parameters> list>
AnswerModel answers_with() {
  AnswerModel answers;
  answers.entries = [](RatingParameters& parameters) {
    return list(static_cast<Parameters&>(parameters));
  };
  answers.copy = [](const RatingParameters& parameters) -> std::shared_ptr<RatingParameters> {
    return std::make_shared<Parameters>(static_cast<const Parameters&>(parameters));
  };
  return answers;
}

/// The same of a kind that rates on a scale with cuts: it adds what it sees.
template <typename Parameters, Lister<Parameters> entries>
AnswerModel answers_of_own(std::vector<std::string> fitted, std::vector<TraitSpread> spreads) {
  AnswerModel answers = answers_with<Parameters, rating_entries<Parameters, entries>>();
  answers.fitted = std::move(fitted);
  answers.spreads = std::move(spreads);
  answers.spreads.push_back({"intercept_sd", &Traits::intercept});
  answers.spreads.push_back({"effect_sd", &Traits::slope});
  answers.rating = cumulative_rating;
  return answers;
}

/// A participant who sees what its kind's `answers` say, and draws nothing to see it.
class ModelledObserver : public RatingObserver {
 public:
  ModelledObserver(const ObserverKind& kind, const RatingParameters& parameters,
                   const Birth& birth);

 protected:
  /// Of the kind.
  [[nodiscard]] const RatingParameters& parameters() const { return *parameters_; }

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override {
    return answers_->seen(*parameters_, traits_, answers_->percept(*parameters_, shown, scene));
  }

  const AnswerModel* answers_;
  std::shared_ptr<const RatingParameters> parameters_;
};

/// The make() of a kind of such participants.
template <const ObserverKind& (*kind)(), typename Observer = ModelledObserver>
std::unique_ptr<RatingObserver> make_modelled(const RatingParameters& parameters,
                                              const Birth& birth) {
  return std::make_unique<Observer>(kind(), parameters, birth);
}

/// The number of a file that was read.
double number_in(const JsonDocument& document, const std::string& name);

}  // namespace impetus::inline observers
