-- From schema 1 to 2: gaze, clicks, priority lists. Views are made anew afterwards.

ALTER TABLE attempt ADD COLUMN gaze_source TEXT;
ALTER TABLE attempt ADD COLUMN gaze_latency_p95_ms REAL;
ALTER TABLE attempt ADD COLUMN gaze_late INTEGER NOT NULL DEFAULT 0 CHECK (gaze_late IN (0, 1));
ALTER TABLE attempt ADD COLUMN region_covered_share REAL;

ALTER TABLE step ADD COLUMN fixation_x_m REAL;
ALTER TABLE step ADD COLUMN fixation_y_m REAL;
ALTER TABLE step ADD COLUMN fixation_taken_ns INTEGER;
ALTER TABLE step ADD COLUMN fixation_age_ns INTEGER;
ALTER TABLE step ADD COLUMN region_x_m REAL;
ALTER TABLE step ADD COLUMN region_y_m REAL;
ALTER TABLE step ADD COLUMN region_radius_deg REAL;
ALTER TABLE step ADD COLUMN shown_frame INTEGER;

ALTER TABLE collision ADD COLUMN list INTEGER NOT NULL DEFAULT 0;
ALTER TABLE collision ADD COLUMN time_s REAL;
ALTER TABLE collision ADD COLUMN gaze_eccentricity_deg REAL;
ALTER TABLE collision ADD COLUMN region_eccentricity_deg REAL;

CREATE TABLE gaze (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  sample INTEGER NOT NULL,
  taken_ns INTEGER NOT NULL,
  x_m REAL,
  y_m REAL,
  loss TEXT CHECK (loss IN ('blink', 'off screen', 'lost')),
  PRIMARY KEY (attempt_id, sample),
  CHECK ((x_m IS NULL) = (y_m IS NULL) AND (x_m IS NULL) = (loss IS NOT NULL))
) STRICT, WITHOUT ROWID;

CREATE TABLE click (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated')),
  arrived_ns INTEGER NOT NULL,
  arrival_uncertainty_ns INTEGER NOT NULL,
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;
