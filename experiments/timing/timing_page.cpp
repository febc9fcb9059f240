// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_page.hpp"

#include <algorithm>
#include <vector>

#include "experiments/tables/number_text.hpp"
#include "experiments/timing/timing_verdicts.hpp"
#include "experiments/timing/timing_words.hpp"

namespace impetus::inline timing {
namespace {

// A run of flips as a small picture for the page: one dot per interval, over time.

constexpr double kWidth = 640.0;
constexpr double kHeight = 96.0;
constexpr double kMargin = 44.0;  // for the numbers on the left
constexpr double kPeriods = 3.0;

double height_of(double interval_ms, double period_ms) {
  const double share = std::min(1.0, interval_ms / (kPeriods * period_ms));
  return kHeight * (1.0 - share);
}

std::string period_line(int periods, double period_ms) {
  const double y = height_of(periods * period_ms, period_ms);
  return printed(
      "<line x1='%g' x2='%g' y1='%.1f' y2='%.1f' stroke='#ccc'/>"
      "<text x='%g' y='%.1f' text-anchor='end'>%.1f</text>",
      kMargin, kWidth, y, y, kMargin - 4.0, y + 4.0, periods * period_ms);
}

/// An SVG element whose height is three nominal periods; longer intervals lie on its upper edge.
std::string flip_plot(const FlipSeries& run, double nominal_hz) {
  const double period_ms = 1e3 / nominal_hz;
  const std::string opening =
      printed("<svg viewBox='0 -6 %g %g' width='%g' role='img' aria-label='", kWidth + 6.0,
              kHeight + 14.0, kWidth);
  std::string svg = opening + ("intervals with " + pictured(run.bodies)) + "'>";
  svg += period_line(1, period_ms) + period_line(2, period_ms);
  const auto count = static_cast<double>(run.intervals_ms.size());
  for (std::size_t i = 0; i < run.intervals_ms.size(); ++i) {
    const bool late = run.missed_slots[i + 1] > 0;
    const std::string dot = printed("<circle cx='%.1f' cy='%.1f' r='%s' fill='%s'/>",
                                    kMargin + (kWidth - kMargin) * static_cast<double>(i) / count,
                                    height_of(run.intervals_ms[i], period_ms), late ? "2.5" : "1.2",
                                    late ? "#c0392b" : "#2c5f8a");
    svg += dot;
  }
  return svg + "</svg>";
}

constexpr const char* kStyle = R"css(
body{font:16px/1.45 "DejaVu Sans",system-ui,sans-serif;color:#222;max-width:60em;margin:2em auto;
padding:0 1em}h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em}table{border-collapse:collapse;
width:100%}th,td{text-align:left;padding:.3em .6em;border-bottom:1px solid #ddd;vertical-align:top}
td.n,th.n{text-align:right;white-space:nowrap}.good{color:#1d6b37}.care{color:#8a5a00}
.not{color:#a3221b}.unknown{color:#666}b.grade{white-space:nowrap}small,svg text{color:#666}
svg text{font-size:10px;fill:#666}blockquote{margin:0;padding:.8em 1em;background:#f3f3f1}
)css";

using Cells = std::vector<std::string>;

const char* css_class(TimingGrade grade) {
  switch (grade) {
    case TimingGrade::kGood:
      return "good";
    case TimingGrade::kWithCare:
      return "care";
    case TimingGrade::kNotForTiming:
      return "not";
    default:
      return "unknown";
  }
}

std::string grade_of(TimingGrade grade) {
  return std::string("<b class='grade ") + css_class(grade) + "'>" + words_of(grade) + "</b>";
}

/// `tag` is "td" or "th"; all but the first cell are numbers. The cells are HTML.
std::string number_row(const char* tag, const Cells& cells) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row += std::string("<") + tag + (i == 0 ? ">" : " class='n'>") + cells[i] + "</" + tag + ">";
  }
  return row + "</tr>\n";
}

std::string facts_table(const TimingFacts& facts) {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"Build", facts.build},
      {"Machine", facts.machine},
      {"Display", facts.display},
      {"Window", std::to_string(facts.width_px) + " × " + std::to_string(facts.height_px) + " px"},
      {"Compositor", facts.compositor},
      {"Measured", facts.started_utc + ", " + decimal(facts.seconds, 0) + " s each part"}};
  std::string table = "<table>\n";
  for (const auto& [name, value] : rows) {
    table += "<tr><th>" + name + "</th><td>" + html_text(value) + "</td></tr>\n";
  }
  return table + "</table>\n";
}

std::string verdict_table(const std::vector<TimingVerdict>& verdicts) {
  std::string table = "<table>\n<tr><th>What</th><th>Measured</th><th>Verdict</th></tr>\n";
  for (const TimingVerdict& verdict : verdicts) {
    table += "<tr><td>" + html_text(verdict.subject) + "</td><td>" + html_text(verdict.measured) +
             "<br><small>" + html_text(verdict.criterion) + "</small></td><td>" +
             grade_of(verdict.grade) + "</td></tr>\n";
  }
  return table + "</table>\n";
}

std::string refresh_sentence(const TimingReport& report) {
  const FlipStatistics& flips = report.runs.front().statistics;
  const std::string nominal = "Nominal refresh: " + decimal(report.facts.nominal_hz, 2) + " Hz. ";
  if (!report.sync.passed) {
    return nominal +
           "The true one could not be measured: nothing waits for the display here, and a timer "
           "paces the flips. Their stamps are anchored to nothing.";
  }
  return nominal + "Measured: " + decimal(flips.refresh_hz(), 4) + " ± " +
         decimal(flips.refresh_interval_hz(), 4) +
         " Hz (95 % confidence interval). Stamps are taken when a swap returns that waits for the "
         "refresh.";
}

std::string flip_table(const std::vector<FlipSeries>& runs) {
  std::string table =
      "<table>\n" + number_row("th", {"Picture", "flips", "late", "median", "95th", "99th",
                                      "longest", "SD", "spread about slope", "drift, ppm"});
  for (const FlipSeries& run : runs) {
    const FlipStatistics& flips = run.statistics;
    const Distribution& interval = flips.interval_ms;
    table += number_row(
        "td", {pictured(run.bodies), std::to_string(flips.flips), std::to_string(flips.late),
               decimal(interval.median, 2), decimal(interval.p95, 2), decimal(interval.p99, 2),
               decimal(interval.largest, 2), decimal(interval.sd, 3), decimal(flips.spread_ms, 3),
               decimal(flips.drift_ppm, 1)});
  }
  return table + "</table>\n";
}

std::string plots(const TimingReport& report) {
  std::string html;
  for (const FlipSeries& run : report.runs) {
    html += "<p><small>" + pictured(run.bodies) + "</small><br>" +
            flip_plot(run, report.facts.nominal_hz) + "</p>\n";
  }
  return html;
}

std::string input_table(const std::vector<InputDelay>& inputs) {
  std::string table = "<table>\n" + number_row("th", {"Input", "sent", "lost", "median", "95th",
                                                      "longest", "within stated uncertainty"});
  for (const InputDelay& input : inputs) {
    const Distribution delay = input.delay_ms();
    const bool any = delay.count > 0;
    const auto ms = [any](double value) { return any ? decimal(value, 2) : std::string("–"); };
    table +=
        number_row("td", {described(input), std::to_string(input.sent), std::to_string(input.lost),
                          ms(delay.median), ms(delay.p95), ms(delay.largest),
                          any ? decimal(100.0 * input.within_uncertainty_share, 1) + " %" : "–"});
  }
  return table + "</table>\n";
}

std::string list_of(const std::vector<std::string>& sentences) {
  std::string list = "<ul>\n";
  for (const std::string& sentence : sentences) {
    list += "<li>" + html_text(sentence) + "</li>\n";
  }
  return list + "</ul>\n";
}

}  // namespace

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

std::string timing_page(const TimingReport& report) {
  const std::vector<TimingVerdict> verdicts = timing_verdicts(report);
  return std::string("<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'>") +
         "<title>Timing of this machine</title><style>" + kStyle + "</style></head><body>\n" +
         "<h1>Timing of this machine: " + grade_of(worst_of(verdicts)) + "</h1>\n" +
         facts_table(report.facts) + "<h2>Verdicts</h2>\n" + verdict_table(verdicts) +
         "<h2>For the methods section</h2>\n<blockquote>" + html_text(methods_paragraph(report)) +
         "</blockquote>\n" + "<h2>What nobody can know without a photodiode</h2>\n" +
         list_of(what_is_not_known(report)) + "<h2>Flips on an absolute grid</h2>\n<p>" +
         refresh_sentence(report) + "</p>\n<p>Intervals in milliseconds.</p>\n" +
         flip_table(report.runs) + plots(report) +
         "<p><small>One dot per interval; red: the frame was late; lines: one and two periods."
         "</small></p>\n<h2>Input sent to itself</h2>\n<p>From sending to the stamp that a session "
         "would keep, in milliseconds. This covers the path through the software alone.</p>\n" +
         input_table(report.inputs) + "</body></html>\n";
}

}  // namespace impetus::inline timing
