// Where markers go: a serial port, or a socket of another program.
//
//   serial:///dev/ttyUSB0?baud=115200    each marker is one byte, its code
//   tcp://eeg-room:5005                  each is a line: "30 contact"
//   lsl://impetus                        a stream of that name and of type Markers, of such texts,
//                                        stamped by the flip itself
//
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "experiments/record/markers.hpp"

namespace impetus::inline markers {

/// A line to another recorder. Used by one thread.
class MarkerLine {
 public:
  virtual ~MarkerLine() = default;

  /// Hands the marker of an event at `event_ns` to the system; whether it took it, in at most a
  /// tenth of a second. Once it did not, the line is tried anew from time to time.
  virtual bool write(MarkedEvent event, std::int64_t code, std::int64_t event_ns) = 0;
};

/// The line at an address as above, open. Throws InputError in one sentence: an address that is
/// none, a port or a host that does not open.
std::unique_ptr<MarkerLine> open_marker_line(const std::string& address);

}  // namespace impetus::inline markers
