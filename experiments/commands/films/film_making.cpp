// SPDX-License-Identifier: MIT
#include "experiments/commands/films/film_making.hpp"

#include <memory>
#include <utility>
#include <vector>

#include "experiments/viewing/replay_simulation.hpp"

namespace impetus::inline commands {
namespace {

/// Paints what each refresh had on it.
class FilmPictures {
 public:
  FilmPictures(const Film& film, const FilmOverlays& overlays, FilmPainter& painter)
      : film_(film), painter_(painter) {
    for (const FilmedStimulus& stimulus : film.stimuli) {
      runs_.push_back(std::make_unique<FilmRun>(stimulus));
      if (overlays.any()) {
        replays_.push_back(view_of(stimulus.scene, stimulus.steps));
        replays_.back().samples = stimulus.samples;
      }
    }
  }

  PaintedFrame paint(const FilmFrame& frame) {
    const FrameRecord& recorded = film_.frames[frame.recorded];
    const bool blank = frame.kind == FilmFrame::Kind::kBetween;
    const bool seen = !blank && recorded.phase == FramePhase::kStimulus;
    const auto interval = static_cast<std::size_t>(recorded.interval - 1);
    if (frame.kind == FilmFrame::Kind::kShown && seen) {
      runs_[interval]->advance(recorded.shown_time_s);
      paint_stimulus(recorded, interval);
    } else if (frame.kind != FilmFrame::Kind::kHeld) {
      paint_ground(recorded, blank ? 0 : interval, blank);
    }
    return {frame.kind, &recorded, seen ? runs_[interval].get() : nullptr, crc32_};
  }

  [[nodiscard]] const Pixels& pixels() const { return pixels_; }

 private:
  void paint_stimulus(const FrameRecord& recorded, std::size_t interval) {
    Picture picture = runs_[interval]->picture(recorded.shown_time_s);
    picture.patch_code = recorded.patch.value_or(kDarkPatch);
    keep(replays_.empty()
             ? painter_.paint(picture)
             : painter_.paint_over(picture, replays_[interval], recorded.shown_time_s));
  }

  void paint_ground(const FrameRecord& recorded, std::size_t interval, bool blank) {
    Picture picture = picture_of(film_.stimuli[interval].scene, {}, 0.0, {});
    picture.fixation_cross = !blank;
    picture.patch_code = blank ? kDarkPatch : recorded.patch.value_or(kDarkPatch);
    keep(painter_.paint(picture));
  }

  void keep(Pixels pixels) {
    pixels_ = std::move(pixels);
    crc32_ = crc32_of(pixels_);
  }

  const Film& film_;
  FilmPainter& painter_;
  std::vector<std::unique_ptr<FilmRun>> runs_;
  std::vector<ReplayView> replays_;  ///< of the overlays; none: nothing is drawn over
  Pixels pixels_;
  std::uint32_t crc32_{0};
};

}  // namespace

nlohmann::ordered_json overlay_names(const FilmOverlays& overlays) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const auto& [shown, name] :
       {std::pair{overlays.gaze, "gaze"}, std::pair{overlays.contacts, "contacts"},
        std::pair{overlays.volumes, "volumes"}}) {
    if (shown) {
      names.push_back(name);
    }
  }
  return names;
}

FilmSums make_film(const Film& film, const FilmTarget& target, const FilmLook& look,
                   nlohmann::ordered_json head, FilmPainter& painter,
                   const std::function<void(double)>& tell) {
  head["film"] = target.path.filename().string();
  head["overlays"] = overlay_names(look.overlays);
  FilmRecord record(std::move(head), look.size, frame_rate(target, film.refresh_hz),
                    film.was_flipped);
  FilmPictures pictures(film, look.overlays, painter);
  const std::unique_ptr<FilmFile> file = open_film(target, look.size, film.refresh_hz);
  const std::vector<FilmFrame> frames = film_frames(film);
  for (const FilmFrame& frame : frames) {
    tell(static_cast<double>(record.sums().frames) / static_cast<double>(frames.size()));
    record.add(pictures.paint(frame));
    file->add(pictures.pixels());
  }
  file->put_in_place(record.text());
  return record.sums();
}

}  // namespace impetus::inline commands
