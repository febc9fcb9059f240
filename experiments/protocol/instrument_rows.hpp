// Rows of a protocol on a lab's other instruments: what follows the gaze, and what is told by
// markers.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/questions/script.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

Row<Script> gaze_row();
Row<Script> markers_row();

}  // namespace impetus::inline protocol
