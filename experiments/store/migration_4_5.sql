-- From schema 4 to 5: how a session resumed and what was set aside for it; when a trial was saved by
-- the wall clock; the source of gaze and the photodiode patch of a session; what a study was merged
-- from. A CHECK changes only with its table, so attempt is copied. Views are made anew afterwards.

CREATE TABLE merged_file (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  hash TEXT NOT NULL UNIQUE,
  created_utc TEXT NOT NULL,
  build TEXT NOT NULL,
  merged_utc TEXT NOT NULL
) STRICT;

ALTER TABLE study ADD COLUMN anonymised_by TEXT;

ALTER TABLE participant ADD COLUMN merged_file_id INTEGER REFERENCES merged_file (id);

ALTER TABLE session ADD COLUMN resumed_at TEXT CHECK (resumed_at IN ('trial', 'block'));
ALTER TABLE session ADD COLUMN resumed_after_s REAL;
ALTER TABLE session ADD COLUMN first_slot INTEGER;
ALTER TABLE session ADD COLUMN gaze_source TEXT;
ALTER TABLE session ADD COLUMN photodiode_patch TEXT;

CREATE TABLE attempt_5 (
  id INTEGER PRIMARY KEY,
  trial_id INTEGER NOT NULL REFERENCES trial (id),
  session_id INTEGER NOT NULL REFERENCES session (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  outcome TEXT NOT NULL CHECK (outcome IN ('completed', 'interrupted', 'set aside')),
  onset_ns INTEGER NOT NULL,
  intended_hold_ms REAL NOT NULL,
  realised_hold_ms REAL NOT NULL,
  timed_frames INTEGER NOT NULL,
  late_timed_frames INTEGER NOT NULL,
  late_untimed_frames INTEGER NOT NULL,
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1)),
  gaze_source TEXT,
  gaze_latency_p95_ms REAL,
  gaze_late INTEGER NOT NULL DEFAULT 0 CHECK (gaze_late IN (0, 1)),
  region_covered_share REAL,
  interrupted_by TEXT,
  gaze_lost_share REAL,
  imposed_gaze_latency_ms REAL,
  saved_utc TEXT,
  set_aside_in INTEGER REFERENCES session (id),
  UNIQUE (trial_id, number),
  CHECK ((outcome = 'set aside') = (set_aside_in IS NOT NULL))
) STRICT;

INSERT INTO attempt_5 (
  id, trial_id, session_id, number, outcome, onset_ns, intended_hold_ms, realised_hold_ms,
  timed_frames, late_timed_frames, late_untimed_frames, sync_overridden, gaze_source,
  gaze_latency_p95_ms, gaze_late, region_covered_share, interrupted_by, gaze_lost_share,
  imposed_gaze_latency_ms)
SELECT
  id, trial_id, session_id, number, outcome, onset_ns, intended_hold_ms, realised_hold_ms,
  timed_frames, late_timed_frames, late_untimed_frames, sync_overridden, gaze_source,
  gaze_latency_p95_ms, gaze_late, region_covered_share, interrupted_by, gaze_lost_share,
  imposed_gaze_latency_ms
FROM attempt;

DROP TABLE attempt;
ALTER TABLE attempt_5 RENAME TO attempt;
CREATE UNIQUE INDEX one_completed_attempt ON attempt (trial_id) WHERE outcome = 'completed';

ALTER TABLE frame ADD COLUMN patch INTEGER;
