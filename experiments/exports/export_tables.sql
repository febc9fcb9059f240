-- The tables of an export, a query each, in the order of the codebook. The line above a query names the
-- file and says what one row is. Each holds all columns of one table of the study, which stands after
-- FROM, after a few that say whose they are; joins are outer ones, so that no row is lost.
--
--   participant, protocol, slot, ...  |  all columns of `collision`  |  measured gaps
--          who, which                         the table's                  more
--
-- Where {factors} stands, each factor of the study's trials becomes a column.

-- study: One row: the study file
SELECT study.*
FROM study
ORDER BY study.id;

-- merged_files: One row per file that was merged into the study
SELECT merged_file.*
FROM merged_file
ORDER BY merged_file.id;

-- protocols: One row per protocol; its file and scene, as they were read, are protocols/ID-NAME-HASH.protocol.json and .scene.json
SELECT protocol.id, protocol.name, protocol.hash
FROM protocol
ORDER BY protocol.id;

-- participants: One row per participant
SELECT participant.*
FROM participant
ORDER BY participant.id;

-- enrolments: One row per participant and protocol: the plan
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, enrolment.*
FROM enrolment
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY enrolment.id;

-- sessions: One row per sitting: machine, display, screen, sync test, how it began and ended
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, session.*
FROM session
LEFT JOIN enrolment ON enrolment.id = session.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY session.id;

-- trials: One row per planned trial, shown or not, with its completed attempt and the answers
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, {factors} trial.*,
  coalesce(attempt.outcome, CASE WHEN EXISTS (SELECT 1 FROM attempt AS shown WHERE shown.trial_id =
    trial.id) THEN 'not completed' ELSE 'not shown' END) AS outcome,
  (SELECT count(*) FROM attempt AS shown WHERE shown.trial_id = trial.id) AS attempts,
  attempt.id AS attempt_id, attempt.session_id, attempt.saved_utc, attempt.onset_ns,
  attempt.intended_hold_ms, attempt.realised_hold_ms, attempt.timed_frames,
  attempt.late_timed_frames, attempt.late_untimed_frames, attempt.sync_overridden,
  attempt.gaze_source, attempt.gaze_latency_p95_ms, attempt.gaze_late, attempt.gaze_lost_share,
  attempt.imposed_gaze_latency_ms, attempt.region_covered_share, rating.rating,
  rating.minimum AS rating_minimum, rating.maximum AS rating_maximum, rating.best AS rating_best,
  rating.low_anchor AS rating_low_anchor, rating.high_anchor AS rating_high_anchor,
  rating.device AS rating_device,
  (rating.arrived_ns - rating.question_shown_ns) / 1e6 AS rating_time_ms,
  (SELECT count(*) FROM response AS given WHERE given.attempt_id = attempt.id) AS responses,
  response.kind AS response_kind, response.question AS response_question,
  response.answer AS response_answer, response.positive AS response_positive,
  response.correct AS response_correct, response.device AS response_device,
  response.timed_out AS response_timed_out,
  (response.arrived_ns - response.question_shown_ns) / 1e6 AS response_time_ms,
  CASE WHEN attempt.id IS NULL THEN NULL ELSE (SELECT count(*) FROM click WHERE click.attempt_id =
    attempt.id) END AS clicks,
  CASE WHEN attempt.id IS NULL THEN NULL ELSE (SELECT count(*) FROM collision WHERE
    collision.attempt_id = attempt.id) END AS collisions,
  EXISTS (SELECT 1 FROM excluded WHERE excluded.participant = participant.pseudonym AND
    (excluded.trial IS NULL OR excluded.trial = trial.id)) AS excluded,
  (SELECT group_concat(excluded.reason, '; ') FROM excluded WHERE excluded.participant =
    participant.pseudonym AND (excluded.trial IS NULL OR excluded.trial = trial.id)) AS
    exclusion_reasons
FROM trial
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN attempt ON attempt.trial_id = trial.id AND attempt.outcome = 'completed'
LEFT JOIN rating ON rating.attempt_id = attempt.id
LEFT JOIN response ON response.attempt_id = attempt.id AND response.number = 1
ORDER BY trial.enrolment_id, trial.slot;

-- attempts: One row per showing of a trial, completed or not
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.slot AS slot, trial.phase AS trial_phase, attempt.*
FROM attempt
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY attempt.id;

-- ratings: One row per rating
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, rating.*
FROM rating
LEFT JOIN attempt ON attempt.id = rating.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY rating.attempt_id;

-- responses: One row per answer to another question of a trial
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, response.*
FROM response
LEFT JOIN attempt ON attempt.id = response.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY response.attempt_id, response.number;

-- collisions: One row per collision, with its gap where `impetus replay --truth` measured it
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, collision.*,
  collision_truth.gap_m, collision_truth.gap_px, collision_truth.gap_arcmin,
  collision_truth.hidden_share
FROM collision
LEFT JOIN attempt ON attempt.id = collision.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN collision_truth ON collision_truth.collision_id = collision.id
ORDER BY collision.id;

-- clicks: One row per click during a stimulus
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, click.*,
  (click.arrived_ns - CASE WHEN click.interval = 1 THEN nullif(attempt.onset_ns, 0) ELSE (SELECT
    min(frame.flipped_ns) FROM frame WHERE frame.attempt_id = click.attempt_id AND frame.phase =
    'stimulus' AND frame.interval = click.interval) END) / 1e9 AS stimulus_time_s
FROM click
LEFT JOIN attempt ON attempt.id = click.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY click.attempt_id, click.number;

-- markers: One row per marker that was sent to another recorder
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, marker.*,
  (marker.written_ns - marker.event_ns) / 1e6 AS sent_after_ms
FROM marker
LEFT JOIN attempt ON attempt.id = marker.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY marker.attempt_id, marker.number;

-- sounds: One row per sound at a contact
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, sound.*,
  (sound.realised_ns - sound.shown_ns) / 1e6 AS realised_lag_ms
FROM sound
LEFT JOIN attempt ON attempt.id = sound.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY sound.attempt_id, sound.number;

-- gaze: One row per sample of the gaze during a stimulus, raw
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, gaze.*,
  (gaze.taken_ns - CASE WHEN gaze.interval = 1 THEN nullif(attempt.onset_ns, 0) ELSE (SELECT
    min(frame.flipped_ns) FROM frame WHERE frame.attempt_id = gaze.attempt_id AND frame.phase =
    'stimulus' AND frame.interval = gaze.interval) END) / 1e9 AS stimulus_time_s
FROM gaze
LEFT JOIN attempt ON attempt.id = gaze.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY gaze.attempt_id, gaze.sample;

-- frames: One row per frame that was shown
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, frame.*
FROM frame
LEFT JOIN attempt ON attempt.id = frame.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY frame.attempt_id, frame.frame;

-- steps: One row per step of the simulation
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase,
  attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, step.*
FROM step
LEFT JOIN attempt ON attempt.id = step.attempt_id
LEFT JOIN trial ON trial.id = attempt.trial_id
LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY step.attempt_id, step.interval, step.step;

-- questionnaire: One row per question outside trials: consent, demographic and other
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, answer.*
FROM answer
LEFT JOIN session ON session.id = answer.session_id
LEFT JOIN enrolment ON enrolment.id = session.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY answer.id;

-- notes: One row per note that the program made in a session
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, note.*
FROM note
LEFT JOIN session ON session.id = note.session_id
LEFT JOIN enrolment ON enrolment.id = session.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY note.id;

-- calibrations: One row per calibration, validation or drift check of the gaze
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, calibration.*
FROM calibration
LEFT JOIN session ON session.id = calibration.session_id
LEFT JOIN enrolment ON enrolment.id = session.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY calibration.id;

-- calibration_points: One row per point of a calibration
SELECT participant.pseudonym AS participant, participant.simulated AS participant_simulated,
  protocol.name AS protocol, session.id AS session_id, calibration_point.*
FROM calibration_point
LEFT JOIN calibration ON calibration.id = calibration_point.calibration_id
LEFT JOIN session ON session.id = calibration.session_id
LEFT JOIN enrolment ON enrolment.id = session.enrolment_id
LEFT JOIN participant ON participant.id = enrolment.participant_id
LEFT JOIN protocol ON protocol.id = enrolment.protocol_id
ORDER BY calibration_point.calibration_id, calibration_point.point;

-- exclusions: One row per decision to leave out a participant or a trial, or to take that back
SELECT participant.pseudonym AS participant, exclusion.*
FROM exclusion
LEFT JOIN participant ON participant.id = exclusion.participant_id
ORDER BY exclusion.id;
