// Paints the pictures of a film, out of sight: each by the very code that shows it in a session,
// and, where it is asked for, with what collision handling did drawn over it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "experiments/record/ports.hpp"
#include "experiments/viewing/replay_view.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline viewers {

/// What is drawn over the pictures; nothing: they are as they were shown.
struct FilmOverlays {
  bool gaze{false};
  bool contacts{false};
  bool volumes{false};

  [[nodiscard]] bool any() const { return gaze || contacts || volumes; }
};

/// One at a time.
class FilmPainter {
 public:
  /// `clock` must outlive it. Throws std::runtime_error with one sentence when no OpenGL 3.3 can be
  /// had.
  FilmPainter(const PictureSize& size, const FilmOverlays& overlays, const Clock& clock);
  ~FilmPainter();
  FilmPainter(const FilmPainter&) = delete;
  FilmPainter& operator=(const FilmPainter&) = delete;

  /// From now on a photodiode patch is part of all pictures of this screen.
  void show_patch(ScreenCorner corner, const ScreenGeometry& screen);

  /// The picture as it was shown.
  [[nodiscard]] Pixels paint(const Picture& picture);
  /// The same moment, of the replay at `time_s`, with the overlays.
  [[nodiscard]] Pixels paint_over(const Picture& picture, const ReplayView& replay, double time_s);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace impetus::inline viewers
