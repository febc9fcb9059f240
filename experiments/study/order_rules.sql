-- What must hold of plans and of the order in which their trials were shown. Each query yields one
-- sentence for every violation, in which `place` is how sentences name a row (places.sql).

SELECT 'the study has lost the row that says when and by which build it was made'
  WHERE NOT EXISTS (SELECT 1 FROM study);

SELECT place || ': of the planned slots 1 to ' || max(slot) || ' there are ' || count(trial.id)
  FROM enrolled LEFT JOIN trial ON enrolment_id = enrolled.id
  GROUP BY enrolled.id
  HAVING count(trial.id) = 0 OR min(slot) <> 1 OR max(slot) <> count(trial.id);

SELECT planned.place || ': of the attempts 1 to ' || max(number) || ' there are ' || count(*)
  FROM planned JOIN attempt ON trial_id = planned.id GROUP BY planned.id
  HAVING min(number) <> 1 OR max(number) <> count(*);

SELECT place || ': completed after slot ' || before || ', which the plan has later'
  FROM (SELECT place, slot, lag(slot) OVER (PARTITION BY enrolment_id ORDER BY id) AS before FROM
    shown WHERE outcome = 'completed') WHERE slot <= before;

SELECT place || ': passed over, though slot ' || later || ' was completed'
  FROM (SELECT planned.id, place, slot, max(slot) FILTER (WHERE done) OVER (PARTITION BY
    enrolment_id, phase) AS later, done FROM (SELECT planned.*, EXISTS (SELECT 1 FROM attempt WHERE
    trial_id = planned.id AND outcome = 'completed') AS done FROM planned) AS planned)
  WHERE NOT done AND slot < later;

SELECT enrolled.place || ': finished, but ' || count(*) || ' of its main trials ' ||
    iif(count(*) = 1, 'was', 'were') || ' not completed' FROM enrolled
  JOIN trial ON enrolment_id = enrolled.id
  WHERE finished_utc IS NOT NULL AND phase = 'main' AND NOT EXISTS (SELECT 1 FROM attempt WHERE
    trial_id = trial.id AND outcome = 'completed') GROUP BY enrolled.id;

SELECT sitting.place || ': ended as finished, but the protocol is not'
  FROM sitting JOIN enrolment ON enrolment.id = enrolment_id
  WHERE ending = 'finished' AND finished_utc IS NULL;

SELECT sitting.place || ': ended as declined, but has trials' FROM sitting
  WHERE ending = 'declined' AND EXISTS (SELECT 1 FROM attempt WHERE session_id = sitting.id);

SELECT shown.place || ': belongs to a session of another participant or protocol'
  FROM shown JOIN session ON session.id IN (session_id, set_aside_in)
  WHERE session.enrolment_id <> shown.enrolment_id;

SELECT place || ': completed, but what its adaptive level was chosen by is missing'
  FROM shown
  WHERE outcome = 'completed' AND track IS NOT NULL AND adaptive_state IS NULL;

SELECT place || ': follows the gaze of a trial that was not completed'
  FROM planned
  WHERE yoked_trial_id IS NOT NULL AND NOT EXISTS (SELECT 1 FROM attempt WHERE attempt.trial_id =
    yoked_trial_id AND outcome = 'completed');
