// SPDX-License-Identifier: MIT
#include "experiments/commands/films/film_file.hpp"

#include <sys/mman.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

#include "experiments/commands/new_file.hpp"
#include "experiments/commands/program_start.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecordName = "film.json";

// Colours of films are those of television (BT.709) and said to be, so that players do not guess.
const std::vector<std::string> kHalvedColours{
    "-vf",
    "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
    "-colorspace",
    "bt709",
    "-color_primaries",
    "bt709",
    "-color_trc",
    "bt709",
    "-color_range",
    "tv"};

std::vector<std::string> with_halved_colours(std::vector<std::string> words) {
  words.insert(words.end(), kHalvedColours.begin(), kHalvedColours.end());
  return words;
}

const std::array<FilmFormat, 4>& formats() {
  static const std::array<FilmFormat, 4> all{{
      {".mkv",
       "matroska",
       "ffv1",
       {"-level", "3", "-g", "1", "-slicecrc", "1", "-pix_fmt", "bgr0"}},
      {".mp4", "mp4", "libx264",
       with_halved_colours({"-preset", "medium", "-crf", "12", "-movflags", "+faststart"}), true},
      {".webm", "webm", "libvpx-vp9",
       with_halved_colours({"-crf", "16", "-b:v", "0", "-row-mt", "1", "-cpu-used", "4"}), true},
      // A palette for each frame: one for all would need all of them in memory.
      {".gif",
       "gif",
       "gif",
       {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1"}},
  }};
  return all;
}

/// A run of the ffmpeg of the user's path, which makes a film of raw pictures that it is handed one
/// by one.
///
///   pictures ─> socket ─> ffmpeg ─> file
///                           └─────> what it complains of, in memory: a full disk takes nothing of
///                           it
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

std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \r\n") + 1);
  return text.substr(text.find_last_of("\r\n") + 1);
}

/// "" of a program that ended as it should.
std::string end_words(int status) {
  if (WIFSIGNALED(status)) {
    return "ended by signal " + std::to_string(WTERMSIG(status));
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : "exit status " + std::to_string(code);
}

FfmpegProgram::FfmpegProgram(const std::vector<std::string>& words)
    : said_(memfd_create("ffmpeg", MFD_CLOEXEC)) {
  if (said_ < 0) {
    throw std::runtime_error("no file could be made for what ffmpeg says");
  }
  const std::array<int, 2> ends = socket_ends();
  input_ = ends[0];
  std::vector<std::string> all{"ffmpeg", "-hide_banner", "-loglevel", "error", "-xerror"};
  all.insert(all.end(), words.begin(), words.end());
  const auto started = start_program(
      std::move(all), {{ends[1], STDIN_FILENO}, {said_, STDOUT_FILENO}, {said_, STDERR_FILENO}});
  close(ends[1]);
  if (!started) {
    close_input();
    close(said_);
    throw InputError(
        "expected ffmpeg, got none on the path (apt-get install ffmpeg); a folder of PNG files "
        "needs none: --out NAME/");
  }
  process_ = *started;
}

FfmpegProgram::~FfmpegProgram() {
  close_input();
  if (process_ > 0) {
    kill(process_, SIGKILL);
    await_program(process_);
  }
  close(said_);
}

void FfmpegProgram::close_input() {
  if (input_ >= 0) {
    close(std::exchange(input_, -1));
  }
}

bool FfmpegProgram::take(std::span<const std::uint8_t> bytes) { return send_all(input_, bytes); }

std::string FfmpegProgram::await() {
  close_input();
  const std::string end = end_words(await_program(std::exchange(process_, 0)));
  // It complains of what keeps it from writing, and may still say with its status that all is well.
  const std::string complaint = last_line(said());
  return complaint.empty() ? end : complaint;
}

std::string FfmpegProgram::said() const {
  std::string text;
  std::array<char, 4096> part{};
  ssize_t count = 0;
  while ((count = pread(said_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

/// Throws InputError, in one sentence, when there is no ffmpeg or this one lacks the encoder.
void require_encoder(const std::string& encoder) {
  FfmpegProgram program({"-encoders"});
  static_cast<void>(program.await());
  if (program.said().find(" " + encoder + " ") == std::string::npos) {
    throw InputError("expected an ffmpeg with the encoder " + encoder +
                     ", got one without it; another ending of --out needs another encoder");
  }
}

std::vector<std::string> ffmpeg_words(const FilmTarget& target, const PictureSize& size,
                                      double refresh_hz, const fs::path& file) {
  const FilmFormat& format = *target.format;
  std::vector<std::string> words{
      "-f",
      "rawvideo",
      "-pixel_format",
      "rgb24",
      "-video_size",
      std::to_string(size.width_px) + "x" + std::to_string(size.height_px),
      "-framerate",
      csv_number(frame_rate(target, refresh_hz)),
      "-i",
      "-",
      "-c:v",
      format.encoder};
  words.insert(words.end(), format.words.begin(), format.words.end());
  words.insert(words.end(), {"-f", format.muxer, "-y", "file:" + file.string()});
  return words;
}

/// A film that ffmpeg makes.
class EncodedFilm final : public FilmFile {
 public:
  EncodedFilm(const FilmTarget& target, const PictureSize& size, double refresh_hz)
      : name_(target.path.filename().string()),
        film_(target.path),
        record_(target.record()),
        ffmpeg_(ffmpeg_words(target, size, refresh_hz, film_.path())) {}

  void add(const Pixels& frame) override {
    if (!ffmpeg_.take(frame.rgb)) {
      refuse(ffmpeg_.await());
    }
  }

  void put_in_place(const std::string& record) override {
    const std::string complaint = ffmpeg_.await();
    if (!complaint.empty()) {
      refuse(complaint);
    }
    write_output_file(record_.path(), record);
    record_.put_in_place();
    film_.put_in_place();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::runtime_error(name_ + ": cannot be written, ffmpeg ended before it was whole (" +
                             (why.empty() ? "without a word" : why) + ")");
  }

  std::string name_;
  WholeFile film_;
  WholeFile record_;
  FfmpegProgram ffmpeg_;
};

/// A folder of PNG files.
class PictureFolder final : public FilmFile {
 public:
  explicit PictureFolder(const fs::path& target)
      : folder_(target, FolderCheck(refuse_full_folder)) {}

  void add(const Pixels& frame) override {
    const std::string name = printed("frame-%06d.png", count_++);
    write_png(frame, folder_.path() / name);
  }

  void put_in_place(const std::string& record) override {
    write_output_file(folder_.path() / kRecordName, record);
    folder_.put_in_place();
  }

 private:
  WholeFolder folder_;
  int count_{0};
};

}  // namespace

std::filesystem::path FilmTarget::record() const {
  return format == nullptr ? path / kRecordName : fs::path(path).replace_extension(".json");
}

const FilmFormat* find_format(const std::string& ending) {
  const auto found =
      std::find_if(formats().begin(), formats().end(),
                   [&](const FilmFormat& format) { return format.ending == ending; });
  return found == formats().end() ? nullptr : &*found;
}

FilmTarget film_target(const std::string& out) {
  const fs::path path(out);
  const std::string ending = path.extension().string();
  if (!path.has_filename() || ending.empty() || fs::is_directory(path)) {
    return {path.has_filename() ? path : path.parent_path(), nullptr};
  }
  const FilmFormat* format = find_format(ending);
  if (format == nullptr) {
    throw InputError("--out " + out + ": expected a name that ends in one of " +
                     listed(formats(), &FilmFormat::ending) +
                     ", or in / for a folder of PNG files, got " + ending);
  }
  return {path, format};
}

void refuse_full_folder(const std::filesystem::path& folder) {
  throw InputError(folder.string() + ": holds files already and is not overwritten");
}

void require_filmable(const FilmTarget& target, const PictureSize& size) {
  if (target.format == nullptr) {
    require_free_folder(target.path, refuse_full_folder);
    return;
  }
  require_new_file(target.path);
  require_new_file(target.record());
  require_encodable(*target.format, size);
}

void require_encodable(const FilmFormat& format, const PictureSize& size) {
  if (format.even_sides && (size.width_px % 2 != 0 || size.height_px % 2 != 0)) {
    throw InputError("expected even sides, which " + format.ending + " needs, got " +
                     std::to_string(size.width_px) + " x " + std::to_string(size.height_px) +
                     " pixels; --width and --height change them, and .mkv takes any");
  }
  require_encoder(format.encoder);
}

double frame_rate(const FilmTarget& target, double refresh_hz) {
  if (target.format == nullptr || target.format->muxer != "gif") {
    return refresh_hz;
  }
  return 100.0 / std::max(2.0, std::round(100.0 / refresh_hz));
}

std::unique_ptr<FilmFile> open_film(const FilmTarget& target, const PictureSize& size,
                                    double refresh_hz) {
  if (target.format == nullptr) {
    return std::make_unique<PictureFolder>(target.path);
  }
  return std::make_unique<EncodedFilm>(target, size, refresh_hz);
}

}  // namespace impetus::inline commands
