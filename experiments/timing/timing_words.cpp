// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_words.hpp"

#include <cstdio>

#include "experiments/timing/timing_verdicts.hpp"

namespace impetus::inline timing {
namespace {

std::string display_sentences(const TimingReport& report) {
  const TimingFacts& facts = report.facts;
  const FlipStatistics& flips = report.runs.front().statistics;
  std::string text = "Stimuli were shown by Impetus (" + facts.build + ") on " + facts.machine +
                     ", in a window of " + std::to_string(facts.width_px) + " × " +
                     std::to_string(facts.height_px) + " pixels (" + facts.display +
                     "; compositor: " + facts.compositor + "). ";
  if (report.sync.passed) {
    text += "Flips waited for the refresh, whose rate was " + decimal(flips.refresh_hz(), 4) +
            " Hz (95 % confidence interval ± " + decimal(flips.refresh_interval_hz(), 4) +
            " Hz; nominal " + decimal(facts.nominal_hz, 2) +
            " Hz), and were stamped when the swap returned. ";
  } else {
    text += "Flips were not synchronised to the display: a timer of " +
            decimal(facts.nominal_hz, 2) +
            " Hz paced them, and their stamps say when the program handed over a frame, not when "
            "the screen changed. ";
  }
  return text;
}

std::string flip_sentences(const TimingReport& report) {
  const FlipStatistics& flips = report.runs.front().statistics;
  const Distribution& interval = flips.interval_ms;
  std::string text = "Over " + std::to_string(flips.flips) +
                     " flips of a blank picture on an absolute grid, intervals had a median of " +
                     decimal(interval.median, 2) + " ms (95th percentile " +
                     decimal(interval.p95, 2) + ", 99th " + decimal(interval.p99, 2) +
                     ", longest " + decimal(interval.largest, 2) + ", standard deviation " +
                     decimal(interval.sd, 3) + " ms); after a slope was fitted (drift " +
                     decimal(flips.drift_ppm, 1) + " ppm) stamps spread by " +
                     decimal(flips.spread_ms, 3) + " ms. Late were ";
  for (std::size_t i = 1; i < report.runs.size(); ++i) {
    const FlipSeries& run = report.runs[i];
    text += (i == 1                        ? ""
             : i + 1 == report.runs.size() ? " and "
                                           : ", ") +
            std::to_string(run.statistics.late) + " of " + std::to_string(run.statistics.flips) +
            " frames with " + pictured(run.bodies);
  }
  return text + ", simulated and drawn. ";
}

std::string input_sentences(const TimingReport& report) {
  std::string text;
  for (const InputDelay& input : report.inputs) {
    if (input.route == InputRoute::kWindowSystem && !input.delays_ms.empty()) {
      const Distribution delay = input.delay_ms();
      text += std::string(input.device == InputDevice::kKey ? "Key presses" : "Mouse movements") +
              " were stamped " + decimal(delay.median, 2) + " ms (median; 95th percentile " +
              decimal(delay.p95, 2) + ") after they were put into the window system. ";
    }
  }
  return text;
}

std::string gaze_sentence(const TimingReport& report) {
  if (report.gaze.latencies_ms.empty()) {
    return "";
  }
  const Distribution latency = distribution_of(report.gaze.latencies_ms);
  return "From a sample of the gaze (" + report.gaze.source +
         ") to the return of the flip that first showed what it decided went " +
         decimal(latency.median, 1) + " ms (median; 95th percentile " + decimal(latency.p95, 1) +
         "). " + (report.gaze.clock.empty() ? "" : "Of its stamps: " + report.gaze.clock + ". ");
}

std::string marker_sentence(const MarkerRun& markers) {
  if (markers.delays_ms.empty()) {
    return "";
  }
  const Distribution delay = distribution_of(markers.delays_ms);
  return "Markers for another recorder were handed to the system " + decimal(delay.median, 2) +
         " ms after the return of the flip that they mark (median; 99th percentile " +
         decimal(delay.p99, 2) + "). ";
}

std::string sound_sentence(const SoundRun& sounds) {
  if (sounds.off_ms.empty()) {
    return "";
  }
  const Distribution off = distribution_of(sounds.off_ms);
  return "Sounds (" + sounds.device + ") that were foreseen left the device's buffer " +
         decimal(off.mean, 2) + " ms (mean; standard deviation " + decimal(off.sd, 2) +
         ") from when they were to begin" +
         (sounds.at_once_ms.empty()
              ? ". "
              : ", others " + decimal(distribution_of(sounds.at_once_ms).median, 1) +
                    " ms (median) after the flip. ");
}

std::string content_sentence(const TimingReport& report) {
  const ContentCheck& check = report.content.check;
  return report.content.readable
             ? "Read back from the window system, " +
                   std::to_string(check.frames - check.wrong - check.unreadable) + " of " +
                   std::to_string(check.frames) + " coded frames were the planned ones. "
             : "";
}

}  // namespace

std::string methods_paragraph(const TimingReport& report) {
  return display_sentences(report) + flip_sentences(report) + input_sentences(report) +
         gaze_sentence(report) + marker_sentence(report.markers) + sound_sentence(report.sounds) +
         content_sentence(report) +
         "No figure includes the lag of the screen, the keyboard, the mouse, an eye tracker or a "
         "loudspeaker.";
}

std::vector<std::string> what_is_not_known(const TimingReport& report) {
  std::vector<std::string> sentences{
      "When light left the screen: only a photodiode on the glass tells (impetus run --photodiode "
      "\"bottom left\" draws a coded patch for one). Screens change from top to bottom within 5 to "
      "15 ms and may hold a frame back for one or more refreshes.",
      "The lag of the input devices: keyboards add 4 to 25 ms and mice several, which no software "
      "can see. What was put in here began in the software."};
  if (report.sync.passed) {
    sentences.emplace_back(
        "What the return of a swap means: the driver says that the frame was handed to the "
        "display. A driver or compositor that says so early is found by a photodiode alone.");
  } else {
    sentences.emplace_back(
        "The refresh rate of the display and when it shows a frame: flips do not follow it here, "
        "so every stamp may be off by a refresh or more.");
  }
  if (report.facts.compositor == "running") {
    sentences.emplace_back(
        "What the compositor does: it may show a frame one refresh later than handed over, or "
        "drop it. Switch it off for a study where that can be done.");
  }
  sentences.emplace_back(
      "What the patch cannot show: the read-back tells which frame the window system held, not "
      "which one the screen lit.");
  if (!report.markers.address.empty()) {
    sentences.emplace_back(
        "When the other recorder got a marker: the system takes it, a port of 115200 baud needs "
        "another .09 ms for it, and an adapter for USB up to 16. Record the photodiode's patch and "
        "the markers side by side.");
  }
  if (!report.sounds.device.empty()) {
    sentences.emplace_back(
        "When a sound was in the air: the sound system behind the device's buffer, the card and "
        "the loudspeaker add what only a microphone beside a photodiode tells.");
  }
  if (!report.gaze.clock.empty()) {
    sentences.emplace_back(
        "How old a picture of the eye is when its tracker stamps it: only the tracker's maker "
        "knows.");
  }
  if (report.gaze.source == "mouse") {
    sentences.emplace_back(
        "The latency of an eye tracker: the mouse stood in for it, sampled when a frame was "
        "begun.");
  }
  return sentences;
}

}  // namespace impetus::inline timing
