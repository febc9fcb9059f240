// Where buttons go that stand in rows, as many beside each other as a width holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

namespace impetus::inline window {

class ButtonRows {
 public:
  /// The first row begins at the cursor.
  ButtonRows(float width_px, float gap_px);

  /// Moves the cursor to where the next button goes, which is of this size.
  void place(ImVec2 size_px);

  /// Moves the cursor to the left edge below the last row.
  void end() const;

 private:
  ImVec2 origin_;
  float width_px_;
  float gap_px_;
  ImVec2 at_;
  float row_px_{0.0F};  ///< as high as the highest button of the row
};

}  // namespace impetus::inline window
