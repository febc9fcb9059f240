// SPDX-License-Identifier: MIT
#include "experiments/commands/films/film_making.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/exports/gzip.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewing/film_run.hpp"
#include "experiments/viewing/replay_simulation.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::ordered_json;

/// A frame of the film, painted.
struct PaintedFrame {
  FilmFrame::Kind kind{FilmFrame::Kind::kShown};
  const FrameRecord* recorded{nullptr};
  const FilmRun* run{nullptr};  ///< come to this frame; null where no scene is seen
  std::uint32_t crc32{0};
};

std::string hex(std::uint32_t value) { return printed("%08x", value); }

ordered_json to_list(const Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

const char* showing(const PaintedFrame& frame) {
  return frame.kind == FilmFrame::Kind::kBetween          ? "blank"
         : frame.recorded->phase == FramePhase::kFixation ? "fixation"
                                                          : "stimulus";
}

std::string body_name(const StagedScene& scene, std::int32_t body) {
  return is_wall(body) ? wall_name(body, wall_naming(scene.world.settings().enclosure))
                       : scene.world.models()[static_cast<std::size_t>(body)].name;
}

ordered_json contact_row(const StagedScene& scene, const FilmedContact& contact) {
  const CollisionReport& report = contact.report;
  ordered_json row{
      {"bodies", {body_name(scene, report.bodies.a), body_name(scene, report.bodies.b)}},
      {"step", contact.step},
      {"begins", report.began},
      {"level", report.level},
      {"finest", report.stop == StopReason::kFinest},
      {"impulse_Ns", report.impulse_Ns},
      {"points_m", ordered_json::array()}};
  for (const TouchPoint& touch : contact.touches) {
    row["points_m"].push_back(to_list(touch.point));
  }
  if (contact.truth) {
    row["gap_m"] = contact.truth->gap_m;
    row["gap_arcmin"] = contact.truth->gap_arcmin;
    row["gap_hidden_share"] = contact.truth->hidden_share;
  }
  return row;
}

/// Gathers what is in a film, frame by frame, for the JSON file beside it.
///
///   {"film": "trial.mkv", ...what it is of...,
///    "frames": [
///      {"frame": 0, "film_s": 0, "showing": "fixation", ...},     a line for each frame
///      ... ]}
class FilmRecord {
 public:
  /// `head` is what the film is of. Frames that were not flipped, but simulated, have no times of
  /// flips.
  FilmRecord(ordered_json head, const PictureSize& size, double frames_per_second,
             bool was_flipped);

  void add(const PaintedFrame& frame);

  [[nodiscard]] const FilmSums& sums() const { return sums_; }
  [[nodiscard]] std::string text() const;

 private:
  void add_bodies(const PaintedFrame& frame, ordered_json& row) const;
  void add_contacts(const PaintedFrame& frame, ordered_json& row);
  void count(const FilmedContact& contact);

  ordered_json head_;
  PictureSize size_;
  double frames_per_second_;
  bool was_flipped_;
  std::string rows_;
  FilmSums sums_;
};

FilmRecord::FilmRecord(ordered_json head, const PictureSize& size, double frames_per_second,
                       bool was_flipped)
    : head_(std::move(head)),
      size_(size),
      frames_per_second_(frames_per_second),
      was_flipped_(was_flipped) {
  head_["width_px"] = size.width_px;
  head_["height_px"] = size.height_px;
  head_["frames_per_second"] = frames_per_second;
}

void FilmRecord::add(const PaintedFrame& frame) {
  const FrameRecord& recorded = *frame.recorded;
  const double film_s = static_cast<double>(sums_.frames) / frames_per_second_;
  ordered_json row{{"frame", sums_.frames}, {"film_s", film_s}, {"showing", showing(frame)}};
  if (was_flipped_) {
    const bool is_new = frame.kind == FilmFrame::Kind::kShown;
    row["interval"] = recorded.interval;
    row["recorded_frame"] = is_new ? ordered_json(recorded.frame) : ordered_json();
    row["flipped_ns"] = is_new ? ordered_json(recorded.flip.flipped_ns) : ordered_json();
    row["held"] = frame.kind == FilmFrame::Kind::kHeld;
  }
  row["crc32"] = hex(frame.crc32);
  if (frame.run != nullptr) {
    row["stimulus_s"] = recorded.shown_time_s;
    row["step"] = frame.run->step();
    add_bodies(frame, row);
    add_contacts(frame, row);
  }
  rows_ += (rows_.empty() ? "" : ",\n") + row.dump();
  ++sums_.frames;
  sums_.seconds = static_cast<double>(sums_.frames) / frames_per_second_;
}

void FilmRecord::add_bodies(const PaintedFrame& frame, ordered_json& row) const {
  const Picture picture = frame.run->picture(frame.recorded->shown_time_s);
  const PictureMap map(picture.viewer, {0, 0, size_.width_px, size_.height_px}, size_.height_px);
  row["bodies"] = ordered_json::array();
  for (const PosedBody& body : picture.bodies) {
    const Quaternion& turn = body.pose.orientation;
    const auto seen = map.seen(body.pose.position);
    row["bodies"].push_back(
        {{"name", body.look.name},
         {"position_m", to_list(body.pose.position)},
         {"orientation_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
         {"centre_px", seen ? ordered_json{seen->x, seen->y} : ordered_json()}});
  }
}

/// What the frame's own steps brought: a frame that is held brings nothing.
void FilmRecord::add_contacts(const PaintedFrame& frame, ordered_json& row) {
  row["contacts"] = ordered_json::array();
  if (frame.kind != FilmFrame::Kind::kShown) {
    return;
  }
  for (const FilmedContact& contact : frame.run->contacts()) {
    row["contacts"].push_back(contact_row(frame.run->scene(), contact));
    count(contact);
  }
}

void FilmRecord::count(const FilmedContact& contact) {
  if (!sums_.contact_frame) {
    sums_.contact_frame = sums_.frames;
    sums_.contact_s = static_cast<double>(sums_.frames) / frames_per_second_;
    sums_.level = contact.report.level;
    sums_.gap_arcmin = contact.truth ? std::optional(contact.truth->gap_arcmin) : std::nullopt;
  }
  sums_.collisions += contact.report.began ? 1 : 0;
}

std::string FilmRecord::text() const {
  std::string text = "{\n";
  for (const auto& [key, value] : head_.items()) {
    text += ordered_json(key).dump() + ": " + value.dump() + ",\n";
  }
  const ordered_json first =
      sums_.contact_frame ? ordered_json(*sums_.contact_frame) : ordered_json();
  return text + "\"contact_frame\": " + first.dump() + ",\n\"frames\": [\n" + rows_ + "\n]\n}\n";
}

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
    crc32_ = crc32_of(pixels_.rgb);
  }

  const Film& film_;
  FilmPainter& painter_;
  std::vector<std::unique_ptr<FilmRun>> runs_;
  std::vector<ReplayView> replays_;  ///< of the overlays; none: nothing is drawn over
  Pixels pixels_;
  std::uint32_t crc32_{0};
};

}  // namespace

ordered_json overlay_names(const FilmOverlays& overlays) {
  ordered_json names = ordered_json::array();
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
                   ordered_json head, FilmPainter& painter,
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
