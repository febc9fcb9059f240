// `impetus film`: a recorded trial as a film of what was shown; or a scene, or all stimuli of a
// protocol, for who shows them by another program.
// SPDX-License-Identifier: MIT
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/shipped_file.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/films/film_making.hpp"
#include "experiments/commands/films/recorded_film.hpp"
#include "experiments/commands/films/simulated_film.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"
#endif

namespace impetus::inline commands {
namespace {

/// What `impetus film` was asked for.
struct FilmOptions {
  std::string source;
  std::optional<std::int64_t> trial;
  std::optional<std::int64_t> attempt;
  std::string scene;
  std::string out;
  std::string format;
  std::vector<std::string> overlays;
  std::string screen_file;
  std::optional<double> refresh_hz;
  bool allow_rounding{false};
  int width_px{0};
  int height_px{0};
};

#ifdef IMPETUS_WINDOW

constexpr double kUsualRefresh_hz = 60.0;

FilmOverlays overlays_of(const FilmOptions& options) {
  FilmOverlays overlays;
  for (const std::string& name : options.overlays) {
    (name == "gaze"       ? overlays.gaze
     : name == "contacts" ? overlays.contacts
                          : overlays.volumes) = true;
  }
  return overlays;
}

FilmLook look_of(const FilmOptions& options, const ScreenGeometry& screen) {
  return {picture_size(options.width_px, options.height_px, screen), overlays_of(options)};
}

/// A film, made from begin to end, and what is said of it.
int film_one(const Film& film, const FilmTarget& target, const FilmLook& look,
             nlohmann::ordered_json head) {
  const SteadyClock clock;
  FilmPainter painter(look.size, look.overlays, clock);
  if (film.patch) {
    painter.show_patch(*film.patch, film.stimuli.front().scene.viewer.screen);
  }
  auto line = std::make_unique<ProgressLine>("filming");
  const FilmSums sums = make_film(film, target, look, std::move(head), painter,
                                  [&](double share) { line->tell(share); });
  line.reset();
  const double hz = frame_rate(target, film.refresh_hz);
  std::printf("written to %s: %zu frames of %d x %d pixels, %g a second\n",
              target.path.string().c_str(), sums.frames, look.size.width_px, look.size.height_px,
              hz);
  if (hz != film.refresh_hz) {
    std::printf("a GIF counts in hundredths of a second: it takes %.3g times as long\n",
                film.refresh_hz / hz);
  }
  return kDone;
}

int film_trial(const FilmOptions& options) {
  // What was recorded has its own screen and rate, and is one film.
  require_not_given({{!options.screen_file.empty(), "--screen"},
                     {options.refresh_hz.has_value(), "--refresh"},
                     {options.allow_rounding, "--allow-rounding"},
                     {!options.format.empty(), "--format"}},
                    "expected a scene or a protocol beside it, got a study");
  require(options.trial.has_value(),
          "--trial: expected the number of a trial (the column `trial` of the views), which is "
          "missing");
  const FilmTarget target = film_target(options.out);
  StudyFile study = StudyFile::open_for_reading(options.source);
  return while_reading(study, [&] {
    const StoredAttempt attempt = filmed_attempt(study, *options.trial, options.attempt);
    const FilmLook look = look_of(options, attempt.screen);
    require_filmable(target, look.size);
    const RecordedFilm recorded = recorded_film(study, attempt);
    for (const auto& what : recorded.head["left_out"]) {
      std::printf("left out: %s, which went with it\n", what.get<std::string>().c_str());
    }
    return film_one(recorded.film, target, look, recorded.head);
  });
}

int film_scene(const FilmOptions& options) {
  require_not_given(
      {{!options.format.empty(), "--format"}, {options.allow_rounding, "--allow-rounding"}},
      "expected a protocol beside it, got a scene");
  const FilmTarget target = film_target(options.out);
  const JsonDocument scene = load_scene(shipped_file(options.scene));
  ScreenGeometry screen = chosen_screen(options.screen_file);
  const FilmLook look = look_of(options, screen);
  require_filmable(target, look.size);
  return staged_from(scene, [&] {
    ShapeLibrary shapes;
    const SteadyClock clock;
    const Film film = simulated_film(
        build_scene(scene.value, screen, kUnroundedHold, shapes, "main/1", kFilmSeed),
        options.refresh_hz.value_or(kUsualRefresh_hz), clock);
    nlohmann::ordered_json head{{"scene", scene.name}};
    tell_of_gaze(film, head);
    return film_one(film, target, look, std::move(head));
  });
}

// A whole protocol as films, for a lab that shows them by another program: one of each stimulus,
// and a table of what is in each.
//
//   folder/films.csv
//   folder/main-001-delay_ms-0-speed_deg_s-5.mp4, .json
//   folder/main-002-...

/// What a protocol's films are to be like.
struct ProtocolFilms {
  std::filesystem::path folder;
  const FilmFormat* format{nullptr};  ///< null: each is a folder of PNG files
  FilmLook look;
  ScreenGeometry screen;
  double refresh_hz{60.0};
  bool allow_rounding{false};
};

/// "main-012-delay_ms-100-speed_deg_s-5": no letter of it needs quotes anywhere.
std::string film_name(const PlannedFilm& planned) {
  constexpr std::size_t kLongest = 120;
  std::string name = printed("%s-%03zu", planned.part.c_str(), planned.film + 1);
  for (const FactorLevel& level : planned.trial.condition) {
    name += "-" + level.factor + "-" + to_text(level.value);
  }
  for (char& letter : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' ||
                       letter == '-' || letter == '_';
    letter = plain ? letter : '_';
  }
  return name.substr(0, kLongest);
}

template <typename T>
std::string cell(const std::optional<T>& value) {
  return value ? csv_number(static_cast<double>(*value)) : "";
}

/// A film that is written.
struct MadeFilm {
  std::string file;
  FilmSums sums;
};

/// The table of the films.
class FilmTable {
 public:
  explicit FilmTable(const Design& design) : design_(design) {
    const std::vector<std::string> planned{"file", "part", "condition", "repetition"};
    const std::vector<std::string> shown{"frames",     "seconds", "contact_frame", "contact_s",
                                         "collisions", "level",   "gap_arcmin"};
    const auto is_among = [](const std::vector<std::string>& names, const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<std::string> head = planned;
    for (const Factor& factor : design.factors) {
      const bool taken = is_among(planned, factor.name) || is_among(shown, factor.name);
      head.push_back((taken ? "factor_" : "") + factor.name);
    }
    head.insert(head.end(), shown.begin(), shown.end());
    text_ = csv_line(head);
  }

  void add(const MadeFilm& made, const PlannedFilm& planned) {
    const PlannedTrial& trial = planned.trial;
    const FilmSums& sums = made.sums;
    std::vector<std::string> cells{made.file, planned.part, to_json(trial.condition).dump(),
                                   std::to_string(trial.repetition)};
    for (const Factor& factor : design_.factors) {
      cells.push_back(level_of(trial.condition, factor.name));
    }
    cells.insert(cells.end(),
                 {std::to_string(sums.frames), csv_number(sums.seconds), cell(sums.contact_frame),
                  cell(sums.contact_s), std::to_string(sums.collisions), cell(sums.level),
                  cell(sums.gap_arcmin)});
    text_ += csv_line(cells);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string level_of(const Condition& condition, const std::string& factor) {
    const FactorLevel* level = find_level(condition, factor);
    return level == nullptr ? "" : to_text(level->value);
  }

  const Design& design_;
  std::string text_;
};

nlohmann::ordered_json planned_head(const Protocol& protocol, const PlannedFilm& planned) {
  return {{"protocol", protocol.document.name},
          {"part", planned.part},
          {"condition", to_json(planned.trial.condition)},
          {"repetition", planned.trial.repetition},
          {"seed", planned.trial.seed}};
}

/// Makes one after the other.
class FilmSeries {
 public:
  FilmSeries(const Protocol& protocol, const ProtocolFilms& asked, const ProtocolScenes& scenes,
             std::filesystem::path folder)
      : protocol_(protocol), asked_(asked), scenes_(scenes), folder_(std::move(folder)) {}

  /// The film, unless another condition that looks alike has it already; and its row of the table.
  void make(const PlannedFilm& planned, const std::function<void(double)>& tell) {
    if (planned.film == made_.size()) {
      const std::string file =
          film_name(planned) + (asked_.format == nullptr ? "" : asked_.format->ending);
      made_.push_back({file, film(planned, file, tell)});
    }
    table_.add(made_[planned.film], planned);
  }

  [[nodiscard]] std::size_t count() const { return made_.size(); }
  [[nodiscard]] const std::string& table() const { return table_.text(); }

 private:
  FilmSums film(const PlannedFilm& planned, const std::string& file,
                const std::function<void(double)>& tell) {
    const Film shown =
        simulated_film(scenes_.stage(planned.trial, asked_.screen), asked_.refresh_hz, clock_);
    nlohmann::ordered_json head = planned_head(protocol_, planned);
    tell_of_gaze(shown, head);
    return make_film(shown, {folder_ / file, asked_.format}, asked_.look, std::move(head), painter_,
                     tell);
  }

  const Protocol& protocol_;
  const ProtocolFilms& asked_;
  const ProtocolScenes& scenes_;
  std::filesystem::path folder_;
  const SteadyClock clock_{};
  FilmPainter painter_{asked_.look.size, asked_.look.overlays, clock_};
  FilmTable table_{protocol_.design};
  std::vector<MadeFilm> made_;
};

/// Makes them; returns how many. Throws InputError, or std::runtime_error when they cannot be
/// written, each in one sentence; then nothing is left of them.
std::size_t make_protocol_films(const Protocol& protocol, const ProtocolFilms& asked) {
  check_frames(protocol, asked.refresh_hz, asked.allow_rounding);
  const ProtocolScenes scenes(protocol, asked.allow_rounding ? asked.refresh_hz : kUnroundedHold);
  const std::vector<PlannedFilm> planned = planned_films(protocol, scenes, asked.screen);
  WholeFolder folder(asked.folder, FolderCheck(refuse_full_folder));
  FilmSeries series(protocol, asked, scenes, folder.path());
  ProgressLine line("filming");
  for (std::size_t i = 0; i < planned.size(); ++i) {
    series.make(planned[i], [&](double share) {
      line.tell((static_cast<double>(i) + share) / static_cast<double>(planned.size()));
    });
  }
  write_output_file(folder.path() / "films.csv", series.table());
  folder.put_in_place();
  return series.count();
}

int film_protocol(const FilmOptions& options, const std::string& file) {
  const Protocol protocol = load_protocol(file);
  ProtocolFilms asked;
  asked.folder = options.out;
  require(find_format(asked.folder.extension().string()) == nullptr,
          "--out: expected a folder for the films of a protocol, got " + options.out);
  asked.format =
      options.format == "png"
          ? nullptr
          : find_format("." + (options.format.empty() ? std::string("mp4") : options.format));
  require_free_folder(asked.folder, refuse_full_folder);
  asked.screen = chosen_screen(options.screen_file);
  asked.look = look_of(options, asked.screen);
  asked.refresh_hz = options.refresh_hz.value_or(kUsualRefresh_hz);
  asked.allow_rounding = options.allow_rounding;
  if (asked.format != nullptr) {
    require_encodable(*asked.format, asked.look.size);
  }
  const std::size_t count = make_protocol_films(protocol, asked);
  std::printf("written to %s: %zu films, told of in films.csv\n", options.out.c_str(), count);
  return kDone;
}

int film_document(const FilmOptions& options) {
  const std::string file = shipped_file(options.source);
  require(is_protocol(read_json(file)),
          file + ": expected a study or a protocol; a scene is filmed by --scene");
  return film_protocol(options, file);
}

int film(const FilmOptions& options) {
  const BuildingLine told;
  require(options.source.empty() != options.scene.empty(),
          "expected a study with --trial, a protocol, or a scene with --scene, got " +
              std::string(options.source.empty() ? "none of them" : "two of them"));
  const bool is_document = std::filesystem::path(options.source).extension() == ".json";
  if (options.scene.empty() && !is_document) {
    return film_trial(options);
  }
  require(!options.trial && !options.attempt, std::string(options.trial ? "--trial" : "--attempt") +
                                                  ": expected a study beside it, got " +
                                                  options.source + options.scene);
  return is_document ? film_document(options) : film_scene(options);
}

#else

int film(const FilmOptions& /*options*/) {
  throw InputError("this build has no window, which draws the pictures of films");
}

#endif

}  // namespace

void add_film(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<FilmOptions>(
      app, chosen, film, "film",
      "Make a film of a recorded trial, of a scene, or of each stimulus of a protocol");
  command->add_option("source", options->source,
                      "Study file with --trial; or protocol file, whose stimuli are filmed one by "
                      "one into the folder --out");
  command->add_option("--trial", options->trial,
                      "Of a study: this trial (the column `trial` of the views), every frame as "
                      "it was flipped; frames that stayed for lack of the next are held as long");
  command->add_option("--attempt", options->attempt,
                      "Of a trial that was shown more than once (default: the completed one)");
  command->add_option("--scene", options->scene, "Scene file, to be filmed without a study");
  command
      ->add_option("--out", options->out,
                   "File to write: .mkv (lossless), .mp4, .webm, .gif; or NAME/, a folder of PNG "
                   "files. What is in each frame is written beside it as JSON")
      ->required();
  command->add_option("--format", options->format, "Of a protocol's films (default: mp4)")
      ->check(CLI::IsMember({"mkv", "mp4", "webm", "gif", "png"}));
  command
      ->add_option("--show", options->overlays,
                   "Draw over it, with commas between: gaze, contacts, volumes; the latter two "
                   "for a quarter of a second after a contact")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"gaze", "contacts", "volumes"}));
  command->add_option("--width", options->width_px,
                      "Pixels across (default: the recorded screen's, or 1280)");
  command->add_option("--height", options->height_px,
                      "Pixels down (default: as the screen's sides have it)");
  command->add_option("--screen", options->screen_file,
                      "Of a scene or protocol: screen file (default: the user's own)");
  command
      ->add_option("--refresh", options->refresh_hz,
                   "Of a scene or protocol: frames per second (default: 60)")
      ->check(number_from(20.0, 1000.0));
  command->add_flag("--allow-rounding", options->allow_rounding,
                    "Of a protocol: round delays to whole frames, as `run` would with this option");
}

}  // namespace impetus::inline commands
