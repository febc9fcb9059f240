// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_verdicts.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline timing {
namespace {

/// Up to `good` is good, up to `care` needs care. In the unit of what is measured.
struct Limits {
  double good;
  double care;
};

constexpr Limits kSpread_ms{0.5, 2.0};        // good platforms: .18 to .34 (Bridges et al. 2020)
constexpr Limits kDrift_ppm{500.0, 10000.0};  // half a millisecond in a second; the sync test's 1 %
constexpr Limits kLateShare{0.0, 0.01};
constexpr Limits kInput_ms{2.0, 10.0};  // p95
constexpr Limits kMarker_ms{1.0, 5.0};  // p99; an EEG is sampled every 1 to 4 ms
constexpr Limits kSound_ms{1.0, 5.0};
constexpr Limits kSoundAtOnce_ms{20.0, 50.0};  // p95; of a contact and its sound, ours
constexpr Limits kGazeLost{0.05, 0.2};         // shares of the time
constexpr Limits kGaze_ms{60.0, 80.0};         // p95; no change was noticed up to 60 (Loschky 2007)

std::vector<double> magnitudes(std::vector<double> values) {
  std::transform(values.begin(), values.end(), values.begin(),
                 [](double value) { return std::abs(value); });
  return values;
}

TimingGrade graded(double value, const Limits& limits) {
  return value <= limits.good   ? TimingGrade::kGood
         : value <= limits.care ? TimingGrade::kWithCare
                                : TimingGrade::kNotForTiming;
}

/// Stamps that are anchored to nothing say when the program was ready, not when the screen changed.
TimingGrade of_stamps(const TimingReport& report, TimingGrade grade) {
  return report.sync.passed ? grade : std::max(grade, TimingGrade::kWithCare);
}

/// The criterion of a line that of_stamps() grades.
std::string for_stamps(const TimingReport& report, const std::string& criterion) {
  return report.sync.passed ? criterion : criterion + "; never good without synchronisation";
}

std::string limits_in_words(const Limits& limits, double factor, const std::string& unit) {
  return printed("good up to %g%s, with care up to %g%s", limits.good * factor, unit.c_str(),
                 limits.care * factor, unit.c_str());
}

TimingVerdict sync_verdict(const TimingReport& report) {
  return {"Flips follow the refresh", report.sync.verdict,
          report.sync.passed ? TimingGrade::kGood : TimingGrade::kNotForTiming,
          "good: at least 50 flips within 20 % of nominal, mean within 1 % and known to 0.2 ms"};
}

TimingVerdict spread_verdict(const TimingReport& report) {
  const FlipStatistics& flips = report.runs.front().statistics;
  return {"Spread of flips about their slope",
          decimal(flips.spread_ms, 3) + " ms over " + std::to_string(flips.flips) + " flips",
          of_stamps(report, graded(flips.spread_ms, kSpread_ms)),
          for_stamps(report, limits_in_words(kSpread_ms, 1.0, " ms"))};
}

TimingVerdict drift_verdict(const TimingReport& report) {
  const FlipStatistics& flips = report.runs.front().statistics;
  return {"Drift against the nominal rate", decimal(flips.drift_ppm, 1) + " ppm",
          of_stamps(report, graded(std::abs(flips.drift_ppm), kDrift_ppm)),
          for_stamps(report, limits_in_words(kDrift_ppm, 1.0, " ppm") + " either way")};
}

TimingVerdict late_verdict(const TimingReport& report, const FlipSeries& run) {
  const FlipStatistics& flips = run.statistics;
  const std::string text = printed("%lld of %lld (%.2f %%)", static_cast<long long>(flips.late),
                                   static_cast<long long>(flips.flips), 100.0 * flips.late_share());
  return {"Late frames with " + pictured(run.bodies), text,
          of_stamps(report, graded(flips.late_share(), kLateShare)),
          for_stamps(report, limits_in_words(kLateShare, 100.0, " %"))};
}

TimingVerdict input_verdict(const InputDelay& input) {
  const std::string subject = "Arrival of " + described(input);
  const std::string rule = "95th percentile: " + limits_in_words(kInput_ms, 1.0, " ms");
  if (input.sent == 0) {
    return {subject, "could not be sent on this machine", TimingGrade::kNotKnown, rule};
  }
  const Distribution delay = input.delay_ms();
  std::string measured = "median " + decimal(delay.median, 2) + " ms, 95th percentile " +
                         decimal(delay.p95, 2) + " ms, longest " + decimal(delay.largest, 2) +
                         " ms of " + std::to_string(input.sent);
  TimingGrade grade = graded(delay.p95, kInput_ms);
  if (input.lost > 0) {
    measured += "; " + std::to_string(input.lost) + " did not arrive";
    grade = delay.count == 0 ? TimingGrade::kNotKnown : std::max(grade, TimingGrade::kWithCare);
  }
  return {subject, measured, grade, rule};
}

TimingVerdict gaze_verdict(const TimingReport& report) {
  const std::string rule = "95th percentile: " + limits_in_words(kGaze_ms, 1.0, " ms");
  const std::vector<double>& latencies = report.gaze.latencies_ms;
  if (latencies.empty()) {
    return {"Gaze sample to flip", "there was no gaze", TimingGrade::kNotKnown, rule};
  }
  const Distribution latency = distribution_of(latencies);
  return {"Gaze sample to flip (" + report.gaze.source + ")",
          "median " + decimal(latency.median, 1) + " ms, 95th percentile " +
              decimal(latency.p95, 1) + " ms; above " + decimal(kPromptGaze_ms, 0) + " ms " +
              decimal(100.0 * share_above(latencies, kPromptGaze_ms), 1) + " %, above " +
              decimal(kLateGaze_ms, 0) + " ms " +
              decimal(100.0 * share_above(latencies, kLateGaze_ms), 1) + " %",
          graded(latency.p95, kGaze_ms), rule};
}

/// What the samples' stamps tell; nothing of a mouse, which is asked once a frame.
TimingVerdict sample_verdict(const GazeRun& gaze) {
  const Distribution interval = distribution_of(gaze.intervals_ms);
  return {"Samples of " + gaze.source,
          decimal(interval.median > 0.0 ? 1e3 / interval.median : 0.0, 1) +
              " a second, intervals with a standard deviation of " + decimal(interval.sd, 2) +
              " ms, longest " + decimal(interval.largest, 1) + " ms; without a place " +
              decimal(100.0 * gaze.lost_share, 1) + " % of the time; " + gaze.clock,
          graded(gaze.lost_share, kGazeLost),
          "without a place: " + limits_in_words(kGazeLost, 100.0, " %")};
}

TimingVerdict marker_verdict(const MarkerRun& markers) {
  const std::string subject = "Flip to marker (" + markers.address + ")";
  const std::string rule = "99th percentile: " + limits_in_words(kMarker_ms, 1.0, " ms");
  if (markers.delays_ms.empty()) {
    return {subject,
            markers.lost == 0 ? "nothing happened that is marked"
                              : "none of " + std::to_string(markers.lost) + " was taken",
            markers.lost == 0 ? TimingGrade::kNotKnown : TimingGrade::kNotForTiming, rule};
  }
  const Distribution delay = distribution_of(markers.delays_ms);
  const TimingGrade grade = graded(delay.p99, kMarker_ms);
  return {subject,
          "median " + decimal(delay.median, 2) + " ms, 99th percentile " + decimal(delay.p99, 2) +
              " ms of " + std::to_string(delay.count) +
              (markers.lost == 0 ? "" : "; " + std::to_string(markers.lost) + " were not taken"),
          markers.lost == 0 ? grade : std::max(grade, TimingGrade::kWithCare), rule};
}

/// `values` went by the clock: graded by their 95th percentile.
TimingVerdict sound_verdict(const std::string& subject, const SoundRun& sounds,
                            const std::vector<double>& values, const Limits& limits) {
  const std::string rule = "95th percentile, either way: " + limits_in_words(limits, 1.0, " ms");
  if (values.empty()) {
    return {subject, "no sound left the device: " + sounds.device,
            sounds.lost == 0 ? TimingGrade::kNotKnown : TimingGrade::kNotForTiming, rule};
  }
  const Distribution delay = distribution_of(values);
  const double off_ms = distribution_of(magnitudes(values)).p95;
  return {subject,
          "mean " + decimal(delay.mean, 2) + " ms, standard deviation " + decimal(delay.sd, 2) +
              " ms, longest " + decimal(delay.largest, 2) + " ms of " +
              std::to_string(delay.count) + "; " + sounds.device +
              (sounds.lost == 0 ? "" : "; " + std::to_string(sounds.lost) + " were not played"),
          sounds.lost == 0 ? graded(off_ms, limits)
                           : std::max(graded(off_ms, limits), TimingGrade::kWithCare),
          rule};
}

TimingVerdict content_verdict(const TimingReport& report) {
  const ContentCheck& check = report.content.check;
  TimingVerdict verdict{"Frames as planned, by the coded patch", "",
                        check.all_as_planned() ? TimingGrade::kGood : TimingGrade::kNotForTiming,
                        "good: every frame that the window system held was the planned one"};
  if (!report.content.readable) {
    verdict.measured = "the window system cannot be asked for what it shows";
    verdict.grade = TimingGrade::kNotKnown;
    return verdict;
  }
  verdict.measured = std::to_string(check.wrong) + " of " + std::to_string(check.frames) +
                     " frames differed from plan, " + std::to_string(check.unreadable) +
                     " could not be read";
  if (check.first_wrong >= 0) {
    verdict.measured += "; the first was frame " + std::to_string(check.first_wrong);
  }
  return verdict;
}

}  // namespace

const char* words_of(TimingGrade grade) {
  switch (grade) {
    case TimingGrade::kGood:
      return "good";
    case TimingGrade::kWithCare:
      return "with care";
    case TimingGrade::kNotForTiming:
      return "not for timing studies";
    default:
      return "not known";
  }
}

std::vector<TimingVerdict> timing_verdicts(const TimingReport& report) {
  std::vector<TimingVerdict> verdicts{sync_verdict(report), spread_verdict(report),
                                      drift_verdict(report)};
  for (const FlipSeries& run : report.runs) {
    verdicts.push_back(late_verdict(report, run));
  }
  for (const InputDelay& input : report.inputs) {
    verdicts.push_back(input_verdict(input));
  }
  verdicts.push_back(gaze_verdict(report));
  if (!report.gaze.clock.empty()) {
    verdicts.push_back(sample_verdict(report.gaze));
  }
  if (!report.markers.address.empty()) {
    verdicts.push_back(marker_verdict(report.markers));
  }
  if (!report.sounds.device.empty()) {
    verdicts.push_back(sound_verdict("Sounds that were foreseen, from when they were to begin",
                                     report.sounds, report.sounds.off_ms, kSound_ms));
    verdicts.push_back(sound_verdict("Flip to a sound that nobody foresaw", report.sounds,
                                     report.sounds.at_once_ms, kSoundAtOnce_ms));
  }
  verdicts.push_back(content_verdict(report));
  return verdicts;
}

TimingGrade worst_of(const std::vector<TimingVerdict>& verdicts) {
  TimingGrade worst = TimingGrade::kGood;
  for (const TimingVerdict& verdict : verdicts) {
    if (verdict.grade != TimingGrade::kNotKnown) {
      worst = std::max(worst, verdict.grade);
    }
  }
  return worst;
}

std::string decimal(double value, int digits) { return printed("%.*f", digits, value); }

std::string pictured(int bodies) {
  return bodies == 0 ? "a blank picture" : count_of(bodies, "body", "bodies");
}

std::string described(const InputDelay& input) {
  return std::string(input.device == InputDevice::kKey ? "key presses" : "mouse movements") +
         " put into " +
         (input.route == InputRoute::kQueue ? "the program's queue" : "the window system");
}

}  // namespace impetus::inline timing
