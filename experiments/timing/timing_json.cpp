// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_json.hpp"

#include "experiments/timing/timing_verdicts.hpp"
#include "experiments/timing/timing_words.hpp"

namespace impetus::inline timing {
namespace {

using Json = nlohmann::ordered_json;

Json as_json(const Distribution& values) {
  if (values.count == 0) {
    return nullptr;
  }
  return {{"count", values.count},    {"mean", values.mean}, {"sd", values.sd},
          {"median", values.median},  {"p95", values.p95},   {"p99", values.p99},
          {"largest", values.largest}};
}

Json facts_json(const TimingFacts& facts) {
  return {{"build", facts.build},
          {"machine", facts.machine},
          {"started_utc", facts.started_utc},
          {"display", facts.display},
          {"compositor", facts.compositor},
          {"width_px", facts.width_px},
          {"height_px", facts.height_px},
          {"nominal_hz", facts.nominal_hz},
          {"seconds_per_part", facts.seconds}};
}

Json sync_json(const SyncTest& sync) {
  return {{"passed", sync.passed},
          {"tries", sync.tries},
          {"valid_flips", sync.valid_flips},
          {"mean_interval_ms", sync.mean_interval_ns / 1e6},
          {"sd_interval_ms", sync.sd_interval_ns / 1e6},
          {"verdict", sync.verdict}};
}

Json run_json(const FlipSeries& run) {
  const FlipStatistics& flips = run.statistics;
  return {{"bodies", run.bodies},
          {"flips", flips.flips},
          {"late", flips.late},
          {"missed_slots", flips.missed_slots},
          {"interval_ms", as_json(flips.interval_ms)},
          {"period_ms", flips.period_ms},
          {"period_standard_error_ms", flips.period_error_ms},
          {"drift_ppm", flips.drift_ppm},
          {"spread_about_slope_ms", flips.spread_ms},
          {"raw_interval_ms", run.intervals_ms},
          {"raw_missed_slots", run.missed_slots}};
}

/// Of the blank flips, where they follow the refresh; a timer's tell nothing of the display.
Json refresh_json(const TimingReport& report) {
  if (!report.sync.passed) {
    return nullptr;
  }
  const FlipStatistics& flips = report.runs.front().statistics;
  return {{"hz", flips.refresh_hz()},
          {"half_of_95_percent_interval_hz", flips.refresh_interval_hz()}};
}

Json input_json(const InputDelay& input) {
  return {{"device", input.device == InputDevice::kKey ? "key" : "mouse"},
          {"put_into", input.route == InputRoute::kQueue ? "queue" : "window system"},
          {"sent", input.sent},
          {"lost", input.lost},
          {"delay_ms", as_json(input.delay_ms())},
          {"within_stated_uncertainty_share", input.within_uncertainty_share},
          {"raw_delay_ms", input.delays_ms}};
}

Json gaze_json(const GazeRun& gaze) {
  return {{"source", gaze.source},
          {"latency_ms", as_json(distribution_of(gaze.latencies_ms))},
          {"share_above_40_ms", share_above(gaze.latencies_ms, kPromptGaze_ms)},
          {"share_above_80_ms", share_above(gaze.latencies_ms, kLateGaze_ms)},
          {"lost_share", gaze.lost_share},
          {"clock", gaze.clock.empty() ? Json() : Json(gaze.clock)},
          {"sample_interval_ms", as_json(distribution_of(gaze.intervals_ms))},
          {"raw_latency_ms", gaze.latencies_ms},
          {"raw_sample_interval_ms", gaze.intervals_ms}};
}

Json markers_json(const MarkerRun& markers) {
  if (markers.address.empty()) {
    return nullptr;
  }
  return {{"address", markers.address},
          {"sent", markers.delays_ms.size()},
          {"lost", markers.lost},
          {"delay_ms", as_json(distribution_of(markers.delays_ms))},
          {"raw_delay_ms", markers.delays_ms}};
}

Json sounds_json(const SoundRun& sounds) {
  if (sounds.device.empty()) {
    return nullptr;
  }
  return {{"device", sounds.device},
          {"lost", sounds.lost},
          {"off_ms", as_json(distribution_of(sounds.off_ms))},
          {"at_once_ms", as_json(distribution_of(sounds.at_once_ms))},
          {"raw_off_ms", sounds.off_ms},
          {"raw_at_once_ms", sounds.at_once_ms}};
}

Json content_json(const ContentRun& content) {
  if (!content.readable) {
    return nullptr;
  }
  return {{"corner", content.corner},
          {"frames", content.check.frames},
          {"wrong", content.check.wrong},
          {"unreadable", content.check.unreadable},
          {"first_wrong", content.check.first_wrong},
          {"longest_wrong", content.check.longest_wrong}};
}

Json verdicts_json(const TimingReport& report) {
  Json verdicts = Json::array();
  for (const TimingVerdict& verdict : timing_verdicts(report)) {
    verdicts.push_back({{"subject", verdict.subject},
                        {"measured", verdict.measured},
                        {"verdict", words_of(verdict.grade)},
                        {"criterion", verdict.criterion}});
  }
  return verdicts;
}

}  // namespace

nlohmann::ordered_json timing_json(const TimingReport& report) {
  Json runs = Json::array();
  for (const FlipSeries& run : report.runs) {
    runs.push_back(run_json(run));
  }
  Json inputs = Json::array();
  for (const InputDelay& input : report.inputs) {
    inputs.push_back(input_json(input));
  }
  return {{"schema_version", 1},
          {"facts", facts_json(report.facts)},
          {"overall", words_of(worst_of(timing_verdicts(report)))},
          {"verdicts", verdicts_json(report)},
          {"sync_test", sync_json(report.sync)},
          {"measured_refresh", refresh_json(report)},
          {"flips", std::move(runs)},
          {"inputs", std::move(inputs)},
          {"gaze_to_flip", gaze_json(report.gaze)},
          {"flip_to_marker", markers_json(report.markers)},
          {"sounds", sounds_json(report.sounds)},
          {"content", content_json(report.content)},
          {"methods", methods_paragraph(report)},
          {"not_known", what_is_not_known(report)}};
}

}  // namespace impetus::inline timing
