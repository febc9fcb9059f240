// The examples of CONTRIBUTING.md, which the build takes from there, do what they say.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/observers/observer_kinds.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::inline questions {
const ResponseKind& confidence_kind();
}
namespace impetus::inline observers {
const ObserverKind& sceptic_observer();
}

namespace impetus::contributing_test {

/// The participant of the page's block of JSON.
std::unique_ptr<RatingObserver> sceptic(VirtualClock& clock) {
  const std::string page = shipped("CONTRIBUTING.md");
  const std::size_t begin = page.find("```json\n") + 8;
  const JsonDocument document =
      parse_json("sceptic.json", page.substr(begin, page.find("```", begin) - begin));
  const ObserverKind& kind = sceptic_observer();
  return kind.make(*kind.read(document), {1, "S01", clock, clock});
}

/// Asks how sure the sceptic is of a trial with so many collisions.
AttemptRecord asked_after(std::size_t collisions) {
  const auto question = confidence_kind().block.read({{"question", "How sure are you?"}});
  const PlannedTrial trial;
  const SessionProgress progress;
  const AskedTrial asked{trial, progress};
  VirtualClock clock;
  const auto participant = sceptic(clock);
  AttemptRecord record;
  record.collisions.resize(collisions);
  participant->witnessed(record, StagedScene{World({}, {}, {}), {}, {}});
  Answer answer;
  const Page page = question->page(asked).value();
  confidence_kind().simulate(page, *participant, answer);
  question->keep(asked, answer, record);
  EXPECT_EQ(page.response, "confidence");
  EXPECT_EQ(participant->ask(page).device, "simulated");
  return record;
}

TEST(Contributing, TheExamplesAskAnswerAndKeep) {
  EXPECT_EQ(asked_after(1).responses.front().answer, "3");
  EXPECT_EQ(asked_after(0).responses.front().answer, "1");
  EXPECT_EQ(asked_after(1).responses.front().question, "How sure are you?");
}

}  // namespace impetus::contributing_test
