-- From schema 2 to 3: collisions that were capped, how many contacts they had, pops and stops of a
-- step. A constraint changes only with its table, so collision is copied; nothing may refer to it
-- meanwhile (foreign keys are off). Views are made anew afterwards.

ALTER TABLE step ADD COLUMN pops INTEGER NOT NULL DEFAULT 0;
ALTER TABLE step ADD COLUMN largest_pop_deg REAL;
ALTER TABLE step ADD COLUMN stopped_short INTEGER NOT NULL DEFAULT 0;

CREATE TABLE collision_3 (
  id INTEGER PRIMARY KEY,
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  step INTEGER NOT NULL,
  body_a TEXT NOT NULL,
  body_b TEXT NOT NULL,
  level INTEGER NOT NULL,
  stopped TEXT NOT NULL CHECK (stopped IN ('finest', 'budget', 'greatest level', 'capped')),
  point_x_m REAL NOT NULL, point_y_m REAL NOT NULL, point_z_m REAL NOT NULL,
  normal_x REAL NOT NULL, normal_y REAL NOT NULL, normal_z REAL NOT NULL,
  depth_m REAL NOT NULL,
  approach_m_s REAL NOT NULL,
  impulse_Ns REAL NOT NULL,
  imposed_hold_ms REAL NOT NULL,
  imposed_no_spin INTEGER NOT NULL CHECK (imposed_no_spin IN (0, 1)),
  eccentricity_deg REAL NOT NULL,
  first_frame INTEGER,
  list INTEGER NOT NULL DEFAULT 0,
  time_s REAL,
  gaze_eccentricity_deg REAL,
  region_eccentricity_deg REAL,
  contacts INTEGER NOT NULL DEFAULT 1 CHECK (contacts >= 1)
) STRICT;

INSERT INTO collision_3 (
  id, attempt_id, step, body_a, body_b, level, stopped, point_x_m, point_y_m, point_z_m,
  normal_x, normal_y, normal_z, depth_m, approach_m_s, impulse_Ns, imposed_hold_ms,
  imposed_no_spin, eccentricity_deg, first_frame, list, time_s, gaze_eccentricity_deg,
  region_eccentricity_deg)
SELECT
  id, attempt_id, step, body_a, body_b, level, stopped, point_x_m, point_y_m, point_z_m,
  normal_x, normal_y, normal_z, depth_m, approach_m_s, impulse_Ns, imposed_hold_ms,
  imposed_no_spin, eccentricity_deg, first_frame, list, time_s, gaze_eccentricity_deg,
  region_eccentricity_deg
FROM collision;

DROP TABLE collision;
ALTER TABLE collision_3 RENAME TO collision;
CREATE INDEX collision_attempt ON collision (attempt_id);

-- The first files of schema 1 have none.
CREATE TABLE IF NOT EXISTS collision_truth (
  collision_id INTEGER PRIMARY KEY REFERENCES collision (id),
  gap_m REAL NOT NULL CHECK (gap_m >= 0),
  gap_px REAL NOT NULL,
  gap_arcmin REAL NOT NULL,
  hidden_share REAL NOT NULL CHECK (hidden_share BETWEEN 0 AND 1)
) STRICT;
