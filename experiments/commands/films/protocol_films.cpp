// SPDX-License-Identifier: MIT
#include "experiments/commands/films/protocol_films.hpp"

#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/progress_line.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

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
    std::vector<std::string> head{"file", "part", "condition", "repetition"};
    for (const Factor& factor : design.factors) {
      head.push_back(factor.name);
    }
    for (const char* name :
         {"frames", "seconds", "contact_frame", "contact_s", "collisions", "level", "gap_arcmin"}) {
      head.emplace_back(name);
    }
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
    for (const FactorLevel& level : condition) {
      if (level.factor == factor) {
        return to_text(level.value);
      }
    }
    return "";
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

}  // namespace

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

}  // namespace impetus::inline commands
