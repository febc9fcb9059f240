// What a kind of response declares is what the study file keeps and what a simulated participant
// does.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/protocol/observer_file.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::response_kinds_test {

constexpr const char* kSharedTable = "response";

std::vector<std::string> sorted_names(const std::vector<DeclaredValue>& values) {
  std::vector<std::string> names;
  for (const DeclaredValue& value : values) {
    EXPECT_FALSE(value.meaning.empty()) << value.name;
    names.push_back(value.name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(ResponseKinds, ColumnsAreThoseOfTheStudyFilesTables) {
  const TemporaryFolder folder;
  StudyFile study = opened(folder / "a.sqlite");
  for (const ResponseKind& kind : response_kinds()) {
    if (kind.table == kSharedTable) {
      continue;
    }
    SQLite::Statement query(study.database(),
                            "SELECT name FROM pragma_table_info(?) WHERE name <> 'attempt_id' "
                            "ORDER BY name");
    query.bind(1, kind.table);
    std::vector<std::string> columns;
    while (query.executeStep()) {
      columns.push_back(query.getColumn(0).getString());
    }
    EXPECT_EQ(sorted_names(kind.recorded), columns) << kind.name;
  }
}

TEST(ResponseKinds, DetailsAreThoseThatARecordHas) {
  const std::vector<std::string> questions{kAskYesNo, kAskTwoInterval, kAskChoice, kAskSlider,
                                           kAskFreeText};
  TestLab lab(60.0, asked(questions));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(300), 0);
  for (const ResponseKind& kind : response_kinds()) {
    if (kind.table != kSharedTable) {
      continue;
    }
    const ResponseRecord* response = response_to(kind.name, record);
    ASSERT_NE(response, nullptr) << kind.name;
    std::vector<std::string> names;
    for (const FactorLevel& detail : response->detail) {
      names.push_back(detail.factor);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, sorted_names(kind.recorded)) << kind.name;
  }
}

TEST(ResponseKinds, EveryKindIsSimulatedByTheGazeContingentParticipant) {
  json document = json::parse(shipped("protocols/gaze-contingent.json"));
  document.merge_patch(json::parse(R"({"yes_no": {"question": "?"}, "free_text": {"question": "?"},
    "slider": {"scales": [{"question": "?", "minimum": 0, "maximum": 9, "words": ["a", "b"]}]},
    "choice": {"question": "?", "options": ["a", "b", "c"]},
    "two_interval": {"question": "?", "standard": {"scheduling": "all-good"}}})"));
  const Protocol protocol =
      make_protocol(parse_json(source_file("protocols/gaze-contingent.json"), document.dump()),
                    parse_json("cube.json", shipped("stimuli/l-blocks-in-a-cube.json")));
  const ObserverFile file = load_observer("gaze-contingent", protocol.document.name);
  EXPECT_NO_THROW(check_observer(protocol, file));
  TestLab lab(60.0, protocol);
  const auto observer = make_observer(file, {1, "S01", lab.clock, lab.clock});
  PlannedTrial bad;
  bad.condition = {{"scheduling", std::string("all-bad")}, {"bodies", 5.0}};
  const Ports ports{lab.display,     *observer,  lab.scenes, lab.recorder,
                    observer->eye(), &lab.clock, &lab.clock};
  const AttemptRecord record = run_attempt(bad, 1, protocol.script, {}, ports).record;
  ASSERT_EQ(protocol.script.asked.size(), response_kinds().size());
  EXPECT_GT(record.clicks.size(), 0U);
  EXPECT_EQ(record.clicks.front().device, "simulated");
  EXPECT_EQ(record.ratings.size(), 1U);
  EXPECT_EQ(record.responses.size(), 5U);
  EXPECT_GT(record.gaze.size(), 2000U);  // twice 10 s at 250 Hz
}

/// Means a quarter of the way between nothing and everything, and halfway to the contrary.
class SteadyJudge final : public Judge {
 public:
  [[nodiscard]] const std::vector<double>& seen_in_intervals() const override { return seen_; }
  [[nodiscard]] std::vector<double> probabilities(double /*seen*/) const override { return {}; }
  [[nodiscard]] double yes_probability(double /*seen*/) const override { return 0.0; }
  [[nodiscard]] double first_probability(double /*first*/, double /*second*/) const override {
    return 0.0;
  }
  double mark() override { return 0.25; }
  double two_sided_mark() override { return -0.5; }
  double uniform() override { return 0.0; }

 private:
  std::vector<double> seen_{0.25};
};

TEST(ResponseKinds, ASimulatedMarkIsAShareOfItsWholeLine) {
  const auto& kinds = response_kinds();
  const auto slider = std::find_if(kinds.begin(), kinds.end(),
                                   [](const ResponseKind& kind) { return kind.name == "slider"; });
  ASSERT_NE(slider, kinds.end());
  const auto marked = [&](double minimum, double maximum) {
    Page page;
    page.fields = {{"slider", "", Field::Kind::kSlider, {"a", "b"}, minimum, maximum}};
    Answer answer;
    answer.fields = {""};
    SteadyJudge judge;
    slider->get().simulate(page, judge, answer);
    return answer.fields.front();
  };
  EXPECT_EQ(marked(0, 100), "25");
  EXPECT_EQ(marked(20, 100), "40");
  EXPECT_EQ(marked(-100, 100), "-50");
  EXPECT_EQ(marked(-40, 200), "20");
}

TEST(ResponseKinds, AnObserverThatCannotDoWhatIsAskedIsRefused) {
  json document = json::parse(shipped("protocols/gaze-contingent.json"));
  document["rating"]["maximum"] = 3;
  document["rating"]["best"] = 3;
  const auto refused = [&](const char* without) {
    json changed = document;
    changed.erase(without);
    changed["design"]["factors"][0]["levels"] = {"all-good", "all-bad", "random"};
    changed["design"]["practice"].erase(2);
    return refusal([&] {
      const Protocol protocol =
          make_protocol(parse_json("gaze.json", changed.dump()),
                        parse_json("cube.json", shipped("stimuli/l-blocks-in-a-cube.json")));
      check_observer(protocol, load_observer("gap", source_file("protocols/gaze-contingent.json")));
    });
  };
  EXPECT_EQ(refused("gaze"),
            "gaze.json:/clicks: expected none for the simulated participant gap, which does not "
            "click");
  EXPECT_EQ(refused("clicks"),
            "gaze.json:/gaze: expected none for the simulated participant gap, which has no eye");
}

}  // namespace impetus::response_kinds_test
