// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/exports/codebook.hpp"
#include "experiments/exports/export_table.hpp"
#include "experiments/exports/row_query.hpp"
#include "experiments/python/module.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/replay_library.hpp"
#include "experiments/study/what_if_sums.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

py::object value_of(const RowQuery& query, int column, bool bits) {
  switch (query.type(column)) {
    case SQLITE_INTEGER:
      return bits ? py::object(py::str(bits_text(query.integer(column))))
                  : py::object(py::int_(query.integer(column)));
    case SQLITE_FLOAT:
      return py::float_(query.number(column));
    case SQLITE_TEXT:
      return py::str(as_utf8(query.bytes(column)));
    case SQLITE_BLOB:
      return py::str(bytes_text(query.bytes(column)));
    default:
      return py::none();
  }
}

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const ExportTable& table : export_tables()) {
    names.push_back(table.file);
  }
  return names;
}

/// One table of the study: what it has a row of, and its columns with all that is known of them.
py::dict table_of(StudyFile& study, const std::string& name) {
  const std::vector<ExportTable>& tables = export_tables();
  const auto table = std::find_if(tables.begin(), tables.end(),
                                  [&](const ExportTable& each) { return each.file == name; });
  if (table == tables.end()) {
    throw InputError(study.name() + ": expected one of its tables (" + listed(table_names()) +
                     "), got " + name);
  }
  OpenTable open = open_table(study.database(), *table, factor_labels(study.database()));
  const std::vector<CodebookColumn>& columns = open.columns;
  std::vector<py::list> values(columns.size());
  while (open.rows.step()) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      values[i].append(value_of(open.rows, static_cast<int>(i), columns[i].type == "bits"));
    }
  }
  py::dict all;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    py::dict column;
    column["type"] = columns[i].type;
    column["unit"] = columns[i].unit;
    column["meaning"] = columns[i].meaning;
    column["values"] = std::move(values[i]);
    all[py::str(columns[i].name)] = std::move(column);
  }
  py::dict told;
  told["rows"] = table->rows;
  told["columns"] = std::move(all);
  return told;
}

/// A recorded stimulus simulated again, step by step, in Python's hands.
class ReplayOfPython {
 public:
  ReplayOfPython(StagedScene scene, std::vector<StepRecord> steps, std::string why)
      : steps_(std::move(steps)), replay_(std::move(scene), steps_), why_(std::move(why)) {}
  ReplayOfPython(const ReplayOfPython&) = delete;
  ReplayOfPython& operator=(const ReplayOfPython&) = delete;

  /// The states after the next step: a row for each body.
  py::dict next() {
    if (replay_.done()) {
      throw py::stop_iteration();
    }
    const std::int64_t number = replay_.next_step();
    const StepRecord& recorded = steps_[done_++];
    replay_.next();
    const World& world = replay_.scene_run().world();
    py::list positions;
    py::list orientations;
    for (const BodyState& state : world.states()) {
      const Vector3& p = state.pose.position;
      const Quaternion& q = state.pose.orientation;
      positions.append(py::make_tuple(p.x(), p.y(), p.z()));
      orientations.append(py::make_tuple(q.x(), q.y(), q.z(), q.w()));
    }
    py::dict step;
    step["step"] = number;
    step["time_s"] = static_cast<double>(number) / replay_.scene().step_hz;
    step["positions_m"] = std::move(positions);
    step["orientations"] = std::move(orientations);
    step["hash"] = bits_of(hash_state(world.states()).hash);
    step["recorded_hash"] = bits_of(recorded.state.hash);
    return step;
  }

  /// In words, where it first left the recording; "": nowhere by now.
  [[nodiscard]] std::string divergence() const {
    const std::optional<Divergence>& found = replay_.result().divergence;
    return !found
               ? ""
               : "diverges at step " + std::to_string(found->step) +
                     (found->body.empty() ? "" : ", " + found->field + " of " + found->body) + why_;
  }
  [[nodiscard]] std::vector<std::string> bodies() const {
    return body_names(replay_.scene().world);
  }
  [[nodiscard]] std::size_t steps() const { return steps_.size(); }

 private:
  std::vector<StepRecord> steps_;
  RunningReplay replay_;
  std::size_t done_{0};
  std::string why_;
};

/// A study, open for reading.
class StudyOfPython {
 public:
  explicit StudyOfPython(const std::string& path)
      : study_(StudyFile::open_for_reading(path)),
        attempts_(load_attempts(study_)),
        library_(study_) {}
  StudyOfPython(const StudyOfPython&) = delete;
  StudyOfPython& operator=(const StudyOfPython&) = delete;

  [[nodiscard]] std::string name() const { return study_.name(); }
  py::dict table(const std::string& name) { return table_of(study_, name); }

  std::unique_ptr<ReplayOfPython> replay(std::int64_t trial, std::optional<std::int64_t> attempt,
                                         std::int64_t interval) {
    const StoredAttempt& stored = attempt_of(trial, attempt, interval, library_);
    return std::make_unique<ReplayOfPython>(
        library_.stage(stored, interval), library_.steps(stored, interval), why_divergent(stored));
  }

  py::object what_if(std::int64_t trial, const std::vector<std::string>& with,
                     std::optional<std::int64_t> attempt, std::int64_t interval) {
    std::vector<SettingChange> changes;
    for (const std::string& given : with) {
      changes.push_back(setting_change(given));
    }
    ReplayLibrary library(study_, std::move(changes));
    const StoredAttempt& stored = attempt_of(trial, attempt, interval, library);
    const ComparedStimulus both = compared(library, stored, interval);
    if (const std::optional<Divergence>& divergence = both.outcome.divergence) {
      throw InputError(study_.name() + ": expected a trial that replays as it was recorded, but " +
                       std::to_string(trial) + " diverges at step " +
                       std::to_string(divergence->step) + why_divergent(stored));
    }
    return as_python(json_of(both));
  }

 private:
  /// The attempt of this number, or the trial's last that was completed, else its last.
  const StoredAttempt& attempt_of(std::int64_t trial, std::optional<std::int64_t> number,
                                  std::int64_t interval, ReplayLibrary& library) {
    const StoredAttempt* found = nullptr;
    for (const StoredAttempt& each : attempts_) {
      const bool is_it = each.trial_id == trial && (!number || each.number == *number);
      if (is_it && (found == nullptr || each.completed || !found->completed)) {
        found = &each;
      }
    }
    if (found == nullptr) {
      throw InputError(study_.name() + ": expected a trial that was shown, got " +
                       std::to_string(trial) +
                       (number ? ", attempt " + std::to_string(*number) : ""));
    }
    if (const std::int64_t most = library.intervals(*found); interval < 1 || interval > most) {
      throw InputError(study_.name() + ": trial " + std::to_string(trial) +
                       ": expected an interval from 1 to " + std::to_string(most) + ", got " +
                       std::to_string(interval));
    }
    return *found;
  }

  StudyFile study_;
  std::vector<StoredAttempt> attempts_;
  ReplayLibrary library_;  ///< as it was recorded: protocols are read and bodies built once
};

}  // namespace

void add_studies(py::module_& module) {
  module.def("table_names", &table_names,
             "The tables of every study, as `impetus export` has them.");
  py::class_<ReplayOfPython>(module, "Replay",
                             "A recorded stimulus simulated again: an iterator over its steps.")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &ReplayOfPython::next)
      .def("__len__", &ReplayOfPython::steps)
      .def_property_readonly("bodies", &ReplayOfPython::bodies, "Names, in the order of all rows.")
      .def_property_readonly("divergence", &ReplayOfPython::divergence,
                             "Where it first left the recording, in words; \"\": nowhere by now.");
  py::class_<StudyOfPython>(module, "StudyFile")
      .def(py::init<const std::string&>())
      .def_property_readonly("name", &StudyOfPython::name)
      .def("table", &StudyOfPython::table)
      .def("replay", &StudyOfPython::replay, py::arg("trial"), py::arg("attempt"),
           py::arg("interval"))
      .def("what_if", &StudyOfPython::what_if, py::arg("trial"), py::arg("given"),
           py::arg("attempt"), py::arg("interval"));
}

}  // namespace impetus::inline python
