// A page as a laboratory: display, input, gaze and recorder of a session, as the window is of one
// in the lab.
//
//   show(picture)   paint with WebGL 2 ─> wait for the next frame ─> Flip
//   ask(page)       HTML, which screen readers read and keyboards operate ─> Answer
//   save(record)    a line of JSON, handed over
//
// A browser says when a frame begins, never when its light leaves the screen: that is one to three
// refreshes later. What is drawn between two frames' beginnings is stamped with the second, so that
// stamps lie in step with the refresh and early by an unknown part of that delay.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/drawing/scene_painter.hpp"
#include "experiments/lines/record_lines.hpp"
#include "experiments/lines/standing.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline browser {

/// The screen of a page, what is answered there, and the mouse as gaze.
class PageLaboratory final : public Display, public Input, public Gaze {
 public:
  /// `clock` must outlive this. Needs a current WebGL 2 context of the screen's pixels.
  PageLaboratory(const ScreenGeometry& screen, const Clock& clock);

  /// Waits for some frames and takes the usual rate that is nearest to theirs; then tests whether
  /// frames follow it.
  SyncTest measure_refresh();

  [[nodiscard]] double refresh_hz() const override { return refresh_hz_; }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return screen_; }
  void restart_grid() override;
  Flip show(const Picture& picture) override;

  Answer ask(const Page& page) override;
  Interruption interruption() override;
  std::vector<ClickRecord> take_clicks() override;

  [[nodiscard]] std::string source() const override { return "mouse"; }
  [[nodiscard]] bool is_pointer() const override { return true; }
  std::vector<GazeSample> take_samples() override;

 private:
  void take_what_happened();

  ScreenGeometry screen_;
  const Clock& clock_;
  double refresh_hz_{60.0};
  FrameGrid grid_{60.0};
  std::int64_t last_frame_ns_{0};
  ScenePainter painter_;
  std::string told_progress_;
  std::vector<ClickRecord> clicks_;
  std::vector<GazeSample> samples_;
  Fixation pointer_;
  bool pause_requested_{false};
};

/// Hands over all that a session records, and with it where its participant stands.
class PageRecorder final : public Recorder {
 public:
  /// `design` must outlive this. `standing`: when the session begins.
  PageRecorder(Standing standing, const Design& design)
      : standing_(std::move(standing)), design_(design) {}

  void save(AttemptRecord attempt) override;
  void save(QuestionRecord answer) override;
  void save(NoteRecord note) override;
  void save(ChosenLevel chosen) override;
  void save(CalibrationRecord calibration) override;
  void mark_finished() override;
  void await_saved() override;

 private:
  void keep(AnyRecord record);

  Standing standing_;
  const Design& design_;
};

/// A page as session_page.js shows it.
nlohmann::json page_json(const Page& page);

}  // namespace impetus::inline browser
