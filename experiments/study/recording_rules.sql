-- What must hold of what each attempt recorded. Each query yields one sentence for every violation, in
-- which `place` is how sentences name a row (places.sql).

SELECT place || ': completed without a single step' FROM shown
  WHERE outcome <> 'interrupted' AND NOT EXISTS (SELECT 1 FROM step WHERE attempt_id = shown.id);

SELECT place || iif(interval = 1, '', ', interval ' || interval) || ': of the steps 0 to ' ||
    max(step) || ' there are ' || count(*) FROM step
  JOIN shown ON shown.id = attempt_id GROUP BY attempt_id, interval
  HAVING max(step) + 1 <> count(*);

SELECT place || ': ' || timed_frames || ' frames were counted, ' || kept || ' are there'
  FROM (SELECT place, timed_frames, (SELECT count(*) FROM frame WHERE attempt_id = shown.id) AS kept
    FROM shown) WHERE timed_frames <> kept;

SELECT place || ': of the frames 0 to ' || max(frame) || ' there are ' || count(*)
  FROM frame JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING min(frame) <> 0 OR max(frame) + 1 <> count(*);

SELECT place || ': ' || late_timed_frames || ' frames were counted as late, ' || late || ' are'
  FROM (SELECT place, late_timed_frames, (SELECT count(*) FROM frame WHERE attempt_id = shown.id AND
    missed_slots > 0) AS late FROM shown) WHERE late_timed_frames <> late;

SELECT place || ': a collision of ' || body_a || ' and ' || body_b || ' at step ' || collision.step
    || ', which is missing' FROM collision
  JOIN shown ON shown.id = collision.attempt_id
  LEFT JOIN step ON step.attempt_id = collision.attempt_id AND step.interval = collision.interval
    AND step.step = collision.step WHERE step.step IS NULL;

SELECT place || ': of the gaze samples 1 to ' || max(sample) || ' there are ' || count(*)
  FROM gaze JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING min(sample) <> 1 OR max(sample) <> count(*);

SELECT place || ': of the clicks 1 to ' || max(click.number) || ' there are ' || count(*)
  FROM click JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING max(click.number) <> count(*);

SELECT place || ': of the markers 1 to ' || max(marker.number) || ' there are ' || count(*)
  FROM marker JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING max(marker.number) <> count(*);

SELECT place || ': of the sounds 1 to ' || max(sound.number) || ' there are ' || count(*)
  FROM sound JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING max(sound.number) <> count(*);

SELECT place || ': of the answers 1 to ' || max(response.number) || ' there are ' || count(*)
  FROM response JOIN shown ON shown.id = attempt_id GROUP BY attempt_id
  HAVING max(response.number) <> count(*);

SELECT place || ': its onset is not the flip of its first frame of the stimulus' FROM shown
  JOIN (SELECT attempt_id, min(flipped_ns) AS first_ns FROM frame WHERE phase = 'stimulus'
    GROUP BY attempt_id) ON attempt_id = shown.id
  WHERE onset_ns <> first_ns AND (onset_ns <> 0 OR outcome <> 'interrupted');

SELECT place || ': ' || what || ' of interval ' || max(interval) || ', which it has not' FROM (
    SELECT attempt_id, interval, 'a frame' AS what FROM frame
    UNION ALL SELECT attempt_id, interval, 'a sample of the gaze' FROM gaze
    UNION ALL SELECT attempt_id, interval, 'a click' FROM click
    UNION ALL SELECT attempt_id, interval, 'a marker' FROM marker
    UNION ALL SELECT attempt_id, interval, 'a sound' FROM sound) AS kept
  JOIN shown ON shown.id = attempt_id WHERE outcome <> 'interrupted'
    AND interval > (SELECT max(interval) FROM step WHERE attempt_id = shown.id)
  GROUP BY attempt_id, what;

SELECT place || ': frame ' || frame || ' is of the cross, and one before it of the stimulus' FROM (
    SELECT attempt_id, frame, phase AS part, max(phase = 'stimulus') OVER so_far AS was_shown
    FROM frame WINDOW so_far AS (PARTITION BY attempt_id, interval ORDER BY frame))
  JOIN shown ON shown.id = attempt_id WHERE part = 'fixation' AND was_shown
  GROUP BY attempt_id HAVING frame = min(frame);

SELECT place || ': frame ' || frame || ' shows a time before that of the frame before it' FROM (
    SELECT attempt_id, frame, shown_time_s,
      lag(shown_time_s) OVER (PARTITION BY attempt_id, interval ORDER BY frame) AS before_s
    FROM frame WHERE phase = 'stimulus') JOIN shown ON shown.id = attempt_id
  WHERE shown_time_s < before_s GROUP BY attempt_id HAVING frame = min(frame);

SELECT place || ': click ' || min(click.number) || ' comes before its cross' FROM click
  JOIN shown ON shown.id = click.attempt_id
  WHERE arrived_ns < (SELECT min(flipped_ns) FROM frame
    WHERE attempt_id = shown.id AND frame.phase = 'fixation') GROUP BY shown.id;

SELECT place || ': is completed, and was interrupted by ' || interrupted_by FROM shown
  WHERE outcome = 'completed' AND interrupted_by IS NOT NULL;

-- Of two intervals only the test's is told.
SELECT place || ': held for ' || realised_hold_ms || ' ms, a collision for ' || max(imposed_hold_ms)
  FROM shown JOIN collision ON attempt_id = shown.id WHERE imposed_hold_ms > 0
  GROUP BY shown.id HAVING max(interval) = 1
    AND abs(realised_hold_ms - max(imposed_hold_ms)) > 0.001;

SELECT place || ': frame ' || frame || ' was shown before the frame before it' FROM (
  SELECT attempt_id, frame, flipped_ns, lag(flipped_ns) OVER (PARTITION BY attempt_id ORDER BY frame)
    AS before_ns FROM frame) JOIN shown ON shown.id = attempt_id
  WHERE flipped_ns <= before_ns GROUP BY attempt_id HAVING frame = min(frame);

SELECT place || ': its steps looked at ' || count(*) || iif(count(*) = 1, ' sample', ' samples') ||
    ' of the gaze from within the stimulus that ' || iif(count(*) = 1, 'is', 'are') || ' missing' FROM (
    SELECT step.attempt_id, fixation_taken_ns FROM step
    JOIN (SELECT attempt_id, interval, min(flipped_ns) AS first_ns FROM frame
      WHERE phase = 'stimulus' GROUP BY attempt_id, interval) AS stimulus
      ON stimulus.attempt_id = step.attempt_id AND stimulus.interval = step.interval
    WHERE fixation_taken_ns >= first_ns
    EXCEPT SELECT attempt_id, taken_ns FROM gaze) AS looked
  JOIN shown ON shown.id = attempt_id JOIN trial ON trial.id = trial_id
  WHERE yoked_trial_id IS NULL GROUP BY attempt_id;

SELECT place || ': answered before it was asked' FROM (
    SELECT attempt_id, arrived_ns, question_shown_ns FROM response
    UNION ALL SELECT attempt_id, arrived_ns, question_shown_ns FROM rating)
  JOIN shown ON shown.id = attempt_id WHERE arrived_ns < question_shown_ns GROUP BY attempt_id;

SELECT place || ': asked before it was shown' FROM (
    SELECT attempt_id, question_shown_ns FROM response
    UNION ALL SELECT attempt_id, question_shown_ns FROM rating)
  JOIN shown ON shown.id = attempt_id
  WHERE question_shown_ns < onset_ns GROUP BY attempt_id;
