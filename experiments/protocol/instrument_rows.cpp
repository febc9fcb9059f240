// SPDX-License-Identifier: MIT
#include "experiments/protocol/instrument_rows.hpp"

namespace impetus::inline protocol {
namespace {

Kind<std::int64_t> times() { return whole<std::int64_t>({1, 20}); }

Kind<CalibrationTask> calibration_kind() {
  using C = CalibrationTask;
  const Kind<double> limit = number(above(0, 20));
  return object<C>(
      "Before practice: nine points over 80 % of the screen, then a validation by nine over 60 %; "
      "a drift check at breaks.",
      {required("accuracy_limit_deg", &C::accuracy_limit_deg, limit,
                "A validation with a mean distance of gaze from point above this is repeated."),
       row("most_tries", &C::most_tries, times(),
           "Then the experimenter decides; 3 when left out."),
       row("drift_limit_deg", &C::drift_limit_deg, limit,
           "A drift check worse than this asks for a calibration; 2 when left out."),
       row("point_ms", &C::point_ms, number({200, 10000}),
           "For which each point is shown; 1000 when left out."),
       row("show_accuracy", &C::show_accuracy, flag(),
           "Participants read in degrees how well they did; false when left out.")});
}

Kind<GazeLossRule> gaze_loss_kind() {
  using G = GazeLossRule;
  return object<G>(
      "What becomes of a trial in which the gaze was lost for more than a share of the stimulus; "
      "marked when more than half was lost, when left out.",
      {required("most_lost_share", &G::most_lost_share, number({0, 1})),
       required("then", &G::policy,
                choice<G::Policy>({{"keep", G::Policy::kKeep},
                                   {"mark", G::Policy::kMark},
                                   {"repeat", G::Policy::kRepeat}}),
                "keep: nothing. mark: it is marked. repeat: it is shown again at once, then kept "
                "and marked."),
       row("most_repeats", &G::most_repeats, times(), "Of a trial; 2 when left out.")});
}

Kind<YokeRule> yoke_kind() {
  using Y = YokeRule;
  return object<Y>(
      "For levels of a factor that set the region's kind to recorded: another participant of the "
      "study, whose gaze in the same condition, tracked, and repetition the region follows. "
      "previous: the last one before this who has finished. least-followed: of those who have "
      "finished, the first whom the fewest others follow. Neither is one who is excluded.",
      {required("participant", &Y::participant, text(), "A code, previous or least-followed."),
       row("protocol", &Y::protocol, text(),
           "The name of the one in which they were recorded; this one when left out.")});
}

Kind<GazeTask> gaze_kind() {
  using G = GazeTask;
  return object<G>(
      "The gaze is followed during the stimulus; the mouse stands in for the eye where there is no "
      "eye-tracker.",
      {required("extra_latency_ms", &G::extra_latency_ms, number({0, 10000}),
                "Imposed: samples younger than this are not used yet. The scene's "
                "/imposed/gaze_latency_ms is added to it, and can be a factor."),
       row("calibration", &G::calibration, calibration_kind()),
       row("when_lost", &G::loss, gaze_loss_kind()), row("yoked_to", &G::yoked_to, yoke_kind())});
}

}  // namespace

Row<Script> gaze_row() { return row("gaze", &Script::gaze, gaze_kind()); }

Row<Script> markers_row() {
  using M = MarkerCodes;
  const Kind<std::int64_t> code = whole<std::int64_t>({1, 255});
  return row(
      "markers", &Script::markers,
      object<M>(
          "Codes for another recorder, such as an EEG's amplifier, sent right after the flip "
          "that shows the event: `impetus run --markers` says where to. What has no code is "
          "not marked.",
          {row("fixation", &M::fixation, code, "The flip that first shows the cross."),
           row("onset", &M::onset, code, "The flip that first shows the stimulus."),
           row("contact", &M::contact, code, "Each flip that is the first to show a collision."),
           row("end", &M::end, code, "The flip that shows the stimulus for the last time."),
           row("click", &M::click, code, "A click during the stimulus, once it was taken."),
           row("answer", &M::answer, code, "An answer, once it was taken.")}));
}

}  // namespace impetus::inline protocol
