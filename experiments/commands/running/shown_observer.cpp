// SPDX-License-Identifier: MIT
#include "experiments/commands/running/shown_observer.hpp"

namespace impetus::inline commands {

ShownObserver::ShownObserver(const ObserverFile& observer, std::uint64_t seed,
                             const std::string& participant, Window& window, const Clock& clock)
    : observer_(make_observer(observer, {seed, participant, own_time_, clock})),
      window_(window),
      clock_(clock) {}

Answer ShownObserver::ask(const Page& page) {
  // A person who watches may pause or quit; those pages are theirs to answer.
  if (!page.can_pause && page.choices.size() > 1) {
    return window_.ask(page);
  }
  Answer answer = observer_->ask(page);
  const double seconds = static_cast<double>(answer.arrived_ns - answer.shown_ns) / 1e9;
  answer.shown_ns = clock_.now_ns();
  window_.show_page_for(page, seconds,
                        answer.timed_out ? std::nullopt : std::optional(answer.choice));
  answer.arrived_ns = clock_.now_ns();
  answer.interruption = window_.interruption();
  return answer;
}

}  // namespace impetus::inline commands
