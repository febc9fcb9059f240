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
