// SPDX-License-Identifier: MIT
#include "experiments/models/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace impetus::inline models {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, int error) {
  throw std::runtime_error(file.string() + ": cannot be written (" + std::strerror(error) + ")");
}

/// A temporary file beside `file`, removed again unless it was put in its place.
class Beside {
 public:
  explicit Beside(const std::filesystem::path& file)
      : file_(file), name_(file.string() + ".XXXXXX"), descriptor_(mkstemp(name_.data())) {
    require(descriptor_ >= 0);
  }
  ~Beside() {
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
    if (!done_) {
      unlink(name_.c_str());
    }
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void write_all(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) {
        continue;
      }
      require(written >= 0);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void put_in_place() {
    const mode_t mask = umask(0);
    umask(mask);
    require(fchmod(descriptor_, 0666 & ~mask) == 0);  // mkstemp's own is for the user alone
    require(fsync(descriptor_) == 0);
    const int closed = close(descriptor_);
    descriptor_ = -1;
    require(closed == 0);
    require(rename(name_.c_str(), file_.c_str()) == 0);
    done_ = true;
  }

 private:
  void require(bool fine) const {
    if (!fine) {
      refuse(file_, errno);
    }
  }

  std::filesystem::path file_;
  std::string name_;
  int descriptor_;
  bool done_{false};
};

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
  Beside beside(file);
  beside.write_all(bytes);
  beside.put_in_place();
}

void require_writable(const std::filesystem::path& file) {
  const Beside beside(file);
  if (std::filesystem::is_directory(file)) {
    refuse(file, EISDIR);
  }
}

}  // namespace impetus::inline models
