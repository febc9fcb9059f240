// Free words after the stimulus; they may be left out.
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {
namespace free_text_response {

constexpr const char* kName = "free_text";

bool is_asked(const Script& script) { return script.free_text.has_value(); }

Page page(const AskedTrial& asked) {
  Page page;
  page.layout = Page::Layout::kForm;
  page.response = kName;
  page.title = asked.script.free_text->question;
  page.fields = {{kName, "", Field::Kind::kText, {}, 0.0, 0.0}};
  page.choices = {{"Continue", "enter"}};
  page.progress = asked.progress;
  return page;
}

void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) {
  ResponseRecord response = response_record(kName, asked.script.free_text->question, answer);
  response.answer = answer.fields.front();
  record.responses.push_back(response);
}

}  // namespace free_text_response

ResponseKind free_text_kind() {
  using namespace free_text_response;
  return {kName,
          "free_text",
          "after the stimulus",
          "response",
          {{"question", "the words above the text box"}},
          {},
          "ask",
          is_asked,
          nullptr,
          page,
          keep,
          nullptr};
}

}  // namespace impetus::inline questions
