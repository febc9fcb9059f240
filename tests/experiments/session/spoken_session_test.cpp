// What participants read in another language: every built-in word on every page, of whole sessions
// and page by page; and that what is recorded does not know of it.
//
// The language of these tests says of each text its key, between ¤, and what is put in. The
// protocol's own words are marked by ¤, too: a word without ¤ stands in the code.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "experiments/languages/language_file.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/session/gaze_calibration.hpp"
#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/calibration_lab.hpp"

namespace impetus::spoken_session_test {

constexpr const char* kMark = "¤";

std::string marked(std::string_view words) { return kMark + std::string(words) + kMark; }

/// The texts that are their own keys; keys to press are English.
json texts_of_keys() {
  json texts;
  for (std::size_t i = 0; i < kTextRows.size(); ++i) {
    std::string words(english().texts()[i]);
    if (kTextRows[i].use != TextUse::kKey) {
      const std::vector<std::string> names = placeholders(words);
      words = marked(kTextRows[i].key);
      for (const std::string& name : names) {
        words += " {" + name + "}";
      }
    }
    texts[std::string(kTextRows[i].key)] = words;
  }
  return texts;
}

/// Whether what is read is marked, or has no word in it.
bool is_spoken(const std::string& words) {
  static const std::regex kWord("[A-Za-z]{2,}");
  return words.find(kMark) != std::string::npos || !std::regex_search(words, kWord);
}

/// Everything that was on pages and pictures.
class Reading {
 public:
  void read(const Page& page) {
    std::vector<std::string> all = page.paragraphs;
    all.insert(all.end(), {page.title, page.statement, page.low_anchor, page.high_anchor});
    for (const Field& field : page.fields) {
      all.push_back(field.label);
      all.insert(all.end(), field.options.begin(), field.options.end());
    }
    for (const Choice& choice : page.choices) {
      all.push_back(choice.label);
    }
    for (const std::string& words : all) {
      take(words, page.title);
    }
    take(page.progress.label, page.title);
    EXPECT_EQ(page.progress.language.title(), "Keys") << page.title;
  }

  void take(const std::string& words, const std::string& page) {
    EXPECT_TRUE(is_spoken(words)) << page << ": " << words;
    static const std::regex kKey("¤([a-z_]+)¤");
    for (std::sregex_iterator match(words.begin(), words.end(), kKey), none; match != none;
         ++match) {
      seen_.insert((*match)[1].str());
    }
  }

  [[nodiscard]] const std::set<std::string>& seen() const { return seen_; }

 private:
  std::set<std::string> seen_;
};

/// The protocol with all its words marked, in the language of keys.
json spoken(json protocol) {
  protocol["language"] = {{"schema_version", 1}, {"title", "Keys"}, {"texts", texts_of_keys()}};
  const std::set<std::string> words{"title",      "paragraphs",  "statement", "label",  "text",
                                    "low_anchor", "high_anchor", "question",  "options"};
  const std::function<void(json&, bool)> mark = [&](json& value, bool is_read) {
    for (auto entry = value.begin(); value.is_structured() && entry != value.end(); ++entry) {
      mark(*entry, value.is_array() ? is_read : words.count(entry.key()) > 0);
    }
    if (value.is_string() && is_read) {
      value = kMark + value.get<std::string>();
    }
  };
  for (const char* part : {"session", "rating", "yes_no", "two_interval", "free_text"}) {
    if (protocol.contains(part)) {
      mark(protocol[part], false);
    }
  }
  return protocol;
}

/// Runs a session whose pages are read; `answer` may answer them otherwise than by the first
/// choice.
SessionResult run_read(TestLab& lab, const Plan& plan, Reading& reading,
                       const std::function<void(const Page&, Answer&)>& answer = {}) {
  lab.input.on_page = [&](const Page& page) {
    reading.read(page);
    Answer given;
    if (answer) {
      answer(page, given);
    }
    return given;
  };
  const SessionResult result =
      run_session(lab.protocol.script, plan, {}, lab.ports(), lab.protocol.design);
  for (const Picture& picture : lab.display.pictures) {
    reading.take(picture.progress.label, "a picture");
  }
  return result;
}

/// A shipped protocol, spoken, of which a test may have changed more.
Protocol spoken_causality(const std::function<void(json&)>& change = {}) {
  json protocol = spoken(json::parse(shipped(kProtocolName)));
  if (change) {
    change(protocol);
  }
  return make_protocol(parse_json("spoken.json", protocol.dump()),
                       parse_json("spheres.json", shipped(kSceneName)));
}

Protocol spoken_asked(const std::vector<std::string>& questions) {
  return study_of(spoken(asked_protocol(questions)));
}

Plan plan_of(const Protocol& protocol) {
  return make_plan(protocol.design, {protocol.name, "P01", 1});
}

SessionProgress progress_in(const Language& language) {
  SessionProgress progress;
  progress.language = language;
  return progress;
}

// ---------------------------------------------------------------- whole sessions

/// Practice and main trials with a rating, a break, questions: paused once, not quitted.
void read_rated_session(Reading& reading) {
  TestLab lab(60.0,
              spoken_causality([](json& protocol) { protocol["session"]["breaks"]["every"] = 1; }));
  bool paused = false;
  const auto answer = [&](const Page& page, Answer& given) {
    if (page.response == "rating" && !paused) {
      paused = true;
      given.interruption = Interruption::kPauseRequested;
    } else if (page.title == marked("pause")) {
      given.choice = page.choices.size() - 1;
      paused = true;
    } else if (page.title == marked("quit_question")) {
      given.choice = 0;
    }
  };
  EXPECT_EQ(run_read(lab, short_plan(lab.protocol, 2), reading, answer).ending,
            SessionEnding::kQuit);
  TestLab whole(
      60.0, spoken_causality([](json& protocol) { protocol["session"]["breaks"]["every"] = 1; }));
  EXPECT_EQ(run_read(whole, short_plan(whole.protocol, 2), reading).ending,
            SessionEnding::kFinished);
}

/// Consent refused, and meant.
void read_refusal(Reading& reading) {
  TestLab lab(60.0, spoken_causality());
  const auto answer = [](const Page& page, Answer& given) {
    given.choice = page.choice_at_end ? 1 : 0;
  };
  EXPECT_EQ(run_read(lab, short_plan(lab.protocol, 1), reading, answer).ending,
            SessionEnding::kDeclined);
}

/// All kinds of response at once, answered, and left until their time is up.
void read_asked_session(Reading& reading) {
  const std::vector<std::string> questions{kAskRating, kAskYesNo, kAskTwoInterval, kAskFreeText,
                                           kAskClicks};
  for (const bool in_time : {true, false}) {
    TestLab lab(60.0, spoken_asked(questions));
    const auto answer = [&](const Page& page, Answer& given) {
      given.timed_out = !in_time && page.timeout_ms > 0.0;
    };
    EXPECT_EQ(run_read(lab, plan_of(lab.protocol), reading, answer).ending,
              SessionEnding::kFinished);
  }
  json without_a_rule = spoken(asked_protocol({kAskYesNo, kAskClicks}));
  without_a_rule["yes_no"].erase("right_when");
  TestLab lab(60.0, study_of(without_a_rule));
  AttemptRecord record = answered_trial(lab, trial_with_delay(0), 0);
  const SessionProgress progress = progress_in(lab.protocol.script.language);
  for (std::size_t clicks = 0; clicks < 3; ++clicks) {
    record.clicks.resize(clicks);
    reading.read(practice_feedback(lab.protocol.script, record, progress).value());
  }
}

/// Practice that is not understood, and training that is passed.
void read_practice(Reading& reading) {
  TestLab lab(60.0, spoken_causality([](json& protocol) {
                protocol["clicks"] = {{"merge_within_ms", 100}};
                protocol["design"]["practice_until"] = {
                    {"factor", "delay_ms"}, {"best", 0}, {"worst", 300}, {"rounds", 2}};
                protocol["design"]["practice"] = json::parse(
                    R"([{"delay_ms": 0, "speed_deg_s": 10, "viewpoint_deg": 0},
                        {"delay_ms": 300, "speed_deg_s": 10, "viewpoint_deg": 0}])");
              }));
  run_read(lab, plan_of(lab.protocol), reading, [](const Page& page, Answer& given) {
    given.choice = page.title == marked("call_experimenter") ? 1 : 0;
  });
  json protocol = spoken(asked_protocol({kAskYesNo}));
  protocol["design"]["train_until"] = {{"right", 1}, {"of", 2}, {"most_trials", 8}};
  TestLab training(60.0, study_of(protocol));
  EXPECT_EQ(run_read(training, plan_of(training.protocol), reading).ending,
            SessionEnding::kFinished);
}

// ---------------------------------------------------------------- pages that few see

CalibrationRecord seen_badly(bool seen) {
  CalibrationRecord record;
  record.gaze_source = "mouse";
  record.points.resize(9);
  if (seen) {
    record.accuracy_deg = 2.0;
    for (CalibrationPointRecord& point : record.points) {
      point.gaze = ScreenPoint{};
    }
  }
  return record;
}

void read_gaze_pages(const Language& language, Reading& reading) {
  const SessionProgress progress = progress_in(language);
  const ScreenGeometry screen = assumed_screen();
  CalibrationRecord once = seen_badly(true);
  once.sampling_hz = 60.0;
  once.points[0].gaze.reset();
  CalibrationRecord twice = seen_badly(true);
  twice.points[0].gaze.reset();
  twice.points[1].gaze.reset();
  CalibrationRecord passed = seen_badly(true);
  passed.passed = true;
  for (const CalibrationRecord& record : {once, twice, passed, seen_badly(false)}) {
    for (const Numbers numbers : {Numbers::kHidden, Numbers::kShown}) {
      reading.read(calibration_results(record, screen, numbers, progress));
      reading.read(gaze_has_drifted(record, numbers, progress));
    }
    reading.read(calibration_not_passed(record, screen, progress));
  }
  for (const bool by_pointer : {true, false}) {
    reading.read(calibration_intro(by_pointer, progress));
    reading.read(gaze_was_lost_page(0.5, by_pointer, progress));
    CalibrationLab lab(short_gaze_study([](json& protocol, json& /*scene*/) {
      protocol = spoken(protocol);
      protocol["session"]["breaks"]["every"] = 1;
    }));
    lab.eye.pointer = by_pointer;
    run_read(lab, lab.plan, reading);
  }
}

void read_other_pages(const Language& language, Reading& reading) {
  const SessionProgress progress = progress_in(language);
  const Text demonstration{kMark, {}};
  for (const std::int64_t count : {1, 2}) {
    reading.read(text_page(welcome_back(language, count), progress));
    for (const TrialPhase phase : {TrialPhase::kPractice, TrialPhase::kMain}) {
      for (const double cross_ms : {0.0, 500.0}) {
        Script script;
        script.timing.fixation = {cross_ms, cross_ms};
        reading.read(phase_intro(script, phase, 1, static_cast<std::size_t>(count), progress));
        reading.read(phase_intro(script, phase, 2, static_cast<std::size_t>(count), progress));
      }
    }
  }
  RatingScale scale;
  scale.low_anchor = scale.high_anchor = kMark;
  reading.read(practice_summary(scale, {{1, 1}}, progress));
  reading.read(practice_summary(scale, {{1, 1}, {2, 2}}, progress));
  reading.read(demonstration_over(demonstration, progress));
  reading.read(frames_were_late(3, 100, 0.05, progress));
  reading.read(thanks_page(part_complete(language, 1, 2), true, progress));
}

// ---------------------------------------------------------------- the claims

TEST(SpokenSession, HasNoWordThatIsNotOfItsLanguageAndUsesEveryTextOfTheTable) {
  Reading reading;
  const Language language = spoken_causality().script.language;
  read_rated_session(reading);
  read_refusal(reading);
  read_asked_session(reading);
  read_practice(reading);
  read_gaze_pages(language, reading);
  read_other_pages(language, reading);
  const std::set<std::string> of_the_window{"space_bar",      "enter",         "escape",
                                            "gaze_lost_mark", "map_caption",   "press_or_click",
                                            "scroll_hint",    "number_within", "number_needed",
                                            "read_to_end",    "mark_needed"};
  for (const TextRow& row : kTextRows) {
    const std::string key(row.key);
    const bool of_web_pages = key.starts_with("page_");
    if (row.use != TextUse::kKey && of_the_window.count(key) == 0 && !of_web_pages) {
      EXPECT_EQ(reading.seen().count(key), 1U) << key << " is on no page";
    }
  }
}

TEST(SpokenSession, InGermanAsksAndAnswersInGermanAndRecordsAsInEnglish) {
  const auto recorded = [](const char* language, std::vector<std::string>& keys) {
    json protocol = asked_protocol({kAskRating, kAskYesNo, kAskTwoInterval});
    protocol["language"] = language;
    TestLab lab(60.0, study_of(protocol));
    lab.input.on_page = [&](const Page& page) {
      for (const Choice& choice : page.choices) {
        keys.push_back(choice.label + " (" + choice.key + ")");
      }
      return Answer{};
    };
    run_session(lab.protocol.script, plan_of(lab.protocol), {}, lab.ports(), lab.protocol.design);
    std::string all;
    for (const AttemptRecord& attempt : lab.recorder.attempts) {
      for (const ResponseRecord& response : attempt.responses) {
        all += response.kind + response.question + response.answer + "\n";
      }
    }
    return all;
  };
  std::vector<std::string> german;
  std::vector<std::string> english;
  EXPECT_EQ(recorded("de", german), recorded("en", english));
  const std::set<std::string> all(german.begin(), german.end());
  EXPECT_EQ(all, (std::set<std::string>{
                     "1 (1)", "2 (2)", "3 (3)", "Die erste (1)", "Die zweite (2)", "Ja (j)",
                     "Ja, ich stimme zu (j)", "Nein (n)", "Nein, ich stimme nicht zu (n)",
                     "Schließen (space)", "Weiter (enter)", "Weiter (space)", "Zurück (z)"}));
}

TEST(SpokenSession, DoesNotShowAPageOfWhichEveryTextIsSwitchedOff) {
  const auto titles = [](const json& texts) {
    json protocol = json::parse(shipped(kProtocolName));
    protocol["texts"] = texts;
    TestLab lab(60.0, make_protocol(parse_json("off.json", protocol.dump()),
                                    parse_json("spheres.json", shipped(kSceneName))));
    run_session(lab.protocol.script, short_plan(lab.protocol, 1), {}, lab.ports());
    return std::set<std::string>(lab.input.titles.begin(), lab.input.titles.end());
  };
  EXPECT_EQ(titles({{"practice_advice", ""}}).count("Practice is over"), 1U);
  const std::set<std::string> without = titles({{"practice_over", ""},
                                                {"scale_use", ""},
                                                {"practice_advice", ""},
                                                {"practice_advice_one_point", ""},
                                                {"you_answered", ""},
                                                {"scale_meaning", ""}});
  EXPECT_EQ(without.count("Practice is over"), 0U);
  EXPECT_EQ(without.count("You answered 1"), 0U);
  EXPECT_EQ(without.count(""), 0U);
}

}  // namespace impetus::spoken_session_test
