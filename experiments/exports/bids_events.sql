-- What happened in the session ?1, in the order of time: its onset in nanoseconds, then what the
-- events of bids_words.json say, in their order, then the trial's condition.
WITH shown AS (
  SELECT attempt.id, attempt.number, attempt.outcome, attempt.onset_ns, trial.slot, trial.phase,
    trial.repetition, trial.block, trial.catch, trial.condition,
    (SELECT detail ->> '$.test_interval' FROM response WHERE attempt_id = attempt.id
       AND kind = 'two_interval') AS test_interval
  FROM attempt JOIN trial ON trial.id = attempt.trial_id
  WHERE attempt.session_id = ?1 AND attempt.onset_ns > 0)
-- stimuli, and of two intervals the first
SELECT shown.onset_ns AS at_ns, (SELECT max(shown_time_s) FROM frame WHERE frame.attempt_id =
    shown.id AND frame.interval = 1) AS duration_s, 'stimulus' AS type, shown.slot, shown.phase,
    shown.number, shown.outcome, 1, shown.repetition, shown.block, shown.catch, NULL, NULL, NULL,
    NULL, NULL, NULL, NULL, shown.test_interval, shown.condition FROM shown
UNION ALL
-- the second of two intervals
SELECT min(frame.flipped_ns), max(frame.shown_time_s), 'stimulus', shown.slot, shown.phase,
    shown.number, shown.outcome, 2, shown.repetition, shown.block, shown.catch, NULL, NULL, NULL,
    NULL, NULL, NULL, NULL, shown.test_interval, shown.condition FROM shown
  JOIN frame ON frame.attempt_id = shown.id AND frame.interval = 2 AND frame.phase = 'stimulus'
  GROUP BY shown.id
UNION ALL
-- ratings
SELECT rating.question_shown_ns, (rating.arrived_ns - rating.question_shown_ns) / 1e9, 'rating',
    shown.slot, shown.phase, shown.number, shown.outcome, NULL, shown.repetition, shown.block,
    shown.catch, rating.rating, (rating.arrived_ns - rating.question_shown_ns) / 1e9, NULL, NULL,
    NULL, NULL, NULL, shown.test_interval, shown.condition FROM rating
  JOIN shown ON shown.id = rating.attempt_id
UNION ALL
-- other answers
SELECT response.question_shown_ns, (response.arrived_ns - response.question_shown_ns) / 1e9,
    response.kind, shown.slot, shown.phase, shown.number, shown.outcome, NULL, shown.repetition,
    shown.block, shown.catch, response.answer, CASE WHEN NOT response.timed_out THEN
    (response.arrived_ns - response.question_shown_ns) / 1e9 END, NULL, NULL, NULL, NULL, NULL,
    shown.test_interval, shown.condition FROM response
  JOIN shown ON shown.id = response.attempt_id
UNION ALL
-- clicks
SELECT click.arrived_ns, 0.0, 'click', shown.slot, shown.phase, shown.number, shown.outcome,
    click.interval, shown.repetition, shown.block, shown.catch, NULL, (click.arrived_ns - CASE
    click.interval WHEN 1 THEN shown.onset_ns ELSE (SELECT min(flipped_ns) FROM frame WHERE
    frame.attempt_id = shown.id AND frame.interval = 2 AND frame.phase = 'stimulus') END) / 1e9,
    NULL, NULL, NULL, NULL, NULL, shown.test_interval, shown.condition FROM click
  JOIN shown ON shown.id = click.attempt_id
UNION ALL
-- collisions
SELECT CASE collision.interval WHEN 1 THEN shown.onset_ns ELSE (SELECT min(flipped_ns) FROM frame
    WHERE frame.attempt_id = shown.id AND frame.interval = 2 AND frame.phase = 'stimulus') END +
    CAST(collision.time_s * 1e9 AS INTEGER), 0.0, 'collision', shown.slot, shown.phase,
    shown.number, shown.outcome, collision.interval, shown.repetition, shown.block, shown.catch,
    NULL, NULL, collision.body_a, collision.body_b, collision.level, collision.eccentricity_deg,
    collision_truth.gap_arcmin, shown.test_interval, shown.condition FROM collision
  JOIN shown ON shown.id = collision.attempt_id
  LEFT JOIN collision_truth ON collision_truth.collision_id = collision.id
  WHERE collision.time_s IS NOT NULL
UNION ALL
-- calibrations of the gaze
SELECT began_ns, 0.0, kind, NULL, NULL, number, NULL, NULL, NULL, NULL, NULL, accuracy_deg, NULL,
    NULL, NULL, NULL, NULL, NULL, NULL, NULL FROM calibration WHERE session_id = ?1
ORDER BY at_ns, type
