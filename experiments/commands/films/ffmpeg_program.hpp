// The ffmpeg of the user's path, which makes a film of raw pictures that it is handed one by one.
//
//   pictures ─> socket ─> ffmpeg ─> file
//                           └─────> what it complains of, in memory: a full disk takes nothing of
//                           it
//
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace impetus::inline commands {

/// A run of ffmpeg.
class FfmpegProgram {
 public:
  /// Starts it with these words after its name. Throws InputError when there is none.
  explicit FfmpegProgram(const std::vector<std::string>& words);
  ~FfmpegProgram();  ///< ends it where it was not awaited
  FfmpegProgram(const FfmpegProgram&) = delete;
  FfmpegProgram& operator=(const FfmpegProgram&) = delete;

  /// Hands over bytes; false when it ended and takes no more.
  [[nodiscard]] bool take(std::span<const std::uint8_t> bytes);

  /// Tells it that this was all, and waits until it ends. "": it did all it should; otherwise the
  /// last line it said, or what ended it.
  [[nodiscard]] std::string await();

  /// All that it said.
  [[nodiscard]] std::string said() const;

 private:
  void close_input();

  int input_{-1};
  int said_{-1};
  pid_t process_{0};  ///< 0: it was awaited
};

/// Throws InputError, in one sentence, when there is no ffmpeg or this one lacks the encoder.
void require_encoder(const std::string& encoder);

}  // namespace impetus::inline commands
