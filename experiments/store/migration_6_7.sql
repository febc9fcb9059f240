-- From schema 6 to 7: a session may end as declined. A CHECK changes only with its table, so session
-- is copied; what refused sessions of before say stays. Views are made anew afterwards.

CREATE TABLE session_7 (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  started_utc TEXT NOT NULL,
  ended_utc TEXT,
  ending TEXT CHECK (ending IN ('finished', 'quit', 'declined', 'display closed', 'failed')),
  recording_format INTEGER NOT NULL,
  build TEXT NOT NULL,
  machine TEXT NOT NULL,
  display TEXT NOT NULL,
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  observer TEXT,
  screen_width_m REAL NOT NULL CHECK (screen_width_m > 0),
  screen_height_m REAL NOT NULL CHECK (screen_height_m > 0),
  screen_width_px INTEGER NOT NULL CHECK (screen_width_px > 0),
  screen_height_px INTEGER NOT NULL CHECK (screen_height_px > 0),
  viewing_distance_m REAL NOT NULL CHECK (viewing_distance_m > 0),
  screen_measured INTEGER NOT NULL CHECK (screen_measured IN (0, 1)),
  refresh_hz REAL NOT NULL CHECK (refresh_hz > 0),
  rounding_allowed INTEGER NOT NULL CHECK (rounding_allowed IN (0, 1)),
  sync_tries INTEGER NOT NULL,
  sync_valid_flips INTEGER NOT NULL,
  sync_mean_interval_ns REAL,
  sync_sd_interval_ns REAL,
  sync_passed INTEGER NOT NULL CHECK (sync_passed IN (0, 1)),
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1)),
  series TEXT,
  series_place INTEGER CHECK (series_place >= 1),
  resumed_at TEXT CHECK (resumed_at IN ('trial', 'block')),
  resumed_after_s REAL,
  first_slot INTEGER,
  gaze_source TEXT,
  photodiode_patch TEXT
) STRICT;

INSERT INTO session_7 (
  id, enrolment_id, started_utc, ended_utc, ending, recording_format, build, machine, display,
  simulated, observer, screen_width_m, screen_height_m, screen_width_px, screen_height_px,
  viewing_distance_m, screen_measured, refresh_hz, rounding_allowed, sync_tries, sync_valid_flips,
  sync_mean_interval_ns, sync_sd_interval_ns, sync_passed, sync_overridden, series, series_place,
  resumed_at, resumed_after_s, first_slot, gaze_source, photodiode_patch)
SELECT
  id, enrolment_id, started_utc, ended_utc, ending, recording_format, build, machine, display,
  simulated, observer, screen_width_m, screen_height_m, screen_width_px, screen_height_px,
  viewing_distance_m, screen_measured, refresh_hz, rounding_allowed, sync_tries, sync_valid_flips,
  sync_mean_interval_ns, sync_sd_interval_ns, sync_passed, sync_overridden, series, series_place,
  resumed_at, resumed_after_s, first_slot, gaze_source, photodiode_patch
FROM session;

DROP TABLE session;
ALTER TABLE session_7 RENAME TO session;
