// A simulated participant who goes by one thing and one psychometric function, whatever is asked.
//
//   level of a factor, or a recorded truth ─x─> F, between guessing and lapsing ─> P(yes)
//
//   P(yes) = γ + (1 − γ − λ) F(t + effect · (x − t))     F: psychometric.hpp, or 1 − F where
//   falling
//
// Yes or no: as it says. Two intervals: as observer_kinds.hpp says, of F in each. A rating's
// distance from the scale's good end is binomial: each step is taken with P(yes). A click comes
// with P(yes), a reaction time after the first collision. t differs between participants by its
// spread. With `effect` 0 the answers depend on nothing, and are otherwise as they were. Where the
// gaze is followed it looks about as anybody does (usual_eye()), whatever it goes by.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/design/psychometric.hpp"
#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"
#include "experiments/observers/simulated_eye.hpp"

namespace impetus::inline observers {

const ObserverKind& psychometric_observer();

namespace {

// ---------------------------------------------------------------- what it may look at

/// Something that a trial shows, by name.
struct Truth {
  const char* name;
  const char* words;
  std::vector<std::string> settings;  ///< that change it: parts of JSON Pointers into the scene
  double (*value)(const AttemptRecord& shown, const StagedScene& scene);
};

double delay_ms(const AttemptRecord& shown, const StagedScene& /*scene*/) {
  return longest_delay_ms(shown);
}

double speed_deg_s(const AttemptRecord& shown, const StagedScene& scene) {
  const CollisionRecord* met = first_meeting(shown);
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  return met == nullptr ? 0.0 : met->report.approach_m_s / m_per_deg;
}

Vector3 velocity_of(const StagedScene& scene, std::int32_t body) {
  const auto index = static_cast<std::size_t>(body);
  return velocity(scene.world.models()[index], scene.world.states()[index]);
}

double turning_rad_s(const StagedScene& scene, std::int32_t body) {
  const auto index = static_cast<std::size_t>(body);
  return angular_velocity(scene.world.models()[index], scene.world.states()[index]).norm();
}

double spin_deg_s(const AttemptRecord& shown, const StagedScene& scene) {
  const CollisionRecord* met = first_meeting(shown);
  if (met == nullptr) {
    return 0.0;
  }
  const BodyPair& bodies = met->report.bodies;
  return degrees(0.5 * (turning_rad_s(scene, bodies.a) + turning_rad_s(scene, bodies.b)));
}

/// How the first two that met part at the end, and the contact's normal, from b to a.
struct Parting {
  Vector3 velocity_m_s{Vector3::Zero()};  ///< of a against b
  Vector3 normal{Vector3::Zero()};
  double approach_m_s{0.0};
};

Parting parting(const AttemptRecord& shown, const StagedScene& scene) {
  const CollisionRecord* met = first_meeting(shown);
  if (met == nullptr) {
    return {};
  }
  const BodyPair& bodies = met->report.bodies;
  return {velocity_of(scene, bodies.a) - velocity_of(scene, bodies.b),
          met->report.contact.touch.normal, met->report.approach_m_s};
}

double angle_deg(const AttemptRecord& shown, const StagedScene& scene) {
  const Parting of = parting(shown, scene);
  const double along = of.velocity_m_s.dot(of.normal);
  return of.velocity_m_s.norm() > 0.0
             ? degrees(std::atan2((of.velocity_m_s - along * of.normal).norm(), along))
             : 0.0;
}

double restitution(const AttemptRecord& shown, const StagedScene& scene) {
  const Parting of = parting(shown, scene);
  return of.approach_m_s > 0.0 ? of.velocity_m_s.dot(of.normal) / of.approach_m_s : 0.0;
}

const std::vector<Truth>& truths() {
  static const std::vector<Truth> all{
      {"gap_arcmin",
       "the widest gap between two bodies that collide, as seen, less its hidden share",
       {"level", "gap", "tree", "viewer", "at_deg", "schedule", "region", "budget", "shape"},
       widest_gap_arcmin},
      {"delay_ms", "the longest freeze at contact, as shown", {"contact_hold"}, delay_ms},
      {"speed_deg_s",
       "how fast the first two to meet close in",
       {"speed", "velocity"},
       speed_deg_s},
      {"spin_deg_s",
       "how fast the first two to meet turn at the end, mean",
       {"spin", "offset", "orientation", "friction", "restitution", "level", "speed"},
       spin_deg_s},
      {"angle_deg",
       "the angle, at the end, between how the first two to meet part and the normal of their "
       "contact",
       {"offset", "friction", "restitution", "level", "orientation", "spin"},
       angle_deg},
      {"restitution",
       "how fast the first two to meet part at the end, along the normal of their contact, by how "
       "fast they met",
       {"restitution", "friction", "offset", "spin"},
       restitution}};
  return all;
}

// ---------------------------------------------------------------- what it is made of

using Shape = std::pair<QuestPlus::Function, QuestPlus::Scale>;

const Names<Shape>& shapes() {
  using F = QuestPlus::Function;
  using S = QuestPlus::Scale;
  static const Names<Shape> names{{"normal", {F::kNormal, S::kLinear}},
                                  {"log-normal", {F::kNormal, S::kLog10}},
                                  {"weibull", {F::kWeibull, S::kLinear}}};
  return names;
}

/// What such a participant is made of.
struct PsychometricParameters : RatingParameters {
  double threshold{0.0};  ///< t, in the unit of what it looks at
  double slope{1.0};
  double threshold_sd{0.0};  ///< of t over participants
  double effect{1.0};        ///< 0: x makes no difference
  Shape shape{shapes().front().second};
  bool falling{false};
  std::string factor;
  std::string truth;
  std::vector<std::string> levels;
};

std::vector<ParameterEntry> psychometric_entries(PsychometricParameters& own) {
  return {
      {"threshold", -kAny, kAny, &own.threshold,
       "Where the function has its threshold, in the unit of what it looks at; of a normal "
       "function, half-way between guessing and lapsing."},
      {"slope", 1e-6, kAny, &own.slope,
       "How wide the function is: a standard deviation (normal; log-normal: of the decimal "
       "logarithm), or an exponent (weibull)."},
      {"guess_rate", 0.0, 1.0, &own.yes_guess_rate, "Yes where nothing is seen.", true},
      {"lapse_rate", 0.0, 1.0, &own.yes_miss_rate, "No where it is clearly seen.", true},
      {"threshold_sd", 0.0, kAny, &own.threshold_sd,
       "Spread of the threshold between participants.", true},
      {"effect", 0.0, 1.0, &own.effect,
       "What of the difference from the threshold counts; at 0 nothing makes a difference.", true},
      {"reaction_median_ms", 1.0, kAny, &own.reaction_median_ms,
       "From the question to the answer, or from the collision to the click; times are lognormal.",
       true},
      {"reaction_sigma_log", 0.0, kAny, &own.reaction_sigma_log,
       "Standard deviation of the natural logarithm of these times.", true}};
}

const Kind<PsychometricParameters>& settings() {
  using P = PsychometricParameters;
  std::vector<std::string> names;
  std::string words = "Or what was really shown, measured";
  for (const Truth& truth : truths()) {
    names.emplace_back(truth.name);
    words += (names.size() == 1 ? ": " : "; ") + names.back() + ", " + truth.words;
  }
  words += ".";
  static const Kind<P> kind = object<P>(
      "",
      {group<P>("of",
                {row("factor", &P::factor, text(), "The level of this factor of the protocol."),
                 row("levels", &P::levels, list(text(), {2, -1, true}),
                     "Where levels are words: all of them, from least to most; they count as 1, 2, "
                     "3."),
                 row("truth", &P::truth, one_of(names), words)},
                "What it looks at: a factor or a truth.")
           .in_every_file(),
       row("function", &P::shape, choice(shapes()), "The form of the curve; normal if left out."),
       row("falling", &P::falling, flag(), "The more there is, the rarer is yes.")});
  return kind;
}

Attention attention_of(const PsychometricParameters& own) {
  if (!own.factor.empty()) {
    return {"the factor " + own.factor, {}, own.factor, own.levels};
  }
  const auto looked_at = std::find_if(truths().begin(), truths().end(),
                                      [&](const Truth& truth) { return truth.name == own.truth; });
  return {looked_at->words, looked_at->settings};
}

std::shared_ptr<const RatingParameters> read_psychometric(const JsonDocument& document) {
  PsychometricParameters checked;  // the whole file is, before what it says is read
  read_numbers(document, psychometric_entries(checked), settings(), nullptr);
  auto own = std::make_shared<PsychometricParameters>(settings().read(document.value));
  read_numbers(document, psychometric_entries(*own), settings(), nullptr);
  if (own->factor.empty() == own->truth.empty()) {
    refuse(document, "/of",
           std::string("expected either \"factor\" or \"truth\", got ") +
               (own->factor.empty() ? "neither" : "both"));
  }
  if (own->yes_guess_rate + own->yes_miss_rate >= 1.0) {
    refuse(document, "/parameters/lapse_rate/value",
           "expected less than 1 together with guess_rate, got " +
               document.value["parameters"]["lapse_rate"]["value"].dump());
  }
  own->lapse_rate = own->yes_miss_rate;
  own->attention = attention_of(*own);
  return own;
}

// ---------------------------------------------------------------- how it answers

double number_of(const PsychometricParameters& /*own*/, double level) { return level; }
double number_of(const PsychometricParameters& /*own*/, bool level) { return level ? 1.0 : 0.0; }
double number_of(const PsychometricParameters& own, const std::string& level) {
  const auto place = std::find(own.levels.begin(), own.levels.end(), level);
  return 1.0 + static_cast<double>(place - own.levels.begin());
}

/// x; none in a scene without the factor.
std::optional<double> looked_at(const PsychometricParameters& own, const AttemptRecord& shown,
                                const StagedScene& scene) {
  for (const Truth& truth : truths()) {
    if (own.truth == truth.name) {
      return truth.value(shown, scene);
    }
  }
  if (const FactorLevel* level = find_level(scene.condition, own.factor)) {
    return std::visit([&](const auto& value) { return number_of(own, value); }, level->value);
  }
  return std::nullopt;
}

/// F, where nothing is guessed and nobody lapses; 0 below where it is defined. Without an x, that
/// of the threshold.
double share_at(const PsychometricParameters& own, const Traits& traits, std::optional<double> x) {
  const auto& [function, scale] = own.shape;
  const double threshold = own.threshold + own.threshold_sd * traits.threshold;
  const double level = own.threshold + own.effect * (x.value_or(own.threshold) - own.threshold);
  const bool counts = scale != QuestPlus::Scale::kLog10 || (level > 0.0 && threshold > 0.0);
  const bool defined = counts && is_defined(function, scale, level, threshold);
  const double share = defined ? positive_chance(function, scale, on_scale(scale, level),
                                                 {on_scale(scale, threshold), own.slope})
                               : 0.0;
  return own.falling ? 1.0 - share : share;
}

/// Of each number of steps away from the good end, each taken with P(yes).
std::vector<double> binomial_chances(double yes, std::size_t points) {
  std::vector<double> chances{1.0};
  while (chances.size() < points) {
    chances.push_back(0.0);
    for (std::size_t i = chances.size() - 1; i > 0; --i) {
      chances[i] = chances[i] * (1.0 - yes) + chances[i - 1] * yes;
    }
    chances[0] *= 1.0 - yes;
  }
  return chances;
}

AnswerModel psychometric_answers() {
  using P = PsychometricParameters;
  AnswerModel answers = answers_with<P, psychometric_entries>();
  answers.fitted = {"threshold", "slope", "guess_rate", "lapse_rate"};
  answers.spreads = {{"threshold_sd", &Traits::threshold}};
  answers.percept = [](const RatingParameters& parameters, const AttemptRecord& shown,
                       const StagedScene& scene) -> Percept {
    const std::optional<double> x = looked_at(static_cast<const P&>(parameters), shown, scene);
    return x ? Percept{*x} : Percept{};
  };
  answers.seen = [](const RatingParameters& parameters, const Traits& traits,
                    const Percept& percept) {
    return share_at(static_cast<const P&>(parameters), traits,
                    percept.empty() ? std::nullopt : std::optional(percept[0]));
  };
  answers.rating = [](const RatingParameters& parameters, const Traits& /*traits*/, double seen,
                      std::size_t steps, std::size_t points) {
    return binomial_chances(yes_chance(parameters, seen), points)[steps];
  };
  answers.settle = [](RatingParameters& parameters) {
    parameters.lapse_rate = parameters.yes_miss_rate;
  };
  return answers;
}

/// Goes by its function alone.
class PsychometricObserver final : public RatingObserver {
 public:
  PsychometricObserver(const PsychometricParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "psychometric"),
        own_(parameters),
        click_stream_(birth.seed, "observer/psychometric/clicks/" + birth.pseudonym),
        eye_(usual_eye(), birth.seed, birth.pseudonym, birth.flip_clock) {
    traits_.threshold = normal();
  }

  Answer ask(const Page& page) override {
    points_ = page.choices.size();
    return RatingObserver::ask(page);
  }

  std::vector<ClickRecord> take_clicks() override { return std::exchange(clicks_, {}); }
  Gaze* eye() override { return &eye_; }

  [[nodiscard]] std::vector<double> probabilities(double seen) const override {
    return binomial_chances(yes_probability(seen), points_);
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override {
    const double clearly = share_at(own_, traits_, looked_at(own_, shown, scene));
    draw_click(yes_probability(clearly), shown);
    return clearly;
  }

  void draw_click(double chance, const AttemptRecord& shown) {
    clicks_.clear();
    const bool clicked = click_stream_.uniform() < chance;
    const double after_ms =
        draw_lognormal(click_stream_, own_.reaction_median_ms, own_.reaction_sigma_log);
    if (!clicked || shown.frames.empty() || shown.collisions.empty()) {
      return;
    }
    const double at_s = shown.collisions.front().time_s + after_ms / 1e3;
    const std::int64_t at_ns = shown.onset_ns + std::llround(at_s * 1e9);
    if (at_ns <= shown.frames.back().flip.flipped_ns) {
      clicks_.push_back({"simulated", at_ns, 0});
    }
  }

  PsychometricParameters own_;
  RandomStream click_stream_;
  std::size_t points_{2};
  std::vector<ClickRecord> clicks_;
  SimulatedEye eye_;
};

}  // namespace

const ObserverKind& psychometric_observer() {
  static const ObserverKind kind{
      .name = "psychometric",
      .words =
          "Answers any question by the level of a factor, or by a truth of what was shown, "
          "through one psychometric function.",
      .attention = {"what its file names", {}},
      .clicks = true,
      .has_eye = true,
      .parameters = list_of<PsychometricParameters, psychometric_entries>(),
      .settings = settings(),
      .read = read_psychometric,
      .make = make_own<PsychometricParameters, PsychometricObserver>,
      .has_own_scale = true,
      .effect_is_of_all = true,
      .answers = psychometric_answers()};
  return kind;
}

}  // namespace impetus::inline observers
