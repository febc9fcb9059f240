// What a film is written to, by the ending of its name, and beside it what is in it.
//
//   trial.mkv    every pixel as it was (FFV1, RGB)            trial.json
//   trial.mp4    for browsers and other programs (H.264, yuv420p)
//   trial.webm   the same (VP9, yuv420p)
//   trial.gif    256 colours a frame
//   trial/       a PNG file for each frame, frame-000000.png ...; trial/film.json
//
// Either appears whole or not at all.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/window/pixels.hpp"

namespace impetus::inline commands {

/// How ffmpeg makes films of one ending.
struct FilmFormat {
  std::string ending;   ///< ".mkv"
  std::string muxer;    ///< as ffmpeg calls it
  std::string encoder;  ///< the same
  std::vector<std::string> words;
  bool even_sides{false};  ///< its colours are halved across and down
};

/// Where a film goes.
struct FilmTarget {
  std::filesystem::path path;
  const FilmFormat* format{nullptr};  ///< null: a folder of PNG files

  /// What is in the film, as JSON.
  [[nodiscard]] std::filesystem::path record() const;
};

/// The format of the ending; null when there is none.
const FilmFormat* find_format(const std::string& ending);

/// The target of --out. Throws InputError for another ending.
FilmTarget film_target(const std::string& out);

/// Throws InputError, or std::runtime_error where nothing can be written, each in one sentence,
/// before anything is done: it is there already, its sides are odd, ffmpeg or the encoder is
/// missing.
void require_filmable(const FilmTarget& target, const PictureSize& size);

/// The same of the format and the size alone.
void require_encodable(const FilmFormat& format, const PictureSize& size);

/// Throws the sentence that says so of a folder that holds files.
[[noreturn]] void refuse_full_folder(const std::filesystem::path& folder);

/// How many frames of this target are shown in a second: a GIF counts in hundredths of a second for
/// each of them, two at least.
double frame_rate(const FilmTarget& target, double refresh_hz);

/// A film that is being written.
class FilmFile {
 public:
  virtual ~FilmFile() = default;

  /// The next frame. Throws std::runtime_error with one sentence, here and below, when it cannot be
  /// written; then nothing of the film is left.
  virtual void add(const Pixels& frame) = 0;

  /// Puts the film in its place, and beside it what is in it. Once, at the end.
  virtual void put_in_place(const std::string& record) = 0;
};

/// Begins a film that require_filmable() let pass.
std::unique_ptr<FilmFile> open_film(const FilmTarget& target, const PictureSize& size,
                                    double refresh_hz);

}  // namespace impetus::inline commands
