// What the questions after a stimulus ask, and what becomes of an answer or of none.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/questions/two_interval.hpp"
#include "tests/experiments/asked_study.hpp"

namespace impetus::responses_test {

constexpr std::size_t kYes = 0;
constexpr std::size_t kNo = 1;

ResponseRecord yes_no_answer(double delay_ms, std::size_t choice) {
  TestLab lab(60.0, asked({kAskYesNo}));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(delay_ms), choice);
  EXPECT_EQ(record.outcome, AttemptOutcome::kCompleted);
  EXPECT_TRUE(record.ratings.empty());
  EXPECT_EQ(record.responses.size(), 1U);
  return record.responses.front();
}

TEST(Responses, YesIsPositiveAndRightOnlyWhereTheLevelIsAboveTheRule) {
  EXPECT_EQ(yes_no_answer(300, kYes).positive, true);
  EXPECT_EQ(yes_no_answer(300, kYes).correct, true);
  EXPECT_EQ(yes_no_answer(300, kNo).positive, false);
  EXPECT_EQ(yes_no_answer(300, kNo).correct, false);
  EXPECT_EQ(yes_no_answer(0, kYes).correct, false);
  EXPECT_EQ(yes_no_answer(0, kNo).correct, true);
  EXPECT_EQ(yes_no_answer(0, kNo).answer, "no");
}

TEST(Responses, YesIsRightWhereTwoBodiesTouchThoughTheyDoSoUnseen) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["yes_no"]["right_when"] = {{"touch", {"left", "right"}}};
  const auto answered = [&](double lead_s, std::size_t choice) {
    json scene = asked_scene();
    scene["meeting"]["lead_s"] = lead_s;
    scene["hidden_after_s"] = 0.05;
    TestLab lab(60.0, make_protocol(parse_json("asked.json", protocol.dump()),
                                    parse_json("spheres.json", scene.dump())));
    const AttemptRecord record = answered_trial(lab, trial_with_delay(0), choice);
    EXPECT_TRUE(record.collisions.empty());
    EXPECT_EQ(record.steps.back().step, 12);  // of 1/240 s
    const auto page = practice_feedback(lab.protocol.script, record, {});
    EXPECT_EQ(page->paragraphs.front(),
              choice == kYes ? "That was right." : "That was not right: the answer was “yes”.");
    return record.responses.front().correct;
  };
  EXPECT_EQ(answered(0.1, kYes), true);
  EXPECT_EQ(answered(0.1, kNo), false);
}

TEST(Responses, AChoiceIsRightWhereTheLevelSaysSo) {
  const auto chosen = [](double delay_ms, std::size_t choice) {
    TestLab lab(60.0, asked({kAskChoice}));
    const AttemptRecord record = answered_trial(lab, trial_with_delay(delay_ms), choice);
    EXPECT_EQ(record.responses.size(), 1U);
    const auto page = practice_feedback(lab.protocol.script, record, {});
    EXPECT_EQ(page->paragraphs.front(), record.responses.front().correct == true
                                            ? "That was right."
                                            : "That was not right: the answer was “a late hit”.");
    return record.responses.front();
  };
  EXPECT_EQ(chosen(300, 1).answer, "a late hit");
  EXPECT_EQ(chosen(300, 1).correct, true);
  EXPECT_EQ(chosen(300, 2).answer, "a miss");
  EXPECT_EQ(chosen(300, 2).correct, false);
  EXPECT_EQ(chosen(0, 0).correct, true);
  EXPECT_EQ(chosen(0, 0).positive, std::nullopt);
}

TEST(Responses, OptionsHaveDigitsOrTheKeysOfTheProtocol) {
  json protocol = asked_protocol({kAskChoice});
  TestLab lab(60.0, study_of(protocol));
  const PlannedTrial trial = trial_with_delay(0);
  const Page page = *lab.protocol.script.asked.front()->page({trial, {}});
  ASSERT_EQ(page.choices.size(), 3U);
  EXPECT_EQ(page.choices[2].label, "a miss");
  EXPECT_EQ(page.choices[2].key, "3");
  EXPECT_EQ(page.positive_choice, 0U);
  protocol["choice"].erase("right_when");
  TestLab without(60.0, study_of(protocol));
  EXPECT_EQ(without.protocol.script.asked.front()->page({trial, {}})->positive_choice, 3U);
}

TEST(Responses, WithoutARuleNothingIsRightOrWrong) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["yes_no"].erase("right_when");
  TestLab lab(60.0, study_of(protocol));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(300), kYes);
  EXPECT_EQ(record.responses.front().positive, true);
  EXPECT_FALSE(record.responses.front().correct);
  EXPECT_FALSE(answered_right(record));
}

TEST(Responses, KindsAreAskedOneAfterTheOtherInAFixedOrder) {
  TestLab lab(60.0, asked({kAskFreeText, kAskTwoInterval, kAskYesNo, kAskRating}));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(300), 0);
  EXPECT_EQ(lab.input.titles,
            (std::vector<std::string>{"How believable was it?", "Was there a delay?",
                                      "Which had a delay?", "What did you see?"}));
  ASSERT_EQ(record.responses.size(), 3U);
  EXPECT_EQ(record.responses[0].kind, "yes_no");
  EXPECT_EQ(record.responses[1].kind, "two_interval");
  EXPECT_EQ(record.responses[2].kind, "free_text");
  EXPECT_EQ(record.ratings.size(), 1U);
}

TEST(Responses, AQuestionLeftUnansweredIsKeptAsTimedOutAndTheTrialIsCompleted) {
  TestLab lab(60.0, asked({kAskRating, kAskYesNo, kAskTwoInterval}));
  lab.input.on_page = [](const Page& page) {
    EXPECT_EQ(page.timeout_ms, 5000.0) << page.response;
    Answer answer;
    answer.timed_out = true;
    return answer;
  };
  const AttemptRecord record =
      run_attempt(trial_with_delay(0), 1, lab.protocol.script, {}, lab.ports()).record;
  EXPECT_EQ(record.outcome, AttemptOutcome::kCompleted);
  EXPECT_TRUE(record.ratings.empty());
  ASSERT_EQ(record.responses.size(), 3U);
  EXPECT_EQ(record.responses[0].kind, "rating");
  EXPECT_EQ(record.responses[0].question, "How believable was it?");
  for (const ResponseRecord& response : record.responses) {
    EXPECT_TRUE(response.timed_out) << response.kind;
    EXPECT_EQ(response.answer, "") << response.kind;
    EXPECT_EQ(response.device, "none") << response.kind;
    EXPECT_FALSE(response.positive) << response.kind;
  }
  // There is no right answer to a rating; no answer is not a right one.
  EXPECT_FALSE(record.responses[0].correct);
  EXPECT_EQ(record.responses[1].correct, false);
  EXPECT_EQ(record.responses[2].correct, false);
}

TEST(Responses, AnInterruptedQuestionInterruptsTheTrialAndKeepsWhatWasAnsweredBefore) {
  TestLab lab(60.0, asked({kAskRating, kAskYesNo}));
  lab.input.on_page = [](const Page& page) {
    Answer answer;
    if (page.response == "yes_no") {
      answer.interruption = Interruption::kPauseRequested;
    }
    return answer;
  };
  const AttemptResult result =
      run_attempt(trial_with_delay(0), 1, lab.protocol.script, {}, lab.ports());
  EXPECT_EQ(result.record.outcome, AttemptOutcome::kInterrupted);
  EXPECT_EQ(result.interruption, Interruption::kPauseRequested);
  EXPECT_EQ(result.record.ratings.size(), 1U);
  EXPECT_TRUE(result.record.responses.empty());
}

TEST(Responses, FreeWordsAreKeptAsTheyWereWritten) {
  TestLab lab(60.0, asked({kAskFreeText}));
  lab.input.on_page = [](const Page& page) {
    Answer answer;
    answer.fields = {page.response == "free_text" ? "it “stuck”, 2×" : ""};
    return answer;
  };
  const AttemptRecord record =
      run_attempt(trial_with_delay(0), 1, lab.protocol.script, {}, lab.ports()).record;
  ASSERT_EQ(record.responses.size(), 1U);
  EXPECT_EQ(record.responses.front().answer, "it “stuck”, 2×");
  EXPECT_FALSE(record.responses.front().positive);
}

TEST(Responses, PagesSayWhichResponseTheyAskForAndWhichChoiceIsPositive) {
  const Protocol protocol = asked({kAskRating, kAskYesNo, kAskTwoInterval, kAskFreeText});
  const SessionProgress progress;
  const PlannedTrial trial = trial_with_delay(0);
  const AskedTrial second{trial, progress, 2};
  EXPECT_EQ(protocol.script.asked.size(), 4U);
  for (const auto& question : protocol.script.asked) {
    const std::string& name = question->kind().name;
    const std::optional<Page> page = question->page(second);
    ASSERT_TRUE(page) << name;
    EXPECT_EQ(page->response, name);
    EXPECT_EQ(page->positive_choice, name == "two_interval" ? 1U : 0U) << name;
    EXPECT_TRUE(page->can_pause) << name;
  }
}

TEST(Responses, PracticeFeedbackSaysInWordsWhetherItWasRight) {
  const auto feedback = [](const std::vector<std::string>& questions, double delay_ms,
                           std::size_t choice) {
    TestLab lab(60.0, asked(questions));
    const AttemptRecord record = answered_trial(lab, trial_with_delay(delay_ms), choice);
    const auto page = practice_feedback(lab.protocol.script, record, {});
    std::string words = page ? page->title : "none";
    for (std::size_t i = 0; page && i < page->paragraphs.size(); ++i) {
      words += " / " + page->paragraphs[i];
    }
    return words;
  };
  EXPECT_EQ(feedback({kAskYesNo}, 300, kYes), "You answered “yes” / That was right.");
  EXPECT_EQ(feedback({kAskYesNo}, 0, kYes),
            "You answered “yes” / That was not right: the answer was “no”.");
  EXPECT_EQ(feedback({kAskYesNo}, 300, kNo),
            "You answered “no” / That was not right: the answer was “yes”.");
  const bool first = test_interval(asked({kAskTwoInterval}).script, trial_with_delay(300)) == 1;
  EXPECT_EQ(feedback({kAskTwoInterval}, 300, first ? 0 : 1),
            std::string("You chose “the ") + (first ? "first" : "second") + "” / That was right.");
  EXPECT_EQ(feedback({kAskTwoInterval}, 300, first ? 1 : 0),
            std::string("You chose “the ") + (first ? "second" : "first") +
                "” / That was not right: the answer was “the " + (first ? "first" : "second") +
                "”.");
  EXPECT_EQ(feedback({kAskClicks}, 300, 0),
            "Practice / You did not click. / There are no right or wrong answers: it is how it "
            "looked to you.");
  EXPECT_EQ(feedback({kAskFreeText}, 300, 0), "none");
}

TEST(Responses, PracticeFeedbackOnYesOrNoWithoutARuleDoesNotDenyThatOneIsRight) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["yes_no"].erase("right_when");
  TestLab lab(60.0, study_of(protocol));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(300), kYes);
  const auto page = practice_feedback(lab.protocol.script, record, {});
  ASSERT_TRUE(page);
  EXPECT_EQ(page->title, "You answered “yes”");
  EXPECT_EQ(page->paragraphs, (std::vector<std::string>{"Answer by how it looked to you."}));
}

TEST(Responses, PracticeFeedbackSaysThatTheTimeWasUp) {
  TestLab lab(60.0, asked({kAskRating}));
  lab.input.on_page = [](const Page&) {
    Answer answer;
    answer.timed_out = true;
    return answer;
  };
  const AttemptRecord record =
      run_attempt(trial_with_delay(0), 1, lab.protocol.script, {}, lab.ports()).record;
  const auto page = practice_feedback(lab.protocol.script, record, {});
  ASSERT_TRUE(page);
  EXPECT_EQ(page->title, "The time was up");
  EXPECT_EQ(page->paragraphs.front(), "You have 5 s to answer.");
}

// ---------------------------------------------------------------- keys

/// The yes-or-no study with a factor of its keys.
Protocol with_keys_of(const std::vector<std::string>& levels) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["design"]["factors"].push_back(
      {{"name", "keys"}, {"keys_of", "yes_no"}, {"between", true}, {"levels", levels}});
  return study_of(protocol);
}

/// The choices of the page of a trial under these keys, "no (f), yes (j)", and the record when the
/// first of them was made.
std::pair<std::string, AttemptRecord> first_choice_under(const Protocol& protocol,
                                                         const std::string& keys) {
  TestLab lab(60.0, protocol);
  PlannedTrial trial = trial_with_delay(300);
  trial.condition.push_back({"keys", keys});
  std::string choices;
  lab.input.on_page = [&](const Page& page) {
    for (const Choice& choice : page.choices) {
      choices += (choices.empty() ? "" : ", ") + choice.label + " (" + choice.key + ")";
    }
    EXPECT_EQ(page.choices.at(page.positive_choice).label, "yes");
    return Answer{};
  };
  AttemptRecord record = run_attempt(trial, 1, lab.protocol.script, {}, lab.ports()).record;
  return {choices, std::move(record)};
}

TEST(AnswerKeys, OfAFactorKeepTheirSidesAndTheAnswersChangeThem) {
  const Protocol protocol = with_keys_of({"f j", "j f"});
  const auto [straight, yes] = first_choice_under(protocol, "f j");
  EXPECT_EQ(straight, "yes (f), no (j)");
  EXPECT_EQ(yes.responses.front().answer, "yes");
  EXPECT_EQ(yes.responses.front().correct, true);
  const auto [crossed, no] = first_choice_under(protocol, "j f");
  EXPECT_EQ(crossed, "no (f), yes (j)");
  EXPECT_EQ(no.responses.front().answer, "no");
  EXPECT_EQ(no.responses.front().positive, false);
  EXPECT_EQ(no.responses.front().correct, false);
}

TEST(AnswerKeys, OfAQuestionStandForItsAnswersInTheirOrder) {
  json protocol = asked_protocol({kAskYesNo, kAskTwoInterval});
  protocol["yes_no"]["keys"] = "q p";
  protocol["two_interval"]["keys"] = "0 9";
  TestLab lab(60.0, study_of(protocol));
  std::string keys;
  lab.input.on_page = [&](const Page& page) {
    keys += page.choices[0].label + " " + page.choices[0].key + ", " + page.choices[1].label + " " +
            page.choices[1].key + "; ";
    return Answer{};
  };
  static_cast<void>(
      run_attempt(trial_with_delay(300), 1, lab.protocol.script, {}, lab.ports()).record);
  EXPECT_EQ(keys, "yes q, no p; the first 0, the second 9; ");
}

TEST(AnswerKeys, ChangeNothingOfWhatASimulatedParticipantSays) {
  const auto says = [](const Protocol& protocol, const char* keys) {
    std::vector<std::string> answers;
    for (const std::size_t place : {std::size_t{0}, std::size_t{1}}) {
      TestLab lab(60.0, protocol);
      PlannedTrial trial = trial_with_delay(300);
      trial.condition.push_back({"keys", std::string(keys)});
      lab.input.on_page = [place](const Page& page) {
        Answer answer;
        answer.choice = place == 0 ? page.positive_choice : 1 - page.positive_choice;
        return answer;
      };
      answers.push_back(run_attempt(trial, 1, lab.protocol.script, {}, lab.ports())
                            .record.responses.front()
                            .answer);
    }
    return answers;
  };
  const Protocol protocol = with_keys_of({"f j", "j f"});
  EXPECT_EQ(says(protocol, "f j"), (std::vector<std::string>{"yes", "no"}));
  EXPECT_EQ(says(protocol, "j f"), (std::vector<std::string>{"yes", "no"}));
}

// ---------------------------------------------------------------- the order of questions

std::vector<std::string> asked_in(const json& order, std::uint64_t seed) {
  json protocol = asked_protocol({kAskFreeText, kAskTwoInterval, kAskYesNo, kAskRating});
  protocol["question_order"] = order;
  TestLab lab(60.0, study_of(protocol));
  const AttemptRecord record = answered_trial(lab, trial_with_delay(300, seed), 0);
  EXPECT_EQ(record.responses.size(), 3U);
  EXPECT_EQ(record.responses.front().kind, "yes_no") << "records are in one order";
  return lab.input.titles;
}

TEST(QuestionOrder, IsAsTheProtocolListsThem) {
  EXPECT_EQ(asked_in({"free_text", "yes_no", "rating", "two_interval"}, 1),
            (std::vector<std::string>{"What did you see?", "Was there a delay?",
                                      "How believable was it?", "Which had a delay?"}));
}

TEST(QuestionOrder, IsDrawnByTheTrialsSeedAlone) {
  std::map<std::string, int> first;
  constexpr int kTrials = 60;
  for (std::uint64_t seed = 1; seed <= kTrials; ++seed) {
    const std::vector<std::string> titles = asked_in("random", seed);
    ++first[titles.front()];
    if (seed == 1) {
      EXPECT_EQ(titles, asked_in("random", seed));
    }
  }
  EXPECT_EQ(first.size(), 4U);
  for (const auto& [title, times] : first) {
    EXPECT_GT(times, kTrials / 4 / 3) << title;  // of 15 expected: below 5.2 is 3 deviations off
  }
}

TEST(QuestionOrder, ThatLeavesOneOutOrNamesAnotherIsRefused) {
  const std::vector<json> orders{"fixed", json::array({"rating"}),
                                 json::array({"rating", "clicks"}),
                                 json::array({"rating", "rating"}), json::array()};
  for (const json& order : orders) {
    json protocol = asked_protocol({kAskYesNo, kAskRating});
    protocol["question_order"] = order;
    EXPECT_EQ(
        asked_refusal(protocol),
        "asked.json:/question_order: expected \"random\" or the questions after the stimulus, "
        "each once, in some order ([\"rating\",\"yes_no\"]), got " +
            order.dump());
  }
}

}  // namespace impetus::responses_test
