// The fields of each record, listed once: lines are written and read by the same list.
//
// fields(record, each) calls each(name, member) for each field, in order; the record is constant
// when it is written. Names<E> are the words of an enum's values, in their order.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>

#include "experiments/lines/record_lines.hpp"

namespace impetus::inline lines {

/// Whether R is T, constant or not.
template <typename R, typename T>
concept MaybeConst = std::is_same_v<std::remove_const_t<R>, T>;

inline void fields(MaybeConst<FactorLevel> auto& level, auto&& each) {
  each("factor", level.factor);
  each("value", level.value);
}

inline void fields(MaybeConst<SolvedValue> auto& solved, auto&& each) {
  each("pointer", solved.pointer);
  each("value", solved.value);
}

inline void fields(MaybeConst<ScreenGeometry> auto& screen, auto&& each) {
  each("width_m", screen.width_m);
  each("height_m", screen.height_m);
  each("width_px", screen.width_px);
  each("height_px", screen.height_px);
  each("viewing_distance_m", screen.viewing_distance_m);
}

inline void fields(MaybeConst<SyncTest> auto& sync, auto&& each) {
  each("tries", sync.tries);
  each("valid_flips", sync.valid_flips);
  each("mean_interval_ns", sync.mean_interval_ns);
  each("sd_interval_ns", sync.sd_interval_ns);
  each("passed", sync.passed);
  each("verdict", sync.verdict);
}

inline void fields(MaybeConst<SessionRecord> auto& session, auto&& each) {
  each("participant", session.participant);
  each("seed", session.seed);
  each("protocol_hash", session.protocol_hash);
  each("build", session.build);
  each("machine", session.machine);
  each("display", session.display);
  each("screen", session.screen);
  each("screen_measured", session.screen_measured);
  each("refresh_hz", session.refresh_hz);
  each("rounding_allowed", session.rounding_allowed);
  each("sync", session.sync);
  each("gaze_source", session.gaze_source);
}

inline void fields(MaybeConst<PlannedTrial> auto& trial, auto&& each) {
  each("slot", trial.slot);
  each("phase", trial.phase);
  each("repetition", trial.repetition);
  each("condition", trial.condition);
  each("seed", trial.seed);
  each("block", trial.block);
  each("catch_trial", trial.catch_trial);
  each("track", trial.track);
  each("solved", trial.solved);
  each("yoked_trial_id", trial.yoked_trial_id);
}

inline void fields(MaybeConst<ChosenLevel> auto& chosen, auto&& each) {
  each("slot", chosen.slot);
  each("condition", chosen.condition);
  each("state", chosen.state);
}

inline void fields(MaybeConst<ScreenPoint> auto& point, auto&& each) {
  each("x_m", point.x_m);
  each("y_m", point.y_m);
}

inline void fields(MaybeConst<GazeRegion> auto& region, auto&& each) {
  each("centre", region.centre);
  each("radius_deg", region.radius_deg);
}

inline void fields(MaybeConst<NotFiniteBody> auto& found, auto&& each) {
  each("body", found.body);
  each("field", found.field);
}

inline void fields(MaybeConst<StepRecord> auto& step, auto&& each) {
  each("step", step.step);
  each("work_granted", step.work_granted);
  each("work_spent", step.work_spent);
  each("degradations", step.degradations);
  each("hash", step.state.hash);
  each("digests", step.state.bodies);
  each("fixation", step.gaze.fixation);
  each("fixation_taken_ns", step.gaze.taken_ns);
  each("fixation_age_ns", step.gaze.age_ns);
  each("region", step.gaze.region);
  each("shown_frame", step.shown_frame);
  each("pops", step.pops);
  each("stopped_short", step.stopped_short);
  each("largest_pop_deg", step.largest_pop_deg);
  each("interval", step.interval);
  each("not_finite", step.not_finite);
  each("cut_work", step.cut_work);
}

inline void fields(MaybeConst<ImposedSpin> auto& spin, auto&& each) {
  each("a", spin.a);
  each("b", spin.b);
}

inline void fields(MaybeConst<CollisionRecord> auto& collision, auto&& each) {
  each("step", collision.step);
  each("a", collision.report.bodies.a);
  each("b", collision.report.bodies.b);
  each("list", collision.report.list);
  each("level", collision.report.level);
  each("stopped", collision.report.stop);
  each("point_m", collision.report.contact.touch.point);
  each("normal", collision.report.contact.touch.normal);
  each("depth_m", collision.report.contact.touch.depth_m);
  each("approach_m_s", collision.report.approach_m_s);
  each("impulse_Ns", collision.report.impulse_Ns);
  each("imposed_hold_s", collision.report.imposed_hold_s);
  each("contacts", collision.report.contact_count);
  each("no_spin", collision.no_spin);
  each("eccentricity_deg", collision.eccentricity_deg);
  each("first_frame", collision.first_frame_shown);
  each("time_s", collision.time_s);
  each("gaze_eccentricity_deg", collision.gaze_eccentricity_deg);
  each("region_eccentricity_deg", collision.region_eccentricity_deg);
  each("interval", collision.interval);
  each("distance_m", collision.distance_m);
  each("speed_deg_s", collision.speed_deg_s);
  each("collision_speed_deg_s", collision.collision_speed_deg_s);
  each("priority", collision.priority);
  each("imposed_spin", collision.imposed_spin);
}

inline void fields(MaybeConst<FrameRecord> auto& frame, auto&& each) {
  each("frame", frame.frame);
  each("phase", frame.phase);
  each("shown_time_s", frame.shown_time_s);
  each("scheduled_ns", frame.flip.scheduled_ns);
  each("submitted_ns", frame.flip.submitted_ns);
  each("flipped_ns", frame.flip.flipped_ns);
  each("missed_slots", frame.flip.missed_slots);
  each("interval", frame.interval);
  each("patch", frame.patch);
}

inline void fields(MaybeConst<RatingRecord> auto& rating, auto&& each) {
  each("rating", rating.rating);
  each("minimum", rating.minimum);
  each("maximum", rating.maximum);
  each("best", rating.best);
  each("low_anchor", rating.low_anchor);
  each("high_anchor", rating.high_anchor);
  each("device", rating.device);
  each("question_shown_ns", rating.question_shown_ns);
  each("arrived_ns", rating.arrived_ns);
  each("arrival_uncertainty_ns", rating.arrival_uncertainty_ns);
}

inline void fields(MaybeConst<ClickRecord> auto& click, auto&& each) {
  each("device", click.device);
  each("arrived_ns", click.arrived_ns);
  each("arrival_uncertainty_ns", click.arrival_uncertainty_ns);
  each("interval", click.interval);
}

inline void fields(MaybeConst<GazeSample> auto& sample, auto&& each) {
  each("taken_ns", sample.taken_ns);
  each("at", sample.at);
  each("loss", sample.loss);
  each("interval", sample.interval);
}

inline void fields(MaybeConst<ResponseRecord> auto& response, auto&& each) {
  each("kind", response.kind);
  each("question", response.question);
  each("answer", response.answer);
  each("positive", response.positive);
  each("correct", response.correct);
  each("detail", response.detail);
  each("device", response.device);
  each("question_shown_ns", response.question_shown_ns);
  each("arrived_ns", response.arrived_ns);
  each("arrival_uncertainty_ns", response.arrival_uncertainty_ns);
  each("timed_out", response.timed_out);
}

inline void fields(MaybeConst<AttemptRecord> auto& attempt, auto&& each) {
  each("slot", attempt.slot);
  each("number", attempt.number);
  each("outcome", attempt.outcome);
  each("onset_ns", attempt.onset_ns);
  each("body_names", attempt.body_names);
  each("wall_naming", attempt.wall_naming);
  each("steps", attempt.steps);
  each("collisions", attempt.collisions);
  each("frames", attempt.frames);
  each("ratings", attempt.ratings);
  each("clicks", attempt.clicks);
  each("gaze_source", attempt.gaze_source);
  each("gaze", attempt.gaze);
  each("region_covered_share", attempt.region_covered_share);
  each("gaze_latency_p95_ms", attempt.gaze_latency_p95_ms);
  each("intended_hold_s", attempt.intended_hold_s);
  each("realised_hold_s", attempt.realised_hold_s);
  each("late_untimed_frames", attempt.late_untimed_frames);
  each("responses", attempt.responses);
  each("interrupted_by", attempt.interrupted_by);
  each("gaze_lost_share", attempt.gaze_lost_share);
  each("imposed_gaze_latency_s", attempt.imposed_gaze_latency_s);
}

inline void fields(MaybeConst<CalibrationPointRecord> auto& point, auto&& each) {
  each("shown", point.shown);
  each("gaze", point.gaze);
  each("accuracy_deg", point.accuracy_deg);
  each("precision_rms_deg", point.precision_rms_deg);
  each("precision_sd_deg", point.precision_sd_deg);
  each("samples", point.samples);
  each("lost", point.lost);
}

inline void fields(MaybeConst<GazeCorrection> auto& correction, auto&& each) {
  each("x0_m", correction.x0_m);
  each("xx", correction.xx);
  each("xy", correction.xy);
  each("y0_m", correction.y0_m);
  each("yx", correction.yx);
  each("yy", correction.yy);
}

inline void fields(MaybeConst<CalibrationRecord> auto& calibration, auto&& each) {
  each("calibration", calibration.kind);
  each("number", calibration.number);
  each("before_slot", calibration.before_slot);
  each("gaze_source", calibration.gaze_source);
  each("accuracy_deg", calibration.accuracy_deg);
  each("worst_accuracy_deg", calibration.worst_accuracy_deg);
  each("precision_rms_deg", calibration.precision_rms_deg);
  each("precision_sd_deg", calibration.precision_sd_deg);
  each("lost_share", calibration.lost_share);
  each("sampling_hz", calibration.sampling_hz);
  each("accuracy_limit_deg", calibration.accuracy_limit_deg);
  each("passed", calibration.passed);
  each("began_ns", calibration.began_ns);
  each("points", calibration.points);
  each("correction", calibration.correction);
}

inline void fields(MaybeConst<QuestionRecord> auto& question, auto&& each) {
  each("asked_as", question.kind);
  each("id", question.id);
  each("text", question.text);
  each("answer", question.answer);
}

inline void fields(MaybeConst<NoteRecord> auto& note, auto&& each) {
  each("of", note.kind);
  each("text", note.text);
}

inline void fields(MaybeConst<FinishedRecord> auto& /*finished*/, auto&& /*each*/) {}

template <typename E>
struct Names;
template <>
struct Names<TrialPhase> {
  static constexpr auto kAll = kTrialPhases;
};
template <>
struct Names<StateField> {
  static constexpr std::array kAll{"position", "orientation", "linear momentum",
                                   "angular momentum"};
};
template <>
struct Names<StopReason> {
  static constexpr auto kAll = kStopReasons;
};
template <>
struct Names<FramePhase> {
  static constexpr std::array kAll{"fixation", "stimulus"};
};
template <>
struct Names<GazeLoss> {
  static constexpr std::array kAll{"none", "blink", "off screen", "lost"};
};
template <>
struct Names<AttemptOutcome> {
  static constexpr std::array kAll{"completed", "interrupted"};
};
template <>
struct Names<WallNaming> {
  static constexpr std::array kAll{"axes", "view"};
};
template <>
struct Names<CalibrationKind> {
  static constexpr std::array kAll{"calibration", "validation", "drift check"};
};

}  // namespace impetus::inline lines
