-- Why a study is not published, though its file is whole; what is left out of the analysis (`impetus
-- exclude`) does not count. Each query yields one sentence, or no row where nothing stands against it.

SELECT 'nothing is recorded in it yet' WHERE NOT EXISTS (SELECT 1 FROM attempt);

SELECT count(*) || ' of ' || (SELECT count(*) FROM enrolment) || ' enrolments ' ||
    iif(count(*) = 1, 'is', 'are') || ' not finished' FROM enrolment
  JOIN participant ON participant.id = participant_id
  WHERE finished_utc IS NULL
    AND NOT EXISTS (SELECT 1 FROM excluded WHERE participant = pseudonym AND trial IS NULL)
    AND NOT EXISTS (SELECT 1 FROM session WHERE ending = 'declined' AND id =
      (SELECT max(last.id) FROM session AS last WHERE last.enrolment_id = enrolment.id)
      AND NOT EXISTS (SELECT 1 FROM attempt WHERE session_id = session.id))
  HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' trial was', ' trials were') ||
    ' shown by a display that had failed its sync test (marked sync_overridden)'
  FROM attempt JOIN trial ON trial.id = trial_id
  JOIN enrolment ON enrolment.id = enrolment_id
  JOIN participant ON participant.id = participant_id
  WHERE sync_overridden AND outcome = 'completed'
    AND NOT EXISTS (SELECT 1 FROM excluded WHERE excluded.participant = pseudonym
      AND coalesce(excluded.trial, trial_id) = trial_id)
  HAVING count(*) > 0;
