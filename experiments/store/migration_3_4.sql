-- From schema 3 to 4: blocks, catch trials and adaptive tracks of a plan; values solved for it;
-- trials that are yoked; two-interval trials; responses other than ratings; calibrations of the
-- gaze; what a collision looked like when it began. A key changes only with its table, so step is
-- copied. Views are made anew afterwards.

ALTER TABLE session ADD COLUMN series TEXT;
ALTER TABLE session ADD COLUMN series_place INTEGER CHECK (series_place >= 1);

ALTER TABLE trial ADD COLUMN block INTEGER NOT NULL DEFAULT 1 CHECK (block >= 1);
ALTER TABLE trial ADD COLUMN catch INTEGER NOT NULL DEFAULT 0 CHECK (catch IN (0, 1));
ALTER TABLE trial ADD COLUMN track INTEGER;
ALTER TABLE trial ADD COLUMN adaptive_state TEXT CHECK (adaptive_state IS NULL OR json_valid(adaptive_state));
ALTER TABLE trial ADD COLUMN solved TEXT CHECK (solved IS NULL OR json_valid(solved));
ALTER TABLE trial ADD COLUMN yoked_trial_id INTEGER REFERENCES trial (id);

ALTER TABLE attempt ADD COLUMN interrupted_by TEXT;
ALTER TABLE attempt ADD COLUMN gaze_lost_share REAL;
ALTER TABLE attempt ADD COLUMN imposed_gaze_latency_ms REAL;

CREATE TABLE step_4 (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
  step INTEGER NOT NULL CHECK (step >= 0),
  work_granted INTEGER NOT NULL,
  work_spent INTEGER NOT NULL,
  degradations INTEGER NOT NULL,
  hash INTEGER NOT NULL,
  digests BLOB NOT NULL,
  fixation_x_m REAL,
  fixation_y_m REAL,
  fixation_taken_ns INTEGER,
  fixation_age_ns INTEGER,
  region_x_m REAL,
  region_y_m REAL,
  region_radius_deg REAL,
  shown_frame INTEGER,
  pops INTEGER NOT NULL DEFAULT 0,
  largest_pop_deg REAL,
  stopped_short INTEGER NOT NULL DEFAULT 0,
  PRIMARY KEY (attempt_id, interval, step)
) STRICT, WITHOUT ROWID;

INSERT INTO step_4 (
  attempt_id, step, work_granted, work_spent, degradations, hash, digests, fixation_x_m,
  fixation_y_m, fixation_taken_ns, fixation_age_ns, region_x_m, region_y_m, region_radius_deg,
  shown_frame, pops, largest_pop_deg, stopped_short)
SELECT
  attempt_id, step, work_granted, work_spent, degradations, hash, digests, fixation_x_m,
  fixation_y_m, fixation_taken_ns, fixation_age_ns, region_x_m, region_y_m, region_radius_deg,
  shown_frame, pops, largest_pop_deg, stopped_short
FROM step;

DROP TABLE step;
ALTER TABLE step_4 RENAME TO step;

ALTER TABLE collision ADD COLUMN interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2));
ALTER TABLE frame ADD COLUMN interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2));
ALTER TABLE gaze ADD COLUMN interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2));
ALTER TABLE click ADD COLUMN interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2));
ALTER TABLE collision ADD COLUMN distance_m REAL;
ALTER TABLE collision ADD COLUMN speed_deg_s REAL;
ALTER TABLE collision ADD COLUMN collision_speed_deg_s REAL;
ALTER TABLE collision ADD COLUMN priority REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_a_x_rad_s REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_a_y_rad_s REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_a_z_rad_s REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_b_x_rad_s REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_b_y_rad_s REAL;
ALTER TABLE collision ADD COLUMN imposed_spin_b_z_rad_s REAL;

CREATE TABLE response (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  kind TEXT NOT NULL,
  question TEXT NOT NULL,
  answer TEXT,
  positive INTEGER CHECK (positive IN (0, 1)),
  correct INTEGER CHECK (correct IN (0, 1)),
  detail TEXT NOT NULL CHECK (json_valid(detail)),
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated', 'none')),
  question_shown_ns INTEGER NOT NULL,
  arrived_ns INTEGER NOT NULL,
  arrival_uncertainty_ns INTEGER NOT NULL,
  timed_out INTEGER NOT NULL DEFAULT 0 CHECK (timed_out IN (0, 1)),
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE calibration (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  kind TEXT NOT NULL CHECK (kind IN ('calibration', 'validation', 'drift check')),
  number INTEGER NOT NULL CHECK (number >= 1),
  before_slot INTEGER NOT NULL,
  gaze_source TEXT NOT NULL,
  accuracy_deg REAL,
  worst_accuracy_deg REAL,
  precision_rms_deg REAL,
  precision_sd_deg REAL,
  lost_share REAL NOT NULL,
  sampling_hz REAL,
  accuracy_limit_deg REAL NOT NULL,
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
  began_ns INTEGER NOT NULL,
  correction_x0_m REAL, correction_xx REAL, correction_xy REAL,
  correction_y0_m REAL, correction_yx REAL, correction_yy REAL
) STRICT;

CREATE TABLE calibration_point (
  calibration_id INTEGER NOT NULL REFERENCES calibration (id),
  point INTEGER NOT NULL CHECK (point >= 1),
  x_m REAL NOT NULL, y_m REAL NOT NULL,
  gaze_x_m REAL, gaze_y_m REAL,
  accuracy_deg REAL, precision_rms_deg REAL, precision_sd_deg REAL,
  samples INTEGER NOT NULL,
  lost INTEGER NOT NULL,
  PRIMARY KEY (calibration_id, point)
) STRICT, WITHOUT ROWID;

CREATE TABLE exclusion (
  id INTEGER PRIMARY KEY,
  participant_id INTEGER NOT NULL REFERENCES participant (id),
  trial_id INTEGER REFERENCES trial (id),
  excluded INTEGER NOT NULL CHECK (excluded IN (0, 1)),
  reason TEXT NOT NULL CHECK (length(reason) > 0),
  decided_utc TEXT NOT NULL
) STRICT;
