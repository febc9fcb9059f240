// SPDX-License-Identifier: MIT
#include "experiments/questions/session_pages.hpp"

#include "experiments/tables/number_text.hpp"

namespace impetus::inline questions {
namespace {

Choice way_back(const Language& language) {
  return {language.text("back"), language.text("back_key")};
}

}  // namespace

Text welcome_back(const Language& language, std::int64_t completed_trials) {
  return {language.text("welcome_back"),
          {language.counted_text("trials_saved", completed_trials),
           language.text("instructions_again")}};
}

Page text_page(const Text& text, const SessionProgress& progress) {
  Page page;
  page.title = text.title;
  page.paragraphs = text.paragraphs;
  std::erase(page.paragraphs, "");  // switched off
  page.choices = {{progress.language.text("continue"), "space"}};
  page.progress = progress;
  return page;
}

Page text_page_with_way_back(const Text& text, const SessionProgress& progress) {
  Page page = text_page(text, progress);
  page.choices.push_back(way_back(progress.language));
  return page;
}

Page consent_page(const Text& text, const std::string& statement, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page(text, progress);
  page.statement = statement;
  page.choices = {{language.text("agree"), language.text("agree_key")},
                  {language.text("decline"), language.text("decline_key")},
                  way_back(language)};
  page.choice_at_end = static_cast<std::size_t>(ConsentChoice::kAgree);
  return page;
}

Page refusal_page(const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page({language.text("refuse_question"), {}}, progress);
  page.choices = {{language.text("refuse_yes"), language.text("agree_key")}, way_back(language)};
  return page;
}

Page declined_page(const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page =
      text_page({language.text("declined_title"), {language.text("declined_saved")}}, progress);
  page.choices = {{language.text("close"), "space"}};
  page.can_pause = false;
  return page;
}

Page demographics_page(const std::vector<Field>& fields, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page =
      text_page({language.text("about_you"), {language.text("about_you_advice")}}, progress);
  page.layout = Page::Layout::kForm;
  page.fields = fields;
  page.choices = {{language.text("continue"), "enter"}};
  return page;
}

Page phase_intro(const Script& script, TrialPhase phase, std::int64_t round, std::int64_t count,
                 const SessionProgress& progress) {
  const Language& language = progress.language;
  if (phase == TrialPhase::kPractice) {
    return text_page({language.text("practice"),
                      {round > 1 ? language.counted_text("practice_another", count)
                                 : language.counted_text("practice_first", count)}},
                     progress);
  }
  const bool has_cross = script.timing.fixation.most_ms > 0.0;
  return text_page(
      {language.text("ready"),
       {language.counted_text("ready_trials", count),
        has_cross ? language.text("ready_advice") : language.text("ready_advice_no_cross")}},
      progress);
}

Page training_intro(const TrainingRule& rule, const SessionProgress& progress) {
  const Language& language = progress.language;
  return text_page({language.text("practice"),
                    {language.text("training"),
                     language.text("training_rule", {{"right", std::to_string(rule.right)},
                                                     {"of", std::to_string(rule.of)}})}},
                   progress);
}

Page demonstration_over(const Text& text, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page =
      text_page({language.text("demonstration_over", {{"title", text.title}}), {}}, progress);
  page.choices = {{language.text("continue"), "space"},
                  {language.text("see_again"), language.text("again_key")}};
  return page;
}

std::optional<Page> practice_feedback(const Script& script, const AttemptRecord& record,
                                      const SessionProgress& progress) {
  const Language& language = progress.language;
  Text text;
  bool asks_for_a_fact = false;
  for (const auto& question : script.asked) {
    asks_for_a_fact = asks_for_a_fact || question->kind().asks_for_a_fact;
    const Text words = question->feedback(record, language);
    if (text.title.empty()) {
      text.title = words.title;
    } else if (!words.title.empty()) {
      text.paragraphs.push_back(language.text("sentence", {{"words", words.title}}));
    }
    text.paragraphs.insert(text.paragraphs.end(), words.paragraphs.begin(), words.paragraphs.end());
  }
  std::erase(text.paragraphs, "");
  if (text.title.empty() && text.paragraphs.empty()) {
    return std::nullopt;
  }
  text.title = text.title.empty() ? language.text("practice") : text.title;
  // Which would ask for better ones; so does a click at the right instant.
  if (!script.practice_rule && !has_right_answers(script) && !ends_with_click(script)) {
    text.paragraphs.push_back(asks_for_a_fact ? language.text("answer_by_looks")
                                              : language.text("no_right_answers"));
  }
  return text_page(text, progress);
}

Page practice_again(const std::vector<std::string>& missing, const SessionProgress& progress) {
  Text text{progress.language.text("once_more"), missing};
  text.paragraphs.push_back(progress.language.text("practise_again"));
  return text_page(text, progress);
}

Page experimenter_decides(const Text& text, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page(text, progress);
  page.choices = {{language.text("go_on"), language.text("go_on_key")},
                  {language.text("stop"), language.text("stop_key")}};
  return page;
}

Page practice_not_understood(const SessionProgress& progress) {
  const Language& language = progress.language;
  return experimenter_decides(
      {language.text("call_experimenter"),
       {language.text("practice_unclear"), language.text("experimenter_decides")}},
      progress);
}

Page frames_were_late(std::int64_t late, std::int64_t frames, double slower_share,
                      const SessionProgress& progress) {
  const Language& language = progress.language;
  const std::string percent = printed("%.2g", 100.0 * slower_share);
  const std::string share = language.text("percent", {{"number", language.number(percent)}});
  return experimenter_decides({language.text("call_experimenter"),
                               {language.text("frames_late", {{"late", std::to_string(late)},
                                                              {"frames", std::to_string(frames)},
                                                              {"share", share}}),
                                language.text("experimenter_decides")}},
                              progress);
}

Page practice_summary(const RatingScale& scale, const std::map<std::int64_t, std::int64_t>& use,
                      const SessionProgress& progress) {
  const Language& language = progress.language;
  Text text{language.text("practice_over"), {}};
  for (std::int64_t point = scale.minimum; point <= scale.maximum; ++point) {
    const auto used = use.find(point);
    const std::int64_t count = used == use.end() ? 0 : used->second;
    text.paragraphs.push_back(
        language.text("scale_use", {{"point", std::to_string(point)},
                                    {"meaning", scale.meaning(point, language)},
                                    {"times", count == 0 ? language.text("used_never")
                                                         : language.counted_text("used", count)}}));
  }
  text.paragraphs.push_back(use.size() == 1 ? language.text("practice_advice_one_point")
                                            : language.text("practice_advice"));
  return text_page(text, progress);
}

Page training_over(std::int64_t right, std::int64_t of, const SessionProgress& progress) {
  const Language& language = progress.language;
  return text_page({language.text("practice_over"),
                    {language.text("training_result", {{"right", std::to_string(right)},
                                                       {"of", std::to_string(of)}})}},
                   progress);
}

Page break_page(const Text& text, std::int64_t done, std::int64_t total,
                const SessionProgress& progress) {
  Text with_count = text;
  with_count.paragraphs.push_back(progress.language.text(
      "break_progress", {{"done", std::to_string(done)}, {"total", std::to_string(total)}}));
  return text_page(with_count, progress);
}

Page question_page(const FreeQuestion& question, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page({language.text("one_question"), {}}, progress);
  page.layout = Page::Layout::kForm;
  page.fields = {{question.id, question.text, Field::Kind::kText, {}, 0.0, 0.0}};
  page.choices = {{language.text("continue"), "enter"}};
  return page;
}

Page pause_page(const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page(
      {language.text("pause"), {language.text("pause_saved"), language.text("pause_in_trial")}},
      progress);
  page.choices = {{language.text("continue"), "space"},
                  {language.text("quit"), language.text("quit_key")}};
  page.can_pause = false;
  return page;
}

Page quit_page(const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page({language.text("quit_question"), {language.text("quit_saved")}}, progress);
  page.choices = {{language.text("quit_yes"), language.text("agree_key")},
                  {language.text("quit_no"), language.text("decline_key")}};
  page.can_pause = false;
  return page;
}

Text part_complete(const Language& language, std::size_t part, std::size_t parts) {
  return {language.text("part_complete",
                        {{"part", std::to_string(part)}, {"parts", std::to_string(parts)}}),
          {language.text("part_saved")}};
}

Page thanks_page(const Text& text, bool part_follows, const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page = text_page(text, progress);
  page.choices = {{part_follows ? language.text("continue") : language.text("close"), "space"}};
  page.can_pause = false;
  return page;
}

}  // namespace impetus::inline questions
