-- A study: one SQLite file. Written by `impetus run`; read by anybody.
--
--   participant --< enrolment >-- protocol        who does which protocol, with which seed
--                      |
--                      +--< trial                  the plan: stored before the first is shown
--                      |      +--< attempt --< step, collision, frame, gaze, click, rating
--                      +--< session                one sitting; a resumed enrolment has several
--                             +--< answer, note
--
-- Analysts: read the views at the end; tables may change with the schema version, views keep
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
  work_granted INTEGER NOT NULL,            -- node-pair tests
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
  PRIMARY KEY (attempt_id, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE collision (
  id INTEGER PRIMARY KEY,
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  step INTEGER NOT NULL,
  body_a TEXT NOT NULL,
  body_b TEXT NOT NULL,
  level INTEGER NOT NULL,
  stopped TEXT NOT NULL CHECK (stopped IN ('finest', 'budget', 'greatest level')),
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
  region_eccentricity_deg REAL        -- from the centre of the region; NULL: none
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

-- ---------------------------------------------------------------- views, for analysts

-- One row per rated trial, practice included (phase tells).
CREATE VIEW rated_trial AS
SELECT participant.pseudonym AS participant,
       participant.simulated AS simulated,
       protocol.name AS protocol,
       protocol.hash AS protocol_hash,
       session.id AS session,
       trial.id AS trial,
       trial.slot AS slot,
       trial.phase AS phase,
       trial.repetition AS repetition,
       trial.condition AS condition,
       attempt.number AS attempt,
       rating.rating AS rating,
       rating.minimum AS rating_minimum,
       rating.maximum AS rating_maximum,
       rating.best AS rating_best,
       rating.low_anchor AS low_anchor,
       rating.high_anchor AS high_anchor,
       rating.device AS device,
       (rating.arrived_ns - rating.question_shown_ns) / 1e6 AS reaction_time_ms,
       attempt.intended_hold_ms AS intended_hold_ms,
       attempt.realised_hold_ms AS realised_hold_ms,
       attempt.timed_frames AS timed_frames,
       attempt.late_timed_frames AS late_timed_frames,
       attempt.sync_overridden AS sync_overridden,
       attempt.gaze_source AS gaze_source,
       attempt.gaze_latency_p95_ms AS gaze_latency_p95_ms,
       attempt.gaze_late AS gaze_late,
       attempt.region_covered_share AS region_covered_share
FROM rating
JOIN attempt ON attempt.id = rating.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN session ON session.id = attempt.session_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per collision of a completed attempt, with its truth where `replay --truth` filled it.
CREATE VIEW seen_collision AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       collision.step AS step,
       collision.body_a AS body_a,
       collision.body_b AS body_b,
       collision.level AS level,
       collision.stopped AS stopped,
       collision.imposed_hold_ms AS imposed_hold_ms,
       collision.imposed_no_spin AS imposed_no_spin,
       collision.eccentricity_deg AS eccentricity_deg,
       collision.first_frame AS first_frame,
       collision_truth.gap_m AS gap_m,
       collision_truth.gap_px AS gap_px,
       collision_truth.gap_arcmin AS gap_arcmin,
       collision_truth.hidden_share AS hidden_share,
       collision.list AS list,
       collision.time_s AS time_s,
       collision.gaze_eccentricity_deg AS gaze_eccentricity_deg,
       collision.region_eccentricity_deg AS region_eccentricity_deg
FROM collision
JOIN attempt ON attempt.id = collision.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN collision_truth ON collision_truth.collision_id = collision.id;

-- One row per completed trial of a protocol that asks for clicks: how many, in which time.
CREATE VIEW click_trial AS
SELECT participant.pseudonym AS participant,
       participant.simulated AS simulated,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.slot AS slot,
       trial.phase AS phase,
       trial.repetition AS repetition,
       trial.condition AS condition,
       (SELECT count(*) FROM click WHERE click.attempt_id = attempt.id) AS clicks,
       (SELECT max(frame.shown_time_s) FROM frame WHERE frame.attempt_id = attempt.id)
         AS exposure_s,
       json_extract(protocol.protocol_json, '$.clicks.merge_within_ms') AS merge_within_ms
FROM attempt
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE attempt.outcome = 'completed'
  AND json_type(protocol.protocol_json, '$.clicks') IS NOT NULL;

-- One row per click of a completed attempt, in the stimulus's own time.
CREATE VIEW trial_click AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       click.number AS number,
       (click.arrived_ns - attempt.onset_ns) / 1e9 AS time_s,
       click.arrival_uncertainty_ns / 1e6 AS uncertainty_ms,
       click.device AS device
FROM click
JOIN attempt ON attempt.id = click.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per gaze sample of a completed attempt, in the stimulus's own time.
CREATE VIEW gaze_sample AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       attempt.gaze_source AS gaze_source,
       (gaze.taken_ns - attempt.onset_ns) / 1e9 AS time_s,
       gaze.x_m AS x_m,
       gaze.y_m AS y_m,
       gaze.loss AS loss
FROM gaze
JOIN attempt ON attempt.id = gaze.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per step of a completed attempt that knew the gaze or had a region: the sample used, its
-- age, and how long it took from the sample to the flip that first showed the step.
CREATE VIEW gaze_step AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       attempt.gaze_source AS gaze_source,
       step.step AS step,
       step.fixation_x_m AS fixation_x_m,
       step.fixation_y_m AS fixation_y_m,
       step.fixation_age_ns / 1e6 AS fixation_age_ms,
       step.region_x_m AS region_x_m,
       step.region_y_m AS region_y_m,
       step.region_radius_deg AS region_radius_deg,
       step.shown_frame AS shown_frame,
       (shown.flipped_ns - step.fixation_taken_ns) / 1e6 AS sample_to_flip_ms
FROM step
JOIN attempt ON attempt.id = step.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN frame AS shown
  ON shown.attempt_id = step.attempt_id AND shown.frame = step.shown_frame
WHERE step.fixation_x_m IS NOT NULL OR step.region_x_m IS NOT NULL;

-- One row per trial and factor: the condition in long form. `level` keeps its type.
CREATE VIEW trial_level AS
SELECT trial.id AS trial, json_each.key AS factor, json_each.value AS level
FROM trial, json_each(trial.condition);

-- One row per participant and protocol: how far, how well timed.
CREATE VIEW enrolment_summary AS
SELECT participant.pseudonym AS participant,
       participant.simulated AS simulated,
       protocol.name AS protocol,
       enrolment.seed AS seed,
       enrolment.planned_utc AS planned_utc,
       enrolment.finished_utc AS finished_utc,
       (SELECT count(*) FROM trial
        WHERE trial.enrolment_id = enrolment.id AND trial.phase = 'main') AS planned_trials,
       (SELECT count(*) FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id AND trial.phase = 'main'
          AND attempt.outcome = 'completed') AS completed_trials,
       (SELECT count(*) FROM session WHERE session.enrolment_id = enrolment.id) AS sessions,
       (SELECT sum(attempt.timed_frames) FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id) AS timed_frames,
       (SELECT sum(attempt.late_timed_frames)
        FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id) AS late_timed_frames,
       (SELECT max(session.sync_overridden) FROM session
        WHERE session.enrolment_id = enrolment.id) AS sync_overridden
FROM enrolment
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per question outside trials.
CREATE VIEW questionnaire AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       session.id AS session,
       answer.kind AS kind,
       answer.question AS question,
       answer.words AS words,
       answer.answer AS answer
FROM answer
JOIN session ON session.id = answer.session_id
JOIN enrolment ON enrolment.id = session.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;
