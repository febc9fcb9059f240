-- From schema 9 to 10: trials of adaptation, among the main ones. A CHECK changes only with its
-- table, so trial is copied. Views are made anew afterwards.

CREATE TABLE trial_10 (
  id INTEGER PRIMARY KEY,
  enrolment_id INTEGER NOT NULL REFERENCES enrolment (id),
  slot INTEGER NOT NULL CHECK (slot >= 1),
  phase TEXT NOT NULL CHECK (phase IN ('practice', 'main', 'adaptation')),
  repetition INTEGER NOT NULL CHECK (repetition >= 1),
  condition TEXT NOT NULL CHECK (json_valid(condition)),
  seed INTEGER NOT NULL,
  block INTEGER NOT NULL DEFAULT 1 CHECK (block >= 1),
  catch INTEGER NOT NULL DEFAULT 0 CHECK (catch IN (0, 1)),
  track INTEGER,
  adaptive_state TEXT CHECK (adaptive_state IS NULL OR json_valid(adaptive_state)),
  solved TEXT CHECK (solved IS NULL OR json_valid(solved)),
  yoked_trial_id INTEGER REFERENCES trial (id),
  UNIQUE (enrolment_id, slot)
) STRICT;

INSERT INTO trial_10 (
  id, enrolment_id, slot, phase, repetition, condition, seed, block, catch, track, adaptive_state,
  solved, yoked_trial_id)
SELECT
  id, enrolment_id, slot, phase, repetition, condition, seed, block, catch, track, adaptive_state,
  solved, yoked_trial_id
FROM trial;

DROP TABLE trial;
ALTER TABLE trial_10 RENAME TO trial;
