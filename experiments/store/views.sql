-- What analysts read of a study. Tables may change with the schema version; views keep their columns
-- and gain new ones at the end.
--
-- The onset of a second stimulus is looked for from the frame that shows its step 0, which a key
-- finds, for there may be millions of samples; where no steps were kept, from the first frame on.

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
       (rating.arrived_ns - rating.question_shown_ns) / 1e6 AS reaction_time_ms,  -- from question to rating
       attempt.intended_hold_ms AS intended_hold_ms,
       attempt.realised_hold_ms AS realised_hold_ms,
       attempt.timed_frames AS timed_frames,
       attempt.late_timed_frames AS late_timed_frames,
       attempt.sync_overridden AS sync_overridden,
       attempt.gaze_source AS gaze_source,
       attempt.gaze_latency_p95_ms AS gaze_latency_p95_ms,
       attempt.gaze_late AS gaze_late,
       attempt.region_covered_share AS region_covered_share,
       trial.block AS block,
       trial.catch AS catch,
       trial.track AS track,
       attempt.gaze_lost_share AS gaze_lost_share,
       attempt.imposed_gaze_latency_ms AS imposed_gaze_latency_ms
FROM rating
JOIN attempt ON attempt.id = rating.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN session ON session.id = attempt.session_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per question of a completed trial other than a rating, practice included.
CREATE VIEW trial_response AS
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
       trial.block AS block,
       trial.catch AS catch,
       trial.track AS track,
       trial.adaptive_state AS adaptive_state,
       attempt.number AS attempt,
       response.number AS number,
       response.kind AS kind,
       response.question AS question,
       response.answer AS answer,
       response.positive AS positive,
       response.correct AS correct,
       response.detail AS detail,
       response.device AS device,
       response.timed_out AS timed_out,
       (response.arrived_ns - response.question_shown_ns) / 1e6 AS reaction_time_ms,  -- from question to answer
       attempt.realised_hold_ms AS realised_hold_ms,
       attempt.late_timed_frames AS late_timed_frames,
       attempt.sync_overridden AS sync_overridden
FROM response
JOIN attempt ON attempt.id = response.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN session ON session.id = attempt.session_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per calibration, validation or drift check of the gaze.
CREATE VIEW gaze_calibration AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       session.id AS session,
       calibration.id AS calibration,
       calibration.kind AS kind,
       calibration.number AS number,
       calibration.before_slot AS before_slot,
       calibration.gaze_source AS gaze_source,
       calibration.accuracy_deg AS accuracy_deg,
       calibration.worst_accuracy_deg AS worst_accuracy_deg,
       calibration.precision_rms_deg AS precision_rms_deg,
       calibration.precision_sd_deg AS precision_sd_deg,
       calibration.lost_share AS lost_share,
       calibration.sampling_hz AS sampling_hz,
       calibration.accuracy_limit_deg AS accuracy_limit_deg,
       calibration.passed AS passed,
       calibration.correction_x0_m AS correction_x0_m,
       calibration.correction_xx AS correction_xx,
       calibration.correction_xy AS correction_xy,
       calibration.correction_y0_m AS correction_y0_m,
       calibration.correction_yx AS correction_yx,
       calibration.correction_yy AS correction_yy
FROM calibration
JOIN session ON session.id = calibration.session_id
JOIN enrolment ON enrolment.id = session.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- Who meets a rule of the protocol's exclude_when, by answers yes or no and choices of an interval; a
-- row for each rule that is met. Answers in a row are those of one question, in the main phase.
CREATE VIEW excluded_by_rule AS
WITH rule (protocol_id, name, bound) AS MATERIALIZED (
  SELECT protocol.id, rules.key, rules.value
  FROM protocol, json_each(protocol.protocol_json, '$.exclude_when') rules
), given (enrolment_id, phase, saved_utc, correct, question, place, is_equal) AS MATERIALIZED (
  SELECT trial.enrolment_id, trial.phase, attempt.saved_utc, response.correct, response.question,
         row_number() OVER in_order,
         response.answer IS lag(response.answer) OVER in_order
  FROM (SELECT DISTINCT protocol_id FROM rule) ruled
  JOIN enrolment ON enrolment.protocol_id = ruled.protocol_id
  JOIN trial ON trial.enrolment_id = enrolment.id
  JOIN attempt ON attempt.trial_id = trial.id AND attempt.outcome = 'completed'
  JOIN response ON response.attempt_id = attempt.id
    AND response.kind IN ('yes_no', 'two_interval') AND response.timed_out = 0
  WINDOW in_order AS (PARTITION BY trial.enrolment_id, trial.phase, response.question
                      ORDER BY trial.slot)
), with_runs (enrolment_id, question, alike, unlike) AS MATERIALIZED (
  -- A run of equal answers ends where one differs, and the other way round.
  SELECT enrolment_id, question, sum(NOT is_equal) OVER so_far,
         sum(is_equal OR place = 1) OVER so_far
  FROM given WHERE phase = 'main'
  WINDOW so_far AS (PARTITION BY enrolment_id, question ORDER BY place)
), counted (enrolment_id, name, number) AS MATERIALIZED (
  SELECT enrolment_id, 'equal_answers_in_a_row', count(*)
  FROM with_runs GROUP BY enrolment_id, question, alike
  UNION ALL
  SELECT enrolment_id, 'alternations_in_a_row', count(*) - 1
  FROM with_runs GROUP BY enrolment_id, question, unlike
  UNION ALL
  SELECT enrolment_id, 'practice_right_below', sum(correct IS 1 AND phase = 'practice')
  FROM given GROUP BY enrolment_id
  HAVING max(phase = 'main')  -- practice is over
)
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       rule.name AS rule,  -- its key in the protocol
       CASE rule.name WHEN 'practice_right_below' THEN min(counted.number)
         ELSE max(counted.number) END AS number,  -- of answers or alternations, that meets it
       rule.bound AS bound,  -- that the rule has
       (SELECT max(saved_utc) FROM given WHERE given.enrolment_id = enrolment.id) AS latest_utc  -- when the last of the answers was saved
FROM rule
JOIN enrolment ON enrolment.protocol_id = rule.protocol_id
JOIN counted ON counted.enrolment_id = enrolment.id AND counted.name = rule.name
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = rule.protocol_id
GROUP BY enrolment.id, rule.name
HAVING CASE rule.name WHEN 'practice_right_below' THEN min(counted.number) < rule.bound
  ELSE max(counted.number) >= rule.bound END;

-- What the analysis leaves out, and why; `trial` is NULL where that is all of a participant's. Who
-- meets a rule is among them, unless somebody has taken that back.
CREATE VIEW excluded AS
SELECT participant.pseudonym AS participant,
       exclusion.trial_id AS trial,
       exclusion.reason AS reason,
       exclusion.decided_utc AS decided_utc
FROM exclusion
JOIN participant ON participant.id = exclusion.participant_id
WHERE exclusion.excluded = 1
  AND exclusion.id = (SELECT max(later.id) FROM exclusion AS later
                      WHERE later.participant_id = exclusion.participant_id
                        AND later.trial_id IS exclusion.trial_id)
UNION ALL
SELECT participant, NULL, group_concat(
         CASE rule WHEN 'practice_right_below' THEN 'right in practice: ' || number || ', below ' || bound
           ELSE replace(rule, '_', ' ') || ': ' || number || ', at least ' || bound END, ' and '),
       max(latest_utc)
FROM excluded_by_rule
WHERE NOT EXISTS (SELECT 1 FROM exclusion
                  JOIN participant AS decided ON decided.id = exclusion.participant_id
                  WHERE decided.pseudonym = excluded_by_rule.participant AND trial_id IS NULL)
GROUP BY participant;

-- One row per attempt that was not completed: what interrupted it.
CREATE VIEW interrupted_attempt AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       attempt.number AS attempt,
       attempt.interrupted_by AS interrupted_by,
       attempt.gaze_lost_share AS gaze_lost_share
FROM attempt
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE attempt.outcome = 'interrupted';

-- One row per attempt that was completed and then set aside: a resumed session began its block anew.
CREATE VIEW set_aside_attempt AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       attempt.number AS attempt,
       attempt.session_id AS session,
       attempt.set_aside_in AS set_aside_in
FROM attempt
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE attempt.outcome = 'set aside';

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
       collision.region_eccentricity_deg AS region_eccentricity_deg,
       collision.contacts AS contacts,
       collision.interval AS interval,
       collision.distance_m AS distance_m,
       collision.speed_deg_s AS speed_deg_s,
       collision.collision_speed_deg_s AS collision_speed_deg_s,
       collision.priority AS priority,
       collision.imposed_spin_a_x_rad_s AS imposed_spin_a_x_rad_s,
       collision.imposed_spin_a_y_rad_s AS imposed_spin_a_y_rad_s,
       collision.imposed_spin_a_z_rad_s AS imposed_spin_a_z_rad_s,
       collision.imposed_spin_b_x_rad_s AS imposed_spin_b_x_rad_s,
       collision.imposed_spin_b_y_rad_s AS imposed_spin_b_y_rad_s,
       collision.imposed_spin_b_z_rad_s AS imposed_spin_b_z_rad_s
FROM collision
JOIN attempt ON attempt.id = collision.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN collision_truth ON collision_truth.collision_id = collision.id;

-- One row per completed trial of a protocol that asks for clicks: how many, in which time; of both
-- stimuli where it has two.
CREATE VIEW click_trial AS
SELECT participant.pseudonym AS participant,
       participant.simulated AS simulated,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.slot AS slot,
       trial.phase AS phase,
       trial.repetition AS repetition,
       trial.condition AS condition,
       (SELECT count(*) FROM click WHERE click.attempt_id = attempt.id) AS clicks,  -- all of them
       (SELECT (click.arrived_ns - CASE click.interval WHEN 1 THEN attempt.onset_ns ELSE
          (SELECT frame.flipped_ns FROM frame
           WHERE frame.attempt_id = attempt.id AND frame.interval = click.interval
             AND frame.phase = 'stimulus' AND frame.frame >=
               ifnull((SELECT step.shown_frame FROM step WHERE step.attempt_id = attempt.id
                         AND step.interval = click.interval AND step.step = 0), 0)
           ORDER BY frame.frame LIMIT 1) END) / 1e9
        FROM click WHERE click.attempt_id = attempt.id ORDER BY click.arrived_ns LIMIT 1)
         AS first_click_s,  -- of the stimulus that it came in; NULL: none
       (SELECT max(frame.shown_time_s) FILTER (WHERE frame.interval = 1)
          + ifnull(max(frame.shown_time_s) FILTER (WHERE frame.interval = 2), 0)
        FROM frame WHERE frame.attempt_id = attempt.id)
         AS exposure_s,  -- how much of the stimulus was shown, or of both; NULL: no frame recorded
       json_extract(protocol.protocol_json, '$.clicks.merge_within_ms') AS merge_within_ms,  -- NULL: none
       ifnull(json_extract(protocol.protocol_json, '$.clicks.first_ends'), 0)
         AS first_ends  -- 1: the first click ended the stimulus
FROM attempt
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE attempt.outcome = 'completed'
  AND json_type(protocol.protocol_json, '$.clicks') IS NOT NULL;

-- One row per click of a completed attempt, in its stimulus's own time: from the flip of the first
-- frame of the stimulus of its interval.
CREATE VIEW trial_click AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       click.number AS number,
       (click.arrived_ns - CASE click.interval WHEN 1 THEN attempt.onset_ns ELSE
          (SELECT frame.flipped_ns FROM frame
           WHERE frame.attempt_id = attempt.id AND frame.interval = click.interval
             AND frame.phase = 'stimulus' AND frame.frame >=
               ifnull((SELECT step.shown_frame FROM step WHERE step.attempt_id = attempt.id
                         AND step.interval = click.interval AND step.step = 0), 0)
           ORDER BY frame.frame LIMIT 1) END) / 1e9
         AS time_s,  -- of the stimulus of its interval
       click.arrival_uncertainty_ns / 1e6 AS uncertainty_ms,  -- may be this much earlier
       click.device AS device,
       click.interval AS interval
FROM click
JOIN attempt ON attempt.id = click.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per gaze sample of a completed attempt, in its stimulus's own time as a click is: as it
-- came, and corrected by the session's last calibration before it (the same where there was none).
CREATE VIEW gaze_sample AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       attempt.gaze_source AS gaze_source,
       (gaze.taken_ns - CASE gaze.interval WHEN 1 THEN attempt.onset_ns ELSE
          (SELECT frame.flipped_ns FROM frame
           WHERE frame.attempt_id = attempt.id AND frame.interval = gaze.interval
             AND frame.phase = 'stimulus' AND frame.frame >=
               ifnull((SELECT step.shown_frame FROM step WHERE step.attempt_id = attempt.id
                         AND step.interval = gaze.interval AND step.step = 0), 0)
           ORDER BY frame.frame LIMIT 1) END) / 1e9
         AS time_s,  -- of the stimulus of its interval
       gaze.x_m AS x_m,
       gaze.y_m AS y_m,
       gaze.loss AS loss,
       coalesce(correction_x0_m + correction_xx * gaze.x_m + correction_xy * gaze.y_m, gaze.x_m)
         AS corrected_x_m,  -- right of the screen's centre, as a step used it
       coalesce(correction_y0_m + correction_yx * gaze.x_m + correction_yy * gaze.y_m, gaze.y_m)
         AS corrected_y_m,  -- above it
       gaze.interval AS interval
FROM gaze
JOIN attempt ON attempt.id = gaze.attempt_id AND attempt.outcome = 'completed'
LEFT JOIN calibration ON calibration.id =
  (SELECT max(latest.id) FROM calibration AS latest
   WHERE latest.session_id = attempt.session_id AND latest.began_ns <= attempt.onset_ns
     AND latest.correction_xx IS NOT NULL)
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
       step.fixation_age_ns / 1e6 AS fixation_age_ms,  -- of the sample used, at the step
       step.region_x_m AS region_x_m,
       step.region_y_m AS region_y_m,
       step.region_radius_deg AS region_radius_deg,
       step.shown_frame AS shown_frame,
       (shown.flipped_ns - step.fixation_taken_ns) / 1e6 AS sample_to_flip_ms,  -- NULL: never shown
       step.interval AS interval
FROM step
JOIN attempt ON attempt.id = step.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN frame AS shown
  ON shown.attempt_id = step.attempt_id AND shown.frame = step.shown_frame
WHERE step.fixation_x_m IS NOT NULL OR step.region_x_m IS NOT NULL;

-- One row per step of a completed attempt in which something popped or was stopped short.
CREATE VIEW popped_step AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       trial.id AS trial,
       trial.phase AS phase,
       step.step AS step,
       step.shown_frame AS shown_frame,
       step.pops AS pops,
       step.largest_pop_deg AS largest_pop_deg,
       step.stopped_short AS stopped_short,
       step.interval AS interval
FROM step
JOIN attempt ON attempt.id = step.attempt_id AND attempt.outcome = 'completed'
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE step.pops > 0 OR step.stopped_short > 0;

-- One row per frame of a completed attempt that showed a photodiode patch, to match a recorded trace.
CREATE VIEW patch_frame AS
SELECT participant.pseudonym AS participant,
       protocol.name AS protocol,
       session.id AS session,
       session.photodiode_patch AS corner,
       trial.id AS trial,
       trial.slot AS slot,
       trial.phase AS trial_phase,
       frame.frame AS frame,
       frame.interval AS interval,
       frame.phase AS phase,
       frame.shown_time_s AS shown_time_s,
       frame.scheduled_ns / 1e9 AS scheduled_s,  -- when the flip was due, of the monotonic clock
       frame.flipped_ns / 1e9 AS flipped_s,  -- when it was on the screen, as far as known
       frame.missed_slots AS missed_slots,
       frame.patch AS code
FROM frame
JOIN attempt ON attempt.id = frame.attempt_id AND attempt.outcome = 'completed'
JOIN session ON session.id = attempt.session_id
JOIN trial ON trial.id = attempt.trial_id
JOIN enrolment ON enrolment.id = trial.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
WHERE frame.patch IS NOT NULL;

-- One row per trial and factor: the condition in long form. `level` keeps its type.
CREATE VIEW trial_level AS
SELECT trial.id AS trial,
       json_each.key AS factor,  -- its name in the design, with its unit
       json_each.value AS level  -- number or text
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
        WHERE trial.enrolment_id = enrolment.id AND trial.phase = 'main') AS planned_trials,  -- main phase
       (SELECT count(*) FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id AND trial.phase = 'main'
          AND attempt.outcome = 'completed') AS completed_trials,  -- main phase
       (SELECT count(*) FROM session WHERE session.enrolment_id = enrolment.id) AS sessions,  -- sittings
       (SELECT sum(attempt.timed_frames) FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id) AS timed_frames,  -- of all phases and attempts
       (SELECT sum(attempt.late_timed_frames)
        FROM trial JOIN attempt ON attempt.trial_id = trial.id
        WHERE trial.enrolment_id = enrolment.id) AS late_timed_frames,  -- of these, shown late
       (SELECT max(session.sync_overridden) FROM session
        WHERE session.enrolment_id = enrolment.id) AS sync_overridden  -- 1: in a sitting
FROM enrolment
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id;

-- One row per session: what recorded it, on what, before which screen, who took part, and how sure
-- the display's timing was.
CREATE VIEW session_provenance AS
SELECT participant.pseudonym AS participant,
       participant.simulated AS simulated,
       protocol.name AS protocol,
       protocol.hash AS protocol_hash,
       session.id AS session,
       session.started_utc AS started_utc,
       session.ended_utc AS ended_utc,
       session.ending AS ending,
       session.build AS build,
       session.recording_format AS recording_format,
       session.machine AS machine,
       session.display AS display,
       session.screen_width_m AS screen_width_m,
       session.screen_height_m AS screen_height_m,
       session.screen_width_px AS screen_width_px,
       session.screen_height_px AS screen_height_px,
       session.viewing_distance_m AS viewing_distance_m,
       session.screen_measured AS screen_measured,
       session.screen_black_cd_m2 AS screen_black_cd_m2,
       session.screen_white_cd_m2 AS screen_white_cd_m2,
       session.screen_gamma AS screen_gamma,
       CASE WHEN session.page_name IS NULL THEN NULL
            WHEN instr(session.machine, 'Firefox/') > 0 THEN
              'Firefox ' || CAST(substr(session.machine, instr(session.machine, 'Firefox/') + 8) AS INTEGER)
            WHEN instr(session.machine, 'Edg/') > 0 THEN
              'Edge ' || CAST(substr(session.machine, instr(session.machine, 'Edg/') + 4) AS INTEGER)
            WHEN instr(session.machine, 'Chrome/') > 0 THEN
              'Chrome ' || CAST(substr(session.machine, instr(session.machine, 'Chrome/') + 7) AS INTEGER)
            WHEN instr(session.machine, ' Version/') > 0 THEN
              'Safari ' || CAST(substr(session.machine, instr(session.machine, ' Version/') + 9) AS INTEGER)
            ELSE 'a browser' END AS browser,  -- that the web page ran in; NULL: none, a window
       session.page_name AS page_name,
       session.page_parts AS page_parts,
       session.refresh_hz AS refresh_hz,
       session.rounding_allowed AS rounding_allowed,
       session.sync_tries AS sync_tries,
       session.sync_valid_flips AS sync_valid_flips,
       session.sync_mean_interval_ns / 1e6 AS sync_mean_interval_ms,  -- NULL: not measured
       session.sync_sd_interval_ns / 1e6 AS sync_sd_interval_ms,  -- NULL: not measured
       session.sync_passed AS sync_passed,
       session.sync_overridden AS sync_overridden,
       session.gaze_source AS gaze_source,
       session.photodiode_patch AS photodiode_patch,
       session.observer AS observer,
       session.series AS series,
       session.series_place AS series_place,
       session.resumed_at AS resumed_at,
       session.resumed_after_s AS resumed_after_s,
       session.first_slot AS first_slot,
       merged_file.name AS merged_from,
       merged_file.hash AS merged_hash,
       merged_file.merged_utc AS merged_utc
FROM session
JOIN enrolment ON enrolment.id = session.enrolment_id
JOIN participant ON participant.id = enrolment.participant_id
JOIN protocol ON protocol.id = enrolment.protocol_id
LEFT JOIN merged_file ON merged_file.id = participant.merged_file_id;

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
