// Free words after the stimulus; they may be left out.
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& free_text_kind();

namespace {

/// A question above a text box.
class FreeTextQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows() {
    using F = FreeTextQuestion;
    return block<F>("Asked after every stimulus, and answered in free words.",
                    {required("question", &F::question_, text())});
  }

  [[nodiscard]] const ResponseKind& kind() const override { return free_text_kind(); }

  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override {
    Page page = page_of(kind(), Page::Layout::kForm, question_, asked);
    page.fields = {{kind().name, "", Field::Kind::kText, {}, 0.0, 0.0}};
    page.choices = {{asked.progress.language.text("continue"), "enter"}};
    return page;
  }

  void keep(const AskedTrial& /*asked*/, const Answer& answer,
            AttemptRecord& record) const override {
    ResponseRecord response = response_record(kind().name, question_, answer);
    response.answer = answer.fields.front();
    record.responses.push_back(response);
  }

  [[nodiscard]] std::string explanation(const Words& words) const override {
    return "“" + words(question_) + "” in free words";
  }

 private:
  std::string question_;
};

}  // namespace

const ResponseKind& free_text_kind() {
  static const ResponseKind kind{.name = "free_text",
                                 .protocol_key = "free_text",
                                 .when = "after the stimulus",
                                 .table = "response",
                                 .block = FreeTextQuestion::rows(),
                                 .recorded = {},
                                 .event = "Free words were asked for",
                                 .is_typed = true};
  return kind;
}

}  // namespace impetus::inline questions
