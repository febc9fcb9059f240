// One page of each kind that a participant meets, for the gallery.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/record/page.hpp"

namespace impetus {

inline const SessionProgress kSome{11, 81, "Trial 12 of 81"};

inline Page text(std::string title, std::vector<std::string> paragraphs,
                 std::vector<Choice> choices) {
  Page page;
  page.title = std::move(title);
  page.paragraphs = std::move(paragraphs);
  page.choices = std::move(choices);
  page.progress = kSome;
  return page;
}

inline Page consent() {
  Page page =
      text("Taking part",
           {"You are invited to take part in a study on how people see moving objects collide. "
            "You will watch short scenes with two balls and judge each one. There are no right "
            "or wrong answers.",
            "It takes about 20 minutes. We keep your answers and their times, your age and "
            "gender if you choose to give them, and nothing that names you. The data may be "
            "published without your name.",
            "Taking part is voluntary. You may pause or stop at any time with the Esc key, "
            "without giving a reason, and ask for your data to be deleted.",
            "Do you agree to take part?"},
           {{"Yes, I agree", "y"}, {"No, I do not", "n"}, {"Back", "b"}});
  page.choice_at_end = 0;
  page.statement = "I have read this and agree to take part; I may stop at any time.";
  return page;
}

inline Page long_text() {
  Page page = consent();
  const auto paragraphs = page.paragraphs;
  for (int copy = 0; copy < 4; ++copy) {
    page.paragraphs.insert(page.paragraphs.end(), paragraphs.begin(), paragraphs.end());
  }
  return page;
}

inline Page form() {
  Page page =
      text("About you", {"Leave empty what you would rather not say."}, {{"Continue", "enter"}});
  page.layout = Page::Layout::kForm;
  page.fields = {{"age", "Age in years", Field::Kind::kNumber, {}, 16, 99},
                 {"gender", "Gender", Field::Kind::kChoice, {"female", "male", "another"}, 0, 0},
                 {"sight", "Normal or corrected sight?", Field::Kind::kChoice, {"yes", "no"}, 0, 0},
                 {"games", "Hours of computer games in a week", Field::Kind::kNumber, {}, 0, 100}};
  return page;
}

inline Page question() {
  Page page = text("One question", {}, {{"Continue", "enter"}});
  page.layout = Page::Layout::kForm;
  page.fields = {{"strategy",
                  "How did you decide whether a collision was believable? Write as much as you "
                  "like.",
                  Field::Kind::kText,
                  {},
                  0,
                  0}};
  return page;
}

inline Page instructions() {
  return text("What you will see",
              {"In each trial a cross appears first: keep your eyes on it. Then two balls move "
               "towards each other, meet, and part.",
               "Afterwards you say how believable the collision looked, from 1 to 5. Answer by "
               "your first impression; times are not compared between people.",
               "A few practice trials come first. Greek and signs: α β Δ ≤ ½ × – “quoted”."},
              {{"Continue", "space"}});
}

inline Page rating() {
  Page page;
  page.layout = Page::Layout::kScale;
  page.title = "How believable was the collision?";
  page.choices = {{"1", "1"}, {"2", "2"}, {"3", "3"}, {"4", "4"}, {"5", "5"}};
  page.low_anchor = "Not believable at all";
  page.high_anchor = "Very believable";
  page.progress = kSome;
  return page;
}

inline Page rest() {
  return text("Time for a break",
              {"Look away from the screen for a moment.", "27 of 81 trials are done and saved."},
              {{"Continue", "space"}});
}

inline Page pause() {
  Page page = text("Pause",
                   {"Everything you have answered is saved.",
                    "If you pause within a trial, it is shown again from its start."},
                   {{"Continue", "space"}, {"Quit", "q"}});
  page.can_pause = false;
  return page;
}

inline Page thanks() {
  Page page = text("Thank you",
                   {"That was the last trial, and everything is saved. Please call "
                    "the experimenter."},
                   {{"Close", "space"}});
  page.progress = {81, 81, "Done"};
  page.can_pause = false;
  return page;
}

}  // namespace impetus
