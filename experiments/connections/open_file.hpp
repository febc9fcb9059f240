// A file descriptor that closes itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

namespace impetus::inline connections {

/// A file descriptor that closes itself.
class OpenFile {
 public:
  explicit OpenFile(int file = -1) : file_(file) {}
  ~OpenFile() { close(); }
  OpenFile(OpenFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    close();
    file_ = std::exchange(other.file_, -1);
    return *this;
  }

  [[nodiscard]] int get() const { return file_; }
  [[nodiscard]] bool is_open() const { return file_ >= 0; }
  void close();

 private:
  int file_;
};

}  // namespace impetus::inline connections
