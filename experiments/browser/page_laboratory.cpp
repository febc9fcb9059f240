// SPDX-License-Identifier: MIT
#include "experiments/browser/page_laboratory.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "experiments/browser/the_page.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/settings/optional_json.hpp"

namespace impetus::inline browser {
namespace {

using nlohmann::json;

/// Rates that screens have.
constexpr double kUsualRates_hz[] = {50.0,  60.0,  72.0,  75.0,  85.0,  90.0, 100.0,
                                     120.0, 144.0, 165.0, 180.0, 200.0, 240.0};

std::int64_t ns_of(const json& ms) { return static_cast<std::int64_t>(ms.get<double>() * 1e6); }

std::vector<std::int64_t> frames(int count) {
  std::vector<std::int64_t> stamps;
  for (int frame = 0; frame < count; ++frame) {
    stamps.push_back(next_frame());
  }
  return stamps;
}

double median_interval_ns(const std::vector<std::int64_t>& stamps) {
  std::vector<std::int64_t> intervals;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    intervals.push_back(stamps[i] - stamps[i - 1]);
  }
  std::sort(intervals.begin(), intervals.end());
  return static_cast<double>(intervals[intervals.size() / 2]);
}

/// The usual rate that is nearest to what was measured, if within 4 %; else what was measured.
double likeliest_rate(double measured_hz) {
  const double nearest_hz =
      *std::min_element(std::begin(kUsualRates_hz), std::end(kUsualRates_hz),
                        [measured_hz](double one_hz, double other_hz) {
                          return std::abs(one_hz - measured_hz) < std::abs(other_hz - measured_hz);
                        });
  return std::abs(nearest_hz / measured_hz - 1.0) < 0.04 ? nearest_hz : measured_hz;
}

const char* name_of(Field::Kind kind) {
  switch (kind) {
    case Field::Kind::kNumber:
      return "number";
    case Field::Kind::kChoice:
      return "choice";
    case Field::Kind::kSlider:
      return "slider";
    default:
      return "text";
  }
}

/// Without a range, the numbers of one are null.
json field_json(const Field& field) {
  const bool ranged = field.has_range();
  return {{"id", field.id},
          {"label", field.label},
          {"kind", name_of(field.kind)},
          {"options", field.options},
          {"minimum", ranged ? json(field.minimum) : json()},
          {"maximum", ranged ? json(field.maximum) : json()},
          {"answer", field.answer}};
}

json progress_json(const SessionProgress& progress) {
  return {{"done", progress.done},
          {"total", progress.total},
          {"label", progress.label},
          {"light", progress.light_ground}};
}

const char* name_of(Page::Layout layout) {
  switch (layout) {
    case Page::Layout::kForm:
      return "form";
    case Page::Layout::kScale:
      return "scale";
    case Page::Layout::kChoices:
      return "choices";
    default:
      return "text";
  }
}

}  // namespace

json page_json(const Page& page) {
  const Language& language = page.progress.language;
  json fields = json::array();
  for (const Field& field : page.fields) {
    fields.push_back(field_json(field));
  }
  json choices = json::array();
  for (const Choice& choice : page.choices) {
    choices.push_back({{"label", choice.label}, {"key", choice.key}});
  }
  json points = json::array();
  for (const LookedAtPoint& point : page.point_map.points) {
    points.push_back({point.x, point.y, point.seen, point.gaze_x, point.gaze_y});
  }
  return {{"layout", name_of(page.layout)},
          {"title", page.title},
          {"paragraphs", page.paragraphs},
          {"statement", page.statement},
          {"fields", fields},
          {"choices", choices},
          {"low_anchor", page.low_anchor},
          {"high_anchor", page.high_anchor},
          {"timeout_ms", page.timeout_ms},
          {"can_pause", page.can_pause},
          {"choice_at_end", page.choice_at_end},
          {"read_to_end", language.text("read_to_end")},
          {"points", points},
          {"aspect", page.point_map.aspect},
          {"progress", progress_json(page.progress)}};
}

PageLaboratory::PageLaboratory(const ScreenGeometry& screen, const Clock& clock)
    : screen_(screen), clock_(clock) {}

SyncTest PageLaboratory::measure_refresh() {
  constexpr int kFrames = 60;
  refresh_hz_ = likeliest_rate(1e9 / median_interval_ns(frames(kFrames)));
  const SyncTest test = run_sync_test(frames, refresh_hz_);
  grid_ = FrameGrid(refresh_hz_);
  last_frame_ns_ = clock_.now_ns();
  restart_grid();
  return test;
}

// In step with the frames so far, however long ago the last was.
void PageLaboratory::restart_grid() {
  const double period_ns = grid_.period_ns();
  const double passed = static_cast<double>(clock_.now_ns() - last_frame_ns_) / period_ns;
  grid_.restart(last_frame_ns_ + static_cast<std::int64_t>(std::floor(passed) * period_ns));
}

Flip PageLaboratory::show(const Picture& picture) {
  show_picture(picture.pointer);
  painter_.paint(picture, {0, 0, screen_.width_px, screen_.height_px});
  const ScreenPoint at = picture.target.value_or(ScreenPoint{});
  show_target(picture.target.has_value(), (at.x_m / screen_.width_m + 0.5) * screen_.width_px,
              (0.5 - at.y_m / screen_.height_m) * screen_.height_px);
  const json progress = progress_json(picture.progress);
  if (const std::string words = progress.dump(); words != told_progress_) {
    told_progress_ = words;
    show_progress(progress);
  }
  const std::int64_t submitted_ns = clock_.now_ns();
  last_frame_ns_ = next_frame();
  take_what_happened();
  return grid_.flipped(submitted_ns, std::max(last_frame_ns_, submitted_ns));
}

Answer PageLaboratory::ask(const Page& page) {
  told_progress_.clear();
  const json said = ask_of_participant(page_json(page));
  Answer answer;
  answer.choice = said.at("choice").get<std::size_t>();
  answer.fields = said.at("fields").get<std::vector<std::string>>();
  answer.device = said.at("device").get<std::string>();
  answer.shown_ns = ns_of(said.at("shown_ms"));
  answer.arrived_ns = ns_of(said.at("arrived_ms"));
  answer.arrival_uncertainty_ns = ns_of(said.at("uncertainty_ms"));
  answer.timed_out = said.at("timed_out").get<bool>();
  answer.interruption =
      said.at("pause").get<bool>() ? Interruption::kPauseRequested : Interruption::kNone;
  take_what_happened();
  static_cast<void>(take_clicks());  // what was pressed on the page was for it alone
  samples_.clear();
  pause_requested_ = false;
  return answer;
}

Interruption PageLaboratory::interruption() {
  return std::exchange(pause_requested_, false) ? Interruption::kPauseRequested
                                                : Interruption::kNone;
}

std::vector<ClickRecord> PageLaboratory::take_clicks() { return std::exchange(clicks_, {}); }

// A mouse that rests sends nothing: every call adds one sample of where it is.
std::vector<GazeSample> PageLaboratory::take_samples() {
  samples_.push_back(
      {clock_.now_ns(), pointer_, pointer_ ? GazeLoss::kNone : GazeLoss::kOffScreen});
  return std::exchange(samples_, {});
}

void PageLaboratory::take_what_happened() {
  const json events = take_events();
  for (const json& click : events.at("clicks")) {
    clicks_.push_back({click[0].get<std::string>(), ns_of(click[1]), ns_of(click[2])});
  }
  for (const json& move : events.at("moves")) {
    pointer_ = on_glass(screen_, move[1].get<double>(), move[2].get<double>());
    samples_.push_back({ns_of(move[0]), pointer_, GazeLoss::kNone});
  }
  if (events.at("away").get<bool>()) {
    pointer_.reset();
  }
  for (const json& absence : events.at("absences")) {
    hand_over(line_of(NoteRecord{absence[0].get<std::string>(), absence[1].get<std::string>()}));
  }
  pause_requested_ = pause_requested_ || events.at("pause").get<bool>();
}

void PageRecorder::save(AttemptRecord attempt) { keep(std::move(attempt)); }
void PageRecorder::save(QuestionRecord answer) { keep(std::move(answer)); }
void PageRecorder::save(NoteRecord note) { keep(std::move(note)); }
void PageRecorder::save(ChosenLevel chosen) { keep(std::move(chosen)); }
void PageRecorder::save(CalibrationRecord calibration) { keep(std::move(calibration)); }
void PageRecorder::mark_finished() { keep(FinishedRecord{}); }
void PageRecorder::await_saved() { await_kept(to_json(standing_, design_)); }

void PageRecorder::keep(AnyRecord record) {
  hand_over(line_of(record));
  add(record, standing_);
}

}  // namespace impetus::inline browser
