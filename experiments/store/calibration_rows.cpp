// SPDX-License-Identifier: MIT
#include "experiments/store/calibration_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include "experiments/store/optional_values.hpp"

namespace impetus::inline store {
namespace {

const char* name_of(CalibrationKind kind) {
  return kind == CalibrationKind::kCalibration  ? "calibration"
         : kind == CalibrationKind::kValidation ? "validation"
                                                : "drift check";
}

void bind_correction(SQLite::Statement& insert, int first, const GazeCorrection& correction) {
  for (const double value : {correction.x0_m, correction.xx, correction.xy, correction.y0_m,
                             correction.yx, correction.yy}) {
    insert.bind(first++, value);
  }
}

std::int64_t insert_run(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record) {
  SQLite::Statement insert(
      database,
      "INSERT INTO calibration (session_id, kind, number, before_slot, gaze_source, accuracy_deg, "
      "worst_accuracy_deg, precision_rms_deg, precision_sd_deg, lost_share, sampling_hz, "
      "accuracy_limit_deg, passed, began_ns, correction_x0_m, correction_xx, correction_xy, "
      "correction_y0_m, correction_yx, correction_yy) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, session_id);
  insert.bind(2, name_of(record.kind));
  insert.bind(3, record.number);
  insert.bind(4, record.before_slot);
  insert.bind(5, record.gaze_source);
  bind_or_null(insert, 6, record.accuracy_deg);
  bind_or_null(insert, 7, record.worst_accuracy_deg);
  bind_or_null(insert, 8, record.precision_rms_deg);
  bind_or_null(insert, 9, record.precision_sd_deg);
  insert.bind(10, record.lost_share);
  bind_or_null(insert, 11, record.sampling_hz);
  insert.bind(12, record.accuracy_limit_deg);
  insert.bind(13, record.passed ? 1 : 0);
  insert.bind(14, record.began_ns);
  if (record.correction) {
    bind_correction(insert, 15, *record.correction);
  }
  insert.exec();
  return database.getLastInsertRowid();
}

void bind_point(SQLite::Statement& insert, const CalibrationPointRecord& point) {
  insert.bind(3, point.shown.x_m);
  insert.bind(4, point.shown.y_m);
  if (point.gaze) {
    insert.bind(5, point.gaze->x_m);
    insert.bind(6, point.gaze->y_m);
  }
  bind_or_null(insert, 7, point.accuracy_deg);
  bind_or_null(insert, 8, point.precision_rms_deg);
  bind_or_null(insert, 9, point.precision_sd_deg);
  insert.bind(10, point.samples);
  insert.bind(11, point.lost);
}

}  // namespace

void insert_calibration(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record) {
  const std::int64_t id = insert_run(database, session_id, record);
  SQLite::Statement insert(
      database,
      "INSERT INTO calibration_point (calibration_id, point, x_m, y_m, gaze_x_m, gaze_y_m, "
      "accuracy_deg, precision_rms_deg, precision_sd_deg, samples, lost) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const CalibrationPointRecord& point : record.points) {
    insert.bind(1, id);
    insert.bind(2, ++number);
    bind_point(insert, point);
    insert.exec();
    insert.reset();
    insert.clearBindings();
  }
}

}  // namespace impetus::inline store
