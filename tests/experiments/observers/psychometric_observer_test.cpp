// The simulated participant who goes by any factor or truth, through one psychometric function.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::psychometric_observer_test {

json number(double value) { return {{"value", value}, {"unit", "1"}, {"source", "assumed"}}; }

/// Goes by the shipped study's delay: half-way at 100 ms.
json by_delay() {
  return {{"schema_version", 1},
          {"observer", "psychometric"},
          {"of", {{"factor", "delay_ms"}}},
          {"parameters",
           {{"threshold", number(100)},
            {"slope", number(50)},
            {"guess_rate", number(0.1)},
            {"lapse_rate", number(0.2)}}}};
}

ObserverFile made(const json& file) {
  const TemporaryFolder folder;
  return load_observer(folder.write("o.json", file.dump()).string(), "x");
}

std::string refused(const json& file) {
  const TemporaryFolder folder;
  const std::string path = folder.write("o.json", file.dump()).string();
  std::string sentence =
      refusal([&] { check_observer(Study().made(), load_observer(path, "protocols/x.json")); });
  const std::size_t at = sentence.find(path);
  return at == std::string::npos ? sentence : sentence.replace(at, path.size(), "o.json");
}

StagedScene scene_at(const Condition& condition) {
  StagedScene scene{World({}, {}, {}), {}, {}};
  scene.condition = condition;
  return scene;
}

/// Choices of 4,000 answers to one question after stimuli of these conditions.
std::vector<double> shares(const json& file, const std::string& response, std::size_t choices,
                           const std::vector<Condition>& shown) {
  constexpr int kAnswers = 4000;
  VirtualClock clock;
  const auto observer = make_observer(made(file), {1, "S01", clock, clock});
  Page page;
  page.response = response;
  page.choices.resize(choices);
  page.best_choice = choices - 1;
  std::vector<double> share(choices, 0.0);
  for (int i = 0; i < kAnswers; ++i) {
    std::int64_t interval = 0;
    for (const Condition& condition : shown) {
      AttemptRecord record;
      record.frames.resize(1);
      record.frames[0].interval = ++interval;
      observer->witnessed(record, scene_at(condition));
    }
    share[observer->ask(page).choice] += 1.0 / kAnswers;
  }
  return share;
}

double yes_share(const json& file, const LevelValue& level) {
  return shares(file, "yes_no", 2, {{{"delay_ms", level}}})[0];
}

constexpr double kFourErrors = 4.0 * 0.0079;  // √(.25 / 4000), at most

// P(yes) = γ + (1 − γ − λ) Φ((x − 100) / 50)
TEST(PsychometricObserver, SaysYesByTheLevelOfItsFactor) {
  EXPECT_NEAR(yes_share(by_delay(), 100.0), 0.1 + 0.7 * 0.5, kFourErrors);
  EXPECT_NEAR(yes_share(by_delay(), 150.0), 0.1 + 0.7 * 0.8413, kFourErrors);
  json falling = by_delay();
  falling["falling"] = true;
  EXPECT_NEAR(yes_share(falling, 150.0), 0.1 + 0.7 * 0.1587, kFourErrors);
}

// P(yes) = γ + (1 − γ − λ) (1 − exp(−(x / 100)^2))
TEST(PsychometricObserver, HasOtherFunctions) {
  json weibull = by_delay();
  weibull["function"] = "weibull";
  weibull["parameters"]["slope"] = number(2);
  EXPECT_NEAR(yes_share(weibull, 50.0), 0.1 + 0.7 * (1.0 - std::exp(-0.25)), kFourErrors);
  EXPECT_NEAR(yes_share(weibull, 0.0), 0.1, kFourErrors);
  json log_normal = by_delay();
  log_normal["function"] = "log-normal";
  log_normal["parameters"]["slope"] = number(1);
  EXPECT_NEAR(yes_share(log_normal, 1000.0), 0.1 + 0.7 * 0.8413, kFourErrors);
  EXPECT_NEAR(yes_share(log_normal, 0.0), 0.1, kFourErrors);
}

TEST(PsychometricObserver, CountsWordsInTheOrderOfItsFile) {
  json words = by_delay();
  words["of"]["levels"] = {"little", "much"};
  words["parameters"]["threshold"] = number(1.5);
  words["parameters"]["slope"] = number(0.5);
  EXPECT_NEAR(yes_share(words, std::string("little")), 0.1 + 0.7 * 0.1587, kFourErrors);
  EXPECT_NEAR(yes_share(words, std::string("much")), 0.1 + 0.7 * 0.8413, kFourErrors);
}

// On three points from the good end: (1 − p)², 2p(1 − p), p² with p = P(yes) = .45.
TEST(PsychometricObserver, RatesOnAnyScale) {
  const auto share = shares(by_delay(), "rating", 3, {{{"delay_ms", 100.0}}});
  EXPECT_NEAR(share[2], 0.55 * 0.55, kFourErrors);
  EXPECT_NEAR(share[1], 2.0 * 0.45 * 0.55, kFourErrors);
  EXPECT_NEAR(share[0], 0.45 * 0.45, kFourErrors);
}

// P(the first) = ½ + ½ (1 − λ) (F₁ − F₂)
TEST(PsychometricObserver, ChoosesTheIntervalInWhichThereIsMore) {
  const auto share =
      shares(by_delay(), "two_interval", 2, {{{"delay_ms", 1000.0}}, {{"delay_ms", 100.0}}});
  EXPECT_NEAR(share[0], 0.5 + 0.5 * 0.8 * 0.5, kFourErrors);
}

TEST(PsychometricObserver, WithoutItsEffectAnswersAsAtItsThreshold) {
  const auto without = without_effect(made(by_delay()), "answer");
  ASSERT_TRUE(without);
  EXPECT_NEAR(yes_share(without->document.value, 1000.0), 0.45, kFourErrors);
}

TEST(PsychometricObserver, GoesByWhatWasReallyShown) {
  json truth = by_delay();
  truth["of"] = {{"truth", "delay_ms"}};
  VirtualClock clock;
  const auto observer = make_observer(made(truth), {1, "S01", clock, clock});
  AttemptRecord record;
  record.frames.resize(1);
  record.frames[0].interval = 1;
  record.collisions.resize(1);
  record.collisions[0].report.imposed_hold_s = 0.15;
  observer->witnessed(record, scene_at({{"delay_ms", 0.0}}));
  EXPECT_NEAR(observer->clearest(), 0.8413, 1e-4);
}

TEST(PsychometricObserver, RefusesWhatItCannotGoBy) {
  EXPECT_EQ(refused(by_delay()), "accepted");
  json other = by_delay();
  other["of"]["factor"] = "restitution";
  EXPECT_EQ(refused(other),
            "o.json:/of/factor: expected a factor of protocols/causality.json (delay_ms, "
            "speed_deg_s, viewpoint_deg), got \"restitution\"");
  other["of"]["truth"] = "spin_deg_s";
  EXPECT_EQ(refused(other), "o.json:/of: expected either \"factor\" or \"truth\", got both");
  other["of"] = json::object();
  EXPECT_EQ(refused(other), "o.json:/of: expected either \"factor\" or \"truth\", got neither");
  other["of"] = {{"truth", "luck"}};
  EXPECT_EQ(refused(other),
            "o.json:/of/truth: expected one of \"gap_arcmin\", \"delay_ms\", \"speed_deg_s\", "
            "\"spin_deg_s\", \"angle_deg\", \"restitution\", got \"luck\"");
  json rates = by_delay();
  rates["parameters"]["guess_rate"] = number(0.8);
  EXPECT_EQ(refused(rates),
            "o.json:/parameters/lapse_rate/value: expected less than 1 together with guess_rate, "
            "got 0.2");
}

TEST(UnseenFactors, AreToldOfWithWhatTheParticipantLooksAt) {
  const Protocol protocol = Study().made();
  const std::string causality = source_file("experiments/observers/causality.json").string();
  EXPECT_EQ(unseen_factors(protocol, load_observer(causality, "x")), "");
  EXPECT_EQ(unseen_factors(protocol, made(by_delay())), "");
  json by_angle = by_delay();
  by_angle["of"] = {{"truth", "angle_deg"}};
  ObserverFile observer = made(by_angle);
  observer.document.name = "o.json";
  EXPECT_EQ(unseen_factors(protocol, observer),
            "the simulated participant o.json looks at the angle, at the end, between how the "
            "first two to meet part and the normal of their contact, which no factor that varies "
            "changes (delay_ms, speed_deg_s, viewpoint_deg): its answers will not depend on them");
}

}  // namespace impetus::psychometric_observer_test
