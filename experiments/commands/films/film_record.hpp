// What is in a film, frame by frame, as the JSON file beside it.
//
//   {"film": "trial.mkv", ...what it is of...,
//    "frames": [
//      {"frame": 0, "film_s": 0, "showing": "fixation", ...},     a line for each frame of the film
//      ... ]}
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/viewing/film_run.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline commands {

/// Of the picture's bytes, red, green and blue of each pixel, row by row from the top: as
/// `ffmpeg -pix_fmt rgb24 -f framehash -hash crc32` has it.
std::uint32_t crc32_of(const Pixels& picture);

/// What somebody who has many films wants to know of each.
struct FilmSums {
  std::size_t frames{0};
  double seconds{0.0};
  std::optional<std::size_t> contact_frame{};  ///< the first that shows bodies touch
  std::optional<double> contact_s{};           ///< of the film
  std::size_t collisions{0};                   ///< contacts that begin
  std::optional<int> level{};                  ///< of the first
  std::optional<double> gap_arcmin{};          ///< the same
};

/// A frame of the film, painted.
struct PaintedFrame {
  FilmFrame::Kind kind{FilmFrame::Kind::kShown};
  const FrameRecord* recorded{nullptr};
  const FilmRun* run{nullptr};  ///< come to this frame; null where no scene is seen
  std::uint32_t crc32{0};
};

/// Gathers the frames.
class FilmRecord {
 public:
  /// `head` is what the film is of. Frames that were not flipped, but simulated, have no times of
  /// flips.
  FilmRecord(nlohmann::ordered_json head, const PictureSize& size, double frames_per_second,
             bool was_flipped);

  void add(const PaintedFrame& frame);

  [[nodiscard]] const FilmSums& sums() const { return sums_; }
  [[nodiscard]] std::string text() const;

 private:
  void add_bodies(const PaintedFrame& frame, nlohmann::ordered_json& row) const;
  void add_contacts(const PaintedFrame& frame, nlohmann::ordered_json& row);
  void count(const FilmedContact& contact);

  nlohmann::ordered_json head_;
  PictureSize size_;
  double frames_per_second_;
  bool was_flipped_;
  std::string rows_;
  FilmSums sums_;
};

}  // namespace impetus::inline commands
