// The fields of each record, listed once: lines are written and read by the same list.
//
// fields(record, each) calls each(name, member) for each field, in order; the record is constant
// when it is written. Names<E> are the words of an enum's values, in their order.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "experiments/lines/record_lines.hpp"

namespace impetus::inline lines {

/// Whether R is T, constant or not.
template <typename R, typename T>
concept MaybeConst = std::is_same_v<std::remove_const_t<R>, T>;

/// fields() of a type whose fields are called what their members are, at most 63 of them.
#define IMPETUS_FIELD(member) each(#member, record.member);
#define IMPETUS_FIELDS(Type, ...)                                         \
  inline void fields(MaybeConst<Type> auto& record, auto&& each) {        \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(IMPETUS_FIELD, __VA_ARGS__)) \
  }

IMPETUS_FIELDS(FactorLevel, factor, value)

IMPETUS_FIELDS(SolvedValue, pointer, value)

IMPETUS_FIELDS(ScreenGeometry, width_m, height_m, width_px, height_px, viewing_distance_m)

IMPETUS_FIELDS(SyncTest, tries, valid_flips, mean_interval_ns, sd_interval_ns, passed, verdict)

IMPETUS_FIELDS(SessionRecord, participant, seed, protocol_hash, build, machine, display, screen,
               screen_measured, refresh_hz, rounding_allowed, sync, gaze_source)

IMPETUS_FIELDS(PlannedTrial, slot, phase, repetition, condition, seed, block, catch_trial, track,
               solved, yoked_trial_id)

IMPETUS_FIELDS(ChosenLevel, slot, condition, state)

IMPETUS_FIELDS(ScreenPoint, x_m, y_m)

IMPETUS_FIELDS(GazeRegion, centre, radius_deg)

IMPETUS_FIELDS(NotFiniteBody, body, field)

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

IMPETUS_FIELDS(ImposedSpin, a, b)

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

IMPETUS_FIELDS(RatingRecord, rating, minimum, maximum, best, low_anchor, high_anchor, device,
               question_shown_ns, arrived_ns, arrival_uncertainty_ns)

IMPETUS_FIELDS(ClickRecord, device, arrived_ns, arrival_uncertainty_ns, interval)

IMPETUS_FIELDS(GazeSample, taken_ns, at, loss, interval)

IMPETUS_FIELDS(ResponseRecord, kind, question, answer, positive, correct, detail, device,
               question_shown_ns, arrived_ns, arrival_uncertainty_ns, timed_out)

IMPETUS_FIELDS(AttemptRecord, slot, number, outcome, onset_ns, body_names, wall_naming, steps,
               collisions, frames, ratings, clicks, gaze_source, gaze, region_covered_share,
               gaze_latency_p95_ms, intended_hold_s, realised_hold_s, late_untimed_frames,
               responses, interrupted_by, gaze_lost_share, imposed_gaze_latency_s)

IMPETUS_FIELDS(CalibrationPointRecord, shown, gaze, accuracy_deg, precision_rms_deg,
               precision_sd_deg, samples, lost)

IMPETUS_FIELDS(GazeCorrection, x0_m, xx, xy, y0_m, yx, yy)

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

#undef IMPETUS_FIELDS
#undef IMPETUS_FIELD

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
