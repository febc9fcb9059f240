// SPDX-License-Identifier: MIT
#include "experiments/session/conversation.hpp"

#include "experiments/questions/session_pages.hpp"

namespace impetus::inline session {

namespace {

/// A page of which every text was switched off, and that leads on only.
bool says_nothing(const Page& page) {
  return page.title.empty() && page.paragraphs.empty() && page.statement.empty() &&
         page.fields.empty() && page.point_map.points.empty() && page.choices.size() == 1;
}

}  // namespace

std::optional<Answer> Conversation::ask(const Page& page) {
  if (says_nothing(page)) {
    return Answer{};
  }
  Page shown = page;
  while (true) {
    Answer answer = input_.ask(shown);
    if (answer.interruption == Interruption::kNone) {
      return answer;
    }
    if (!handle(answer.interruption)) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < answer.fields.size(); ++i) {
      shown.fields[i].answer = answer.fields[i];
    }
  }
}

bool Conversation::handle(Interruption interruption) {
  return interruption == Interruption::kPauseRequested ? pause() : display_closed();
}

bool Conversation::pause() {
  recorder_.save(NoteRecord{"pause", standing_.progress().label});
  while (true) {
    const Answer answer = input_.ask(pause_page(standing_.progress()));
    if (answer.interruption == Interruption::kDisplayClosed) {
      return display_closed();
    }
    if (answer.choice == kContinueChoice) {
      recorder_.save(NoteRecord{"continue", ""});
      return true;
    }
    const Answer sure = input_.ask(quit_page(standing_.progress()));
    if (sure.interruption == Interruption::kDisplayClosed) {
      return display_closed();
    }
    if (sure.choice == kQuitChoice) {
      recorder_.save(NoteRecord{"quit", ""});
      return end(SessionEnding::kQuit);
    }
  }
}

bool Conversation::display_closed() {
  recorder_.save(NoteRecord{"display closed", ""});
  return end(SessionEnding::kDisplayClosed);
}

bool Conversation::end(SessionEnding ending) {
  ending_ = ending;
  return false;
}

}  // namespace impetus::inline session
