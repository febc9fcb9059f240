// R scripts, run by the Rscript of the user's path.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace impetus::inline commands {

inline constexpr int kNoRscript = 127;

/// Runs a script and its arguments, `words`, and waits for its end; what it says goes to stderr.
/// Its exit status; kNoRscript when there is no Rscript; −1 when a signal ended it.
int run_r_script(const std::vector<std::string>& words);

/// The same for what cannot be done without R: throws InputError when there is no Rscript.
int run_needed_r_script(const std::vector<std::string>& words);

/// A script that asks while it runs, in lines; what it complains of goes to stderr.
class AskingRScript {
 public:
  /// Throws InputError when there is no Rscript.
  explicit AskingRScript(const std::vector<std::string>& words);
  /// Ends it, if it has not ended.
  ~AskingRScript();
  AskingRScript(const AskingRScript&) = delete;
  AskingRScript& operator=(const AskingRScript&) = delete;

  /// What it says next, without the end of the line; none: it says no more.
  std::optional<std::string> hear();
  /// False: it no longer listens.
  bool tell(const std::string& line);
  /// Its exit status, when it has ended.
  int await();

 private:
  int socket_{-1};
  pid_t process_{0};
  std::string heard_;  ///< what is not yet told of it
};

}  // namespace impetus::inline commands
