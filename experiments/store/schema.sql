-- A study: one SQLite file. Written by `impetus run`; read by anybody.
--
--   participant --< enrolment >-- protocol        who does which protocol, with which seed
--                      |
--                      +--< trial                  the plan: stored before the first is shown
--                      |      +--< attempt --< step, collision, frame, gaze, click, rating
--                      +--< session                one sitting; a resumed enrolment has several
--                             +--< answer, note
--
-- Analysts: read the views in views.sql; tables may change with the schema version, views keep
-- their columns. Times are nanoseconds of a monotonic clock unless the name says otherwise.

CREATE TABLE study (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  created_utc TEXT NOT NULL,
  build TEXT NOT NULL
) STRICT;

CREATE TABLE protocol (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  hash TEXT NOT NULL UNIQUE,          -- of protocol_json and scene_json
  protocol_json TEXT NOT NULL,
  scene_json TEXT NOT NULL
) STRICT;

CREATE TABLE participant (
  id INTEGER PRIMARY KEY,
  pseudonym TEXT NOT NULL UNIQUE CHECK (length(pseudonym) > 0),
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1))
) STRICT;

CREATE TABLE enrolment (
  id INTEGER PRIMARY KEY,
  participant_id INTEGER NOT NULL REFERENCES participant (id),
  protocol_id INTEGER NOT NULL REFERENCES protocol (id),
  seed INTEGER NOT NULL,
  planned_utc TEXT NOT NULL,
  finished_utc TEXT,                  -- NULL until the last page was answered
  UNIQUE (participant_id, protocol_id)
) STRICT;

CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  started_utc TEXT NOT NULL,
  ended_utc TEXT,                     -- NULL when the process was killed
  ending TEXT CHECK (ending IN ('finished', 'quit', 'display closed', 'failed')),
  recording_format INTEGER NOT NULL,
  build TEXT NOT NULL,                -- version, commit, compiler, flags
  machine TEXT NOT NULL,
  display TEXT NOT NULL,              -- driver, renderer, what a flip's stamp is anchored to
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  observer TEXT,                      -- JSON parameters of the simulated participant
  screen_width_m REAL NOT NULL CHECK (screen_width_m > 0),
  screen_height_m REAL NOT NULL CHECK (screen_height_m > 0),
  screen_width_px INTEGER NOT NULL CHECK (screen_width_px > 0),
  screen_height_px INTEGER NOT NULL CHECK (screen_height_px > 0),
  viewing_distance_m REAL NOT NULL CHECK (viewing_distance_m > 0),
  screen_measured INTEGER NOT NULL CHECK (screen_measured IN (0, 1)),  -- 0: assumed, not entered
  refresh_hz REAL NOT NULL CHECK (refresh_hz > 0),                     -- nominal: the frame grid
  rounding_allowed INTEGER NOT NULL CHECK (rounding_allowed IN (0, 1)),
  sync_tries INTEGER NOT NULL,
  sync_valid_flips INTEGER NOT NULL,
  sync_mean_interval_ns REAL,
  sync_sd_interval_ns REAL,
  sync_passed INTEGER NOT NULL CHECK (sync_passed IN (0, 1)),
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1))
) STRICT;

CREATE TABLE trial (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  slot INTEGER NOT NULL CHECK (slot >= 1),
  phase TEXT NOT NULL CHECK (phase IN ('practice', 'main')),
  repetition INTEGER NOT NULL CHECK (repetition >= 1),
  condition TEXT NOT NULL CHECK (json_valid(condition)),  -- {"factor": level, ...}
  seed INTEGER NOT NULL,
  UNIQUE (enrolment_id, slot)
) STRICT;

CREATE TABLE attempt (
  id INTEGER PRIMARY KEY,
  trial_id INTEGER NOT NULL REFERENCES trial (id),
  session_id INTEGER NOT NULL REFERENCES session (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  outcome TEXT NOT NULL CHECK (outcome IN ('completed', 'interrupted')),
  onset_ns INTEGER NOT NULL,          -- flip of the first frame of the stimulus; 0: never shown
  intended_hold_ms REAL NOT NULL,
  realised_hold_ms REAL NOT NULL,     -- differs only when rounding was allowed
  timed_frames INTEGER NOT NULL,
  late_timed_frames INTEGER NOT NULL,
  late_untimed_frames INTEGER NOT NULL,
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1)),
  gaze_source TEXT,                   -- 'mouse', 'simulated eye', ...; NULL: gaze not followed
  gaze_latency_p95_ms REAL,           -- sample to flip, 95th percentile over the steps
  gaze_late INTEGER NOT NULL DEFAULT 0 CHECK (gaze_late IN (0, 1)),  -- that exceeded 80 ms
  region_covered_share REAL,          -- of the enclosure's image, inside the region, mean
  UNIQUE (trial_id, number)
) STRICT;
CREATE UNIQUE INDEX one_completed_attempt ON attempt (trial_id) WHERE outcome = 'completed';

CREATE TABLE step (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  step INTEGER NOT NULL CHECK (step >= 0),  -- 0: the state at the start
  work_granted INTEGER NOT NULL,            -- units of work; a test of a pair of nodes is one
  work_spent INTEGER NOT NULL,
  degradations INTEGER NOT NULL,            -- bits, see engine/world.hpp
  hash INTEGER NOT NULL,                    -- of the bodies' state, 64 bits
  digests BLOB NOT NULL,                    -- 16 bits per body and field, little endian
  fixation_x_m REAL,                        -- right of the screen's centre; NULL: not known
  fixation_y_m REAL,                        -- above it
  fixation_taken_ns INTEGER,                -- when the sample behind it was taken
  fixation_age_ns INTEGER,                  -- of that sample when the step was computed
  region_x_m REAL,                          -- centre of the region of high priority; NULL: none
  region_y_m REAL,
  region_radius_deg REAL,
  shown_frame INTEGER,                      -- of this attempt, the first to show it; NULL: none
  pops INTEGER NOT NULL DEFAULT 0,          -- pairs that touch at a coarser level than before
  largest_pop_deg REAL,                     -- visual angle that bounds grew by; NULL: no pop
  stopped_short INTEGER NOT NULL DEFAULT 0, -- pairs stopped at entry, or they had passed through
  PRIMARY KEY (attempt_id, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE collision (
  id INTEGER PRIMARY KEY,
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  step INTEGER NOT NULL,
  body_a TEXT NOT NULL,
  body_b TEXT NOT NULL,
  level INTEGER NOT NULL,
  stopped TEXT NOT NULL CHECK (stopped IN ('finest', 'budget', 'greatest level', 'capped')),
  point_x_m REAL NOT NULL, point_y_m REAL NOT NULL, point_z_m REAL NOT NULL,
  normal_x REAL NOT NULL, normal_y REAL NOT NULL, normal_z REAL NOT NULL,  -- from b to a
  depth_m REAL NOT NULL,
  approach_m_s REAL NOT NULL,
  impulse_Ns REAL NOT NULL,
  imposed_hold_ms REAL NOT NULL,      -- imposed manipulation: the freeze this contact started
  imposed_no_spin INTEGER NOT NULL CHECK (imposed_no_spin IN (0, 1)),  -- imposed: no rotation
  eccentricity_deg REAL NOT NULL,     -- of the contact from the screen's centre
  first_frame INTEGER,                -- of the stimulus; NULL: no frame showed it
  list INTEGER NOT NULL DEFAULT 0,    -- priority list it was refined in, from 0
  time_s REAL,                        -- of the stimulus; NULL: recorded before schema 2
  gaze_eccentricity_deg REAL,         -- of the contact from the fixation; NULL: not known
  region_eccentricity_deg REAL,       -- from the centre of the region; NULL: none
  contacts INTEGER NOT NULL DEFAULT 1 CHECK (contacts >= 1)  -- point and normal are the deepest's
) STRICT;
CREATE INDEX collision_attempt ON collision (attempt_id);

-- What was wrong with a collision and how visible that was; filled by `impetus replay --truth`.
CREATE TABLE collision_truth (
  collision_id INTEGER PRIMARY KEY REFERENCES collision (id),
  gap_m REAL NOT NULL CHECK (gap_m >= 0),           -- closest distance of the drawn meshes
  gap_px REAL NOT NULL,               -- between the two closest points as projected
  gap_arcmin REAL NOT NULL,           -- the same as a visual angle: foreshortening counted
  hidden_share REAL NOT NULL CHECK (hidden_share BETWEEN 0 AND 1)  -- of the gap, by sample rays
) STRICT;

CREATE TABLE frame (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  frame INTEGER NOT NULL,
  phase TEXT NOT NULL CHECK (phase IN ('fixation', 'stimulus')),
  shown_time_s REAL NOT NULL,         -- the stimulus's own time that the frame shows
  scheduled_ns INTEGER NOT NULL,
  submitted_ns INTEGER NOT NULL,
  flipped_ns INTEGER NOT NULL,
  missed_slots INTEGER NOT NULL,      -- > 0: the frame was late by so many refreshes
  PRIMARY KEY (attempt_id, frame)
) STRICT, WITHOUT ROWID;

-- Samples of the gaze during the stimulus, as they came: the newest valid one decides a step.
CREATE TABLE gaze (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  sample INTEGER NOT NULL,            -- from 1
  taken_ns INTEGER NOT NULL,
  x_m REAL,                           -- right of the screen's centre; NULL: lost
  y_m REAL,
  loss TEXT CHECK (loss IN ('blink', 'off screen', 'lost')),  -- why there is no place
  PRIMARY KEY (attempt_id, sample),
  CHECK ((x_m IS NULL) = (y_m IS NULL) AND (x_m IS NULL) = (loss IS NOT NULL))
) STRICT, WITHOUT ROWID;

-- Clicks during the stimulus, all of them.
CREATE TABLE click (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated')),
  arrived_ns INTEGER NOT NULL,
  arrival_uncertainty_ns INTEGER NOT NULL,
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE rating (
  attempt_id INTEGER PRIMARY KEY REFERENCES attempt (id),
  rating INTEGER NOT NULL,
  minimum INTEGER NOT NULL,
  maximum INTEGER NOT NULL,
  best INTEGER NOT NULL,              -- which end is good: never pool scales without it
  low_anchor TEXT NOT NULL,
  high_anchor TEXT NOT NULL,
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated')),
  question_shown_ns INTEGER NOT NULL,
  arrived_ns INTEGER NOT NULL,
  arrival_uncertainty_ns INTEGER NOT NULL,
  CHECK (minimum < maximum AND rating BETWEEN minimum AND maximum),
  CHECK (best IN (minimum, maximum))
) STRICT;

CREATE TABLE answer (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  kind TEXT NOT NULL CHECK (kind IN ('consent', 'demographic', 'question')),
  question TEXT NOT NULL,             -- its id in the protocol
  words TEXT NOT NULL,                -- as they were asked
  answer TEXT                         -- NULL: left empty
) STRICT;

CREATE TABLE note (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  written_utc TEXT NOT NULL,
  kind TEXT NOT NULL,
  text TEXT NOT NULL
) STRICT;
