// SPDX-License-Identifier: MIT
#include "experiments/questions/session_pages.hpp"

namespace impetus::inline questions {
namespace {

std::string times(std::int64_t count) {
  return count == 1 ? "once" : std::to_string(count) + " times";
}

}  // namespace

Text welcome_back(std::int64_t completed_trials) {
  return {"Welcome back",
          {"This session goes on where the last one stopped. " + std::to_string(completed_trials) +
               (completed_trials == 1 ? " trial is" : " trials are") + " already saved.",
           "The instructions are shown again first."}};
}

Page text_page(const Text& text, const SessionProgress& progress) {
  Page page;
  page.title = text.title;
  page.paragraphs = text.paragraphs;
  page.choices = {{"Continue", "space"}};
  page.progress = progress;
  return page;
}

Page consent_page(const Text& text, const std::string& statement, const SessionProgress& progress) {
  Page page = text_page(text, progress);
  page.statement = statement;
  page.choices = {{"Yes, I agree", "y"}, {"No, I do not", "n"}};
  return page;
}

Page demographics_page(const std::vector<Field>& fields, const SessionProgress& progress) {
  Page page = text_page({"About you", {"Leave empty what you would rather not say."}}, progress);
  page.layout = Page::Layout::kForm;
  page.fields = fields;
  page.choices = {{"Continue", "enter"}};
  return page;
}

Page phase_intro(TrialPhase phase, std::int64_t round, std::size_t trials,
                 const SessionProgress& progress) {
  const std::string count = std::to_string(trials) + (trials == 1 ? " trial" : " trials");
  if (phase == TrialPhase::kPractice) {
    const std::string words = (round > 1 ? "Again, " : "First, ") + count;
    return text_page({"Practice", {words + " to get used to the task: they do not count."}},
                     progress);
  }
  return text_page(
      {"Ready?",
       {"Now " + count + " for the study. The bar at the bottom shows how far you are.",
        "Keep your eyes on the cross before each one. Esc pauses at any time."}},
      progress);
}

Page training_intro(const TrainingRule& rule, const SessionProgress& progress) {
  return text_page(
      {"Practice",
       {"First, trials to get used to the task: they do not count. After each you are told whether "
        "your answer was right.",
        "Practice ends when " + std::to_string(rule.right) + " of the last " +
            std::to_string(rule.of) + " answers were right."}},
      progress);
}

Page demonstration_over(const Text& text, const SessionProgress& progress) {
  Page page = text_page({"That was: " + text.title, {}}, progress);
  page.choices = {{"Continue", "space"}, {"See it again", "a"}};
  return page;
}

std::optional<Page> practice_feedback(const Script& script, const AttemptRecord& record,
                                      const SessionProgress& progress) {
  Text text;
  bool asks_for_a_fact = false;
  for (const auto& question : script.asked) {
    asks_for_a_fact = asks_for_a_fact || question->kind().asks_for_a_fact;
    const Text words = question->feedback(record);
    if (text.title.empty()) {
      text.title = words.title;
    } else if (!words.title.empty()) {
      text.paragraphs.push_back(words.title + ".");
    }
    text.paragraphs.insert(text.paragraphs.end(), words.paragraphs.begin(), words.paragraphs.end());
  }
  if (text.title.empty() && text.paragraphs.empty()) {
    return std::nullopt;
  }
  text.title = text.title.empty() ? "Practice" : text.title;
  if (!script.practice_rule && !has_right_answers(script)) {  // which would ask for better ones
    text.paragraphs.emplace_back(
        asks_for_a_fact ? "Answer by how it looked to you."
                        : "There are no right or wrong answers: it is how it looked to you.");
  }
  return text_page(text, progress);
}

Page practice_again(const std::vector<std::string>& missing, const SessionProgress& progress) {
  Text text{"Once more", missing};
  text.paragraphs.emplace_back("Please practise once more. Ask the experimenter if in doubt.");
  return text_page(text, progress);
}

Page practice_not_understood(const SessionProgress& progress) {
  Page page = text_page({"Please call the experimenter",
                         {"Practice is over, but something about the task may not be clear yet.",
                          "The experimenter decides whether the study goes on."}},
                        progress);
  page.choices = {{"Go on with the study", "g"}, {"Stop here", "s"}};
  return page;
}

Page practice_summary(const RatingScale& scale, const std::map<std::int64_t, std::int64_t>& use,
                      const SessionProgress& progress) {
  Text text{"Practice is over", {}};
  for (std::int64_t point = scale.minimum; point <= scale.maximum; ++point) {
    const auto used = use.find(point);
    const std::int64_t count = used == use.end() ? 0 : used->second;
    text.paragraphs.push_back(std::to_string(point) + " (" + scale.meaning(point) +
                              "): " + (count == 0 ? "not used" : times(count)));
  }
  text.paragraphs.push_back(use.size() == 1
                                ? "You used one point only. The whole scale is there for you."
                                : "Use the whole scale in the same way from now on.");
  return text_page(text, progress);
}

Page training_over(std::int64_t right, std::int64_t of, const SessionProgress& progress) {
  return text_page({"Practice is over",
                    {"You answered " + std::to_string(right) + " of the last " +
                     std::to_string(of) + " right."}},
                   progress);
}

Page break_page(const Text& text, std::int64_t done, std::int64_t total,
                const SessionProgress& progress) {
  Text with_count = text;
  with_count.paragraphs.push_back(std::to_string(done) + " of " + std::to_string(total) +
                                  " trials are done and saved.");
  return text_page(with_count, progress);
}

Page question_page(const FreeQuestion& question, const SessionProgress& progress) {
  Page page = text_page({"One question", {}}, progress);
  page.layout = Page::Layout::kForm;
  page.fields = {{question.id, question.text, Field::Kind::kText, {}, 0.0, 0.0}};
  page.choices = {{"Continue", "enter"}};
  return page;
}

Page pause_page(const SessionProgress& progress) {
  Page page = text_page({"Pause",
                         {"Everything you have answered is saved.",
                          "If you pause within a trial, it is shown again from its start."}},
                        progress);
  page.choices = {{"Continue", "space"}, {"Quit", "q"}};
  page.can_pause = false;
  return page;
}

Page quit_page(const SessionProgress& progress) {
  Page page =
      text_page({"Quit the session?",
                 {"Your answers stay saved. The session can go on later at the next trial."}},
                progress);
  page.choices = {{"Yes, quit", "y"}, {"No, go back", "n"}};
  page.can_pause = false;
  return page;
}

Page thanks_page(const Text& text, bool part_follows, const SessionProgress& progress) {
  Page page = text_page(text, progress);
  page.choices = {{part_follows ? "Continue" : "Close", "space"}};
  page.can_pause = false;
  return page;
}

}  // namespace impetus::inline questions
