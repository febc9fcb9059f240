-- A study: one SQLite file. Written by `impetus run`; read by anybody.
--
--   participant --< enrolment >-- protocol        who does which protocol, with which seed
--                      |
--                      +--< trial                  the plan: stored before the first is shown
--                      |      +--< attempt --< step, collision, frame, gaze, click, marker, sound,
--                      |      |              rating, response
--                      +--< session                one sitting; a resumed enrolment has several
--                             +--< answer, note, calibration --< calibration_point
--
-- Analysts: read the views in views.sql; tables may change with the schema version, views keep
-- their columns. Times are nanoseconds of a monotonic clock unless the name says otherwise.

CREATE TABLE study (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  created_utc TEXT NOT NULL,          -- when the file was made
  build TEXT NOT NULL,                -- of the program that made it
  anonymised_by TEXT                  -- build that took out who took part; NULL: nothing was
) STRICT;

-- Files of other stations of the study whose participants were taken in by `impetus merge`.
CREATE TABLE merged_file (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,                 -- without its folder
  hash TEXT NOT NULL UNIQUE,          -- of the file's bytes
  created_utc TEXT NOT NULL,          -- of the study that it was
  build TEXT NOT NULL,                -- that made it
  merged_utc TEXT NOT NULL            -- when that was done
) STRICT;

CREATE TABLE protocol (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,                 -- the protocol's own
  hash TEXT NOT NULL UNIQUE,          -- of protocol_json and scene_json
  protocol_json TEXT NOT NULL,        -- the file as it was read
  scene_json TEXT NOT NULL            -- its scene, with what its meshes hold
) STRICT;

CREATE TABLE participant (
  id INTEGER PRIMARY KEY,
  pseudonym TEXT NOT NULL UNIQUE CHECK (length(pseudonym) > 0),
                                      -- the code that was given at enrolment
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),  -- 1: no person took part
  merged_file_id INTEGER REFERENCES merged_file (id)  -- NULL: recorded in this file
) STRICT;

CREATE TABLE enrolment (
  id INTEGER PRIMARY KEY,
  participant_id INTEGER NOT NULL REFERENCES participant (id),
  protocol_id INTEGER NOT NULL REFERENCES protocol (id),
  seed INTEGER NOT NULL,              -- of the order, and of all that is drawn
  planned_utc TEXT NOT NULL,          -- when the plan was stored
  finished_utc TEXT,                  -- NULL until the last page was answered
  UNIQUE (participant_id, protocol_id)
) STRICT;

CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  started_utc TEXT NOT NULL,          -- by the wall clock
  ended_utc TEXT,                     -- NULL when the process was killed
  ending TEXT CHECK (ending IN ('finished', 'quit', 'declined', 'display closed', 'failed')),
                                      -- declined: no consent; it was 'quit' before schema 7; NULL:
                                      -- the process was killed
  recording_format INTEGER NOT NULL,  -- which builds can replay it
  build TEXT NOT NULL,                -- version, commit, compiler, flags
  machine TEXT NOT NULL,              -- system, its release, processor
  display TEXT NOT NULL,              -- driver, renderer, what a flip's stamp is anchored to
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),  -- 1: no person took part
  observer TEXT,                      -- JSON parameters of the simulated participant
  screen_width_m REAL NOT NULL CHECK (screen_width_m > 0),  -- of the visible area
  screen_height_m REAL NOT NULL CHECK (screen_height_m > 0),  -- of the visible area
  screen_width_px INTEGER NOT NULL CHECK (screen_width_px > 0),  -- as driven
  screen_height_px INTEGER NOT NULL CHECK (screen_height_px > 0),  -- as driven
  viewing_distance_m REAL NOT NULL CHECK (viewing_distance_m > 0),  -- from the eye to the screen
  screen_measured INTEGER NOT NULL CHECK (screen_measured IN (0, 1)),  -- 0: assumed, not entered
  refresh_hz REAL NOT NULL CHECK (refresh_hz > 0),                     -- nominal: the frame grid
  rounding_allowed INTEGER NOT NULL CHECK (rounding_allowed IN (0, 1)),  -- 1: to whole frames
  sync_tries INTEGER NOT NULL,        -- of the sync test; 0: not run
  sync_valid_flips INTEGER NOT NULL,  -- that its last try measured
  sync_mean_interval_ns REAL,         -- between flips; NULL: not measured
  sync_sd_interval_ns REAL,           -- standard deviation; NULL: not measured
  sync_passed INTEGER NOT NULL CHECK (sync_passed IN (0, 1)),  -- 1: yes
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1)),  -- 1: went on without
  series TEXT,                        -- name of the series of protocols it was part of; NULL: none
  series_place INTEGER CHECK (series_place >= 1), -- of this protocol in the series
  -- NULL, here and below: the enrolment's first session, or recorded before schema 5.
  resumed_at TEXT CHECK (resumed_at IN ('trial', 'block')),  -- from whose start it went on
  resumed_after_s REAL,               -- by the wall clock, since anything was last recorded; < 0:
                                      -- that clock was set back
  first_slot INTEGER,                 -- the planned trial it began with; NULL too: none was left
  gaze_source TEXT,                   -- NULL: gaze not followed
  photodiode_patch TEXT,              -- its corner, 'bottom left', ...; NULL: none
  screen_black_cd_m2 REAL CHECK (screen_black_cd_m2 >= 0),  -- luminance; NULL: not measured
  screen_white_cd_m2 REAL CHECK (screen_white_cd_m2 > screen_black_cd_m2),  -- NULL: not measured
  screen_gamma REAL CHECK (screen_gamma > 0),  -- of the greys between; NULL: not measured
  page_name TEXT,                     -- of the web page it ran in, by which its parts go; NULL: none
  page_key TEXT,                      -- who knows it may go on; NULL: no page, or nobody may
  page_parts INTEGER CHECK (page_parts >= 0)  -- of the record that the page has handed over; NULL:
                                      -- no page
) STRICT;

CREATE TABLE trial (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  slot INTEGER NOT NULL CHECK (slot >= 1),  -- place in the plan
  -- Only main trials are pooled; of those of adaptation nothing is asked.
  phase TEXT NOT NULL CHECK (phase IN ('practice', 'main', 'adaptation')),
  repetition INTEGER NOT NULL CHECK (repetition >= 1),  -- of its condition
  condition TEXT NOT NULL CHECK (json_valid(condition)),  -- {"factor": level, ...}
  seed INTEGER NOT NULL,              -- of the trial's own draws
  block INTEGER NOT NULL DEFAULT 1 CHECK (block >= 1),    -- in the order shown
  catch INTEGER NOT NULL DEFAULT 0 CHECK (catch IN (0, 1)),  -- a catch trial, outside the design
  track INTEGER,                      -- adaptive: which track decides the level; NULL: fixed
  -- Adaptive: what the track knew when it chose the level that condition then got, {"name": number}.
  -- NULL until the trial is next (condition lacks the level until then); a replay derives it anew.
  adaptive_state TEXT CHECK (adaptive_state IS NULL OR json_valid(adaptive_state)),
  -- Values solved before the plan was stored, put into the scene: {"/pointer": number}; NULL: none.
  solved TEXT CHECK (solved IS NULL OR json_valid(solved)),
  yoked_trial_id INTEGER REFERENCES trial (id),  -- whose recorded gaze its region follows
  UNIQUE (enrolment_id, slot)
) STRICT;

CREATE TABLE attempt (
  id INTEGER PRIMARY KEY,
  trial_id INTEGER NOT NULL REFERENCES trial (id),
  session_id INTEGER NOT NULL REFERENCES session (id),
  number INTEGER NOT NULL CHECK (number >= 1),  -- of the showing
  -- Set aside: was completed, but a resumed session began its block anew.
  outcome TEXT NOT NULL CHECK (outcome IN ('completed', 'interrupted', 'set aside')),
  onset_ns INTEGER NOT NULL,          -- flip of the first frame of the stimulus; 0: never shown
  intended_hold_ms REAL NOT NULL,     -- freeze that the condition asks for
  realised_hold_ms REAL NOT NULL,     -- differs only when rounding was allowed
  timed_frames INTEGER NOT NULL,      -- frames of fixation and stimulus
  late_timed_frames INTEGER NOT NULL, -- of these, shown late
  late_untimed_frames INTEGER NOT NULL,  -- late, on the question and in the interval
  sync_overridden INTEGER NOT NULL CHECK (sync_overridden IN (0, 1)),
                                      -- 1: the session's sync test failed
  gaze_source TEXT,                   -- 'mouse', 'simulated eye', ...; NULL: gaze not followed
  gaze_latency_p95_ms REAL,           -- sample to flip, 95th percentile over the steps
  gaze_late INTEGER NOT NULL DEFAULT 0 CHECK (gaze_late IN (0, 1)),  -- that exceeded 80 ms
  region_covered_share REAL,          -- of the enclosure's image, inside the region, mean
  interrupted_by TEXT,                -- 'pause', 'display closed', 'gaze lost'; NULL: completed
  gaze_lost_share REAL,               -- of the stimulus, time without a valid sample; NULL: no gaze
  imposed_gaze_latency_ms REAL,       -- samples younger than this were not used; NULL: no gaze
  saved_utc TEXT,                     -- NULL: recorded before schema 5
  set_aside_in INTEGER REFERENCES session (id),  -- the session that set it aside
  UNIQUE (trial_id, number),
  CHECK ((outcome = 'set aside') = (set_aside_in IS NOT NULL))
) STRICT;
CREATE UNIQUE INDEX one_completed_attempt ON attempt (trial_id) WHERE outcome = 'completed';

CREATE TABLE step (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  step INTEGER NOT NULL CHECK (step >= 0),  -- 0: the state at the start
  work_granted INTEGER NOT NULL,            -- units of work; a test of a pair of nodes is one
  work_spent INTEGER NOT NULL,        -- at most what was granted, or the floor
  degradations INTEGER NOT NULL,            -- bits, see engine/world/step.hpp
  hash INTEGER NOT NULL,                    -- of the bodies' state, 64 bits
  digests BLOB NOT NULL,                    -- 16 bits per body and field, little endian
  fixation_x_m REAL,                        -- right of the screen's centre; NULL: not known
  fixation_y_m REAL,                        -- above it
  fixation_taken_ns INTEGER,                -- when the sample behind it was taken
  fixation_age_ns INTEGER,                  -- of that sample when the step was computed
  region_x_m REAL,                          -- centre of the region of high priority; NULL: none
  region_y_m REAL,                    -- above the screen's centre
  region_radius_deg REAL,             -- NULL: none
  shown_frame INTEGER,                      -- of this attempt, the first to show it; NULL: none
  pops INTEGER NOT NULL DEFAULT 0,          -- pairs that touch at a coarser level than before
  largest_pop_deg REAL,                     -- visual angle that bounds grew by; NULL: no pop
  stopped_short INTEGER NOT NULL DEFAULT 0, -- pairs stopped at entry, or they had passed through
  cut_work TEXT,                      -- units granted to phases that were refused some, other than
                                      -- refinement, as entry 1200; NULL: none was
  PRIMARY KEY (attempt_id, interval, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE collision (
  id INTEGER PRIMARY KEY,
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  step INTEGER NOT NULL,              -- in which the pair began to touch
  body_a TEXT NOT NULL,               -- its name in the scene
  body_b TEXT NOT NULL,               -- its name, or that of a wall
  level INTEGER NOT NULL,             -- of the volume tree that was used, 0 the coarsest
  stopped TEXT NOT NULL CHECK (stopped IN ('finest', 'budget', 'greatest level', 'capped')),
                                      -- why there
  point_x_m REAL NOT NULL, point_y_m REAL NOT NULL, point_z_m REAL NOT NULL,  -- in the scene
  normal_x REAL NOT NULL, normal_y REAL NOT NULL, normal_z REAL NOT NULL,  -- from b to a
  depth_m REAL NOT NULL,              -- how deep the volumes overlap
  approach_m_s REAL NOT NULL,         -- speed along the normal before the response
  impulse_Ns REAL NOT NULL,           -- along the normals, sum over contacts
  imposed_hold_ms REAL NOT NULL,      -- imposed manipulation: the freeze this contact started
  imposed_no_spin INTEGER NOT NULL CHECK (imposed_no_spin IN (0, 1)),  -- imposed: no rotation
  eccentricity_deg REAL NOT NULL,     -- of the contact from the screen's centre
  first_frame INTEGER,                -- of the stimulus; NULL: no frame showed it
  list INTEGER NOT NULL DEFAULT 0,    -- priority list it was refined in, from 0
  time_s REAL,                        -- of the stimulus; NULL: recorded before schema 2
  gaze_eccentricity_deg REAL,         -- of the contact from the fixation; NULL: not known
  region_eccentricity_deg REAL,       -- from the centre of the region; NULL: none
  contacts INTEGER NOT NULL DEFAULT 1 CHECK (contacts >= 1),  -- point and normal are the deepest's
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  -- As the viewer sees it when it begins; NULL: recorded before schema 4.
  distance_m REAL,                    -- of the contact from the eye
  speed_deg_s REAL,                   -- mean projected speed of both bodies (a wall's is 0)
  collision_speed_deg_s REAL,         -- projected speed of one against the other
  priority REAL,                      -- value of the scheduler's metric, in its unit; NULL: none
  -- Imposed manipulation: change of angular velocity drawn for body a and body b; NULL: none.
  imposed_spin_a_x_rad_s REAL, imposed_spin_a_y_rad_s REAL, imposed_spin_a_z_rad_s REAL,
  imposed_spin_b_x_rad_s REAL, imposed_spin_b_y_rad_s REAL, imposed_spin_b_z_rad_s REAL
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
  frame INTEGER NOT NULL,             -- of the attempt, in the order shown
  phase TEXT NOT NULL CHECK (phase IN ('fixation', 'stimulus')),  -- what was shown
  shown_time_s REAL NOT NULL,         -- the stimulus's own time that the frame shows
  scheduled_ns INTEGER NOT NULL,      -- when the flip was due
  submitted_ns INTEGER NOT NULL,      -- when drawing was handed over
  flipped_ns INTEGER NOT NULL,        -- when it was on the screen, as far as known
  missed_slots INTEGER NOT NULL,      -- > 0: the frame was late by so many refreshes
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  patch INTEGER,                      -- code that the photodiode patch showed; NULL: no patch
  PRIMARY KEY (attempt_id, frame)
) STRICT, WITHOUT ROWID;

-- Samples of the gaze during the stimulus, as they came, raw: the newest valid one, corrected by the
-- session's last calibration, decides a step.
CREATE TABLE gaze (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  sample INTEGER NOT NULL,            -- from 1
  taken_ns INTEGER NOT NULL,          -- when the sample was taken
  x_m REAL,                           -- right of the screen's centre; NULL: lost
  y_m REAL,                           -- above it; NULL: lost
  loss TEXT CHECK (loss IN ('blink', 'off screen', 'lost')),  -- why there is no place
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  PRIMARY KEY (attempt_id, sample),
  CHECK ((x_m IS NULL) = (y_m IS NULL) AND (x_m IS NULL) = (loss IS NOT NULL))
) STRICT, WITHOUT ROWID;

-- Clicks during the stimulus, all of them.
CREATE TABLE click (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),  -- in the order made
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated')),
                                      -- simulated: no person clicked
  arrived_ns INTEGER NOT NULL,        -- when the program got it
  arrival_uncertainty_ns INTEGER NOT NULL,  -- may be this much earlier
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

-- Markers that were sent to another recorder, such as an EEG's amplifier.
CREATE TABLE marker (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),  -- in the order sent
  event TEXT NOT NULL CHECK (event IN ('fixation', 'onset', 'contact', 'end', 'click', 'answer')),
                                      -- what it marks
  code INTEGER NOT NULL CHECK (code BETWEEN 1 AND 255),  -- that was sent, as the protocol names it
  event_ns INTEGER NOT NULL,          -- the flip or the arrival that it marks
  written_ns INTEGER,                 -- when the system had taken it; NULL: it did not in time
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

-- Sounds at contacts, in the order handed over.
CREATE TABLE sound (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),  -- in the order planned
  step INTEGER,                       -- in which the contact began; NULL: it is of a time from onset
  lag_ms REAL NOT NULL,               -- from the flip that shows it to the sound, as asked for
  loudness REAL NOT NULL CHECK (loudness > 0 AND loudness <= 1),  -- share of what the device can give
  shown_ns INTEGER,                   -- the flip that showed the contact; NULL: it was not shown
  intended_ns INTEGER NOT NULL,       -- its onset, as was foreseen when it was handed over
  realised_ns INTEGER,                -- when its onset left the device's buffer; NULL: not known
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
                                      -- which stimulus of a two-interval trial; otherwise 1
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE rating (
  attempt_id INTEGER PRIMARY KEY REFERENCES attempt (id),
  rating INTEGER NOT NULL,            -- as given
  minimum INTEGER NOT NULL,           -- of the scale
  maximum INTEGER NOT NULL,           -- of the scale
  best INTEGER NOT NULL,              -- which end is good: never pool scales without it
  low_anchor TEXT NOT NULL,           -- words at the scale's minimum
  high_anchor TEXT NOT NULL,          -- words at the scale's maximum
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated')),
                                      -- simulated: no person rated
  question_shown_ns INTEGER NOT NULL, -- flip that showed the question
  arrived_ns INTEGER NOT NULL,        -- when the program got the answer
  arrival_uncertainty_ns INTEGER NOT NULL,  -- may be this much earlier
  CHECK (minimum < maximum AND rating BETWEEN minimum AND maximum),
  CHECK (best IN (minimum, maximum))
) STRICT;

-- Answers to a trial's questions other than ratings; question_shown_ns tells in which order they were
-- asked.
CREATE TABLE response (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),  -- of the kinds in their order, whatever was asked first
  kind TEXT NOT NULL,                 -- 'yes_no', 'two_interval', 'choice', ...
  question TEXT NOT NULL,             -- the words that were asked
  answer TEXT,                        -- 'yes', 'first', free words; NULL: timed out or left empty
  positive INTEGER CHECK (positive IN (0, 1)),  -- counts towards the threshold: seen, chosen right
  correct INTEGER CHECK (correct IN (0, 1)),    -- NULL: there is no right answer
  detail TEXT NOT NULL CHECK (json_valid(detail)),  -- what else the kind records, {"name": value}
  device TEXT NOT NULL CHECK (device IN ('key', 'mouse', 'simulated', 'none')),  -- none: timed out
  question_shown_ns INTEGER NOT NULL, -- flip that showed the question
  arrived_ns INTEGER NOT NULL,        -- when the program got the answer
  arrival_uncertainty_ns INTEGER NOT NULL,  -- may be this much earlier
  timed_out INTEGER NOT NULL DEFAULT 0 CHECK (timed_out IN (0, 1)),  -- 1: no answer in time
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;

-- One run through the points of a calibration, a validation or a drift check of the gaze.
CREATE TABLE calibration (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  kind TEXT NOT NULL CHECK (kind IN ('calibration', 'validation', 'drift check')),
                                      -- a drift check corrects nothing
  number INTEGER NOT NULL CHECK (number >= 1),     -- try, from 1, of its kind and occasion
  before_slot INTEGER NOT NULL,                    -- the planned trial that comes next
  gaze_source TEXT NOT NULL,          -- 'mouse', 'simulated eye', ...
  accuracy_deg REAL,                  -- mean distance of gaze from the points; NULL: nothing valid
  worst_accuracy_deg REAL,            -- of the worst point
  precision_rms_deg REAL,             -- RMS of distances from sample to sample
  precision_sd_deg REAL,              -- standard deviation about each point's mean
  lost_share REAL NOT NULL,           -- of the samples
  sampling_hz REAL,                   -- as measured
  accuracy_limit_deg REAL NOT NULL,   -- the protocol's
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)),  -- 1: within the limit
  began_ns INTEGER NOT NULL,          -- when its first point was shown
  -- Of a calibration: what was done from then on to raw samples, so that a step used
  -- (x0 + xx·x + xy·y, y0 + yx·x + yy·y); NULL: nothing new.
  correction_x0_m REAL, correction_xx REAL, correction_xy REAL,
  correction_y0_m REAL, correction_yx REAL, correction_yy REAL
) STRICT;

CREATE TABLE calibration_point (
  calibration_id INTEGER NOT NULL REFERENCES calibration (id),
  point INTEGER NOT NULL CHECK (point >= 1),  -- in the order shown
  x_m REAL NOT NULL, y_m REAL NOT NULL,            -- shown, right of and above the centre
  -- Mean of the valid samples, raw in a calibration, corrected in the others; NULL: none.
  gaze_x_m REAL, gaze_y_m REAL,
  accuracy_deg REAL, precision_rms_deg REAL, precision_sd_deg REAL,
                                      -- of this point; NULL: nothing valid
  samples INTEGER NOT NULL,           -- while it was shown
  lost INTEGER NOT NULL,              -- of these, without a place
  PRIMARY KEY (calibration_id, point)
) STRICT, WITHOUT ROWID;

CREATE TABLE answer (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  kind TEXT NOT NULL CHECK (kind IN ('consent', 'demographic', 'question')),
                                      -- by the page that asked
  question TEXT NOT NULL,             -- its id in the protocol
  words TEXT NOT NULL,                -- as they were asked
  answer TEXT                         -- NULL: left empty
) STRICT;

CREATE TABLE note (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session (id),
  written_utc TEXT NOT NULL,          -- by the wall clock
  kind TEXT NOT NULL,                 -- what it is about
  text TEXT NOT NULL                  -- for the reader of the study
) STRICT;

-- Who or what the analysis leaves out, and why. Never deleted: taken back by a later row.
CREATE TABLE exclusion (
  id INTEGER PRIMARY KEY,
  participant_id INTEGER NOT NULL REFERENCES participant (id),
  trial_id INTEGER REFERENCES trial (id),          -- NULL: all of the participant's trials
  excluded INTEGER NOT NULL CHECK (excluded IN (0, 1)),  -- 0: taken back; the last row counts
  reason TEXT NOT NULL CHECK (length(reason) > 0),  -- in the words of who decided
  decided_utc TEXT NOT NULL           -- by the wall clock
) STRICT;
