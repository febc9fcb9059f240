-- What every session must say of where it comes from. Each query yields one sentence for every
-- violation, in which `place` is how sentences name a row (places.sql).

SELECT place || ': which build recorded it is missing' FROM sitting
  WHERE trim(build) = '';

SELECT place || ': on which machine is missing' FROM sitting
  WHERE trim(machine) = '';

SELECT place || ': on which display is missing' FROM sitting
  WHERE trim(display) = '';

SELECT place || ': recording format ' || recording_format ||
    ', which this build does not know; use the one that recorded it, ' || build
  FROM sitting WHERE recording_format NOT BETWEEN {oldest format} AND {format};

SELECT place || ': trials were recorded though the sync test had failed and was not overridden'
  FROM sitting
  WHERE sync_passed = 0 AND sync_overridden = 0 AND EXISTS (SELECT 1 FROM attempt WHERE session_id =
    sitting.id);

SELECT place || ': the sync test''s measurement is missing' FROM sitting
  WHERE sync_valid_flips > 0 AND sync_mean_interval_ns IS NULL;

SELECT shown.place || ': marked otherwise than its session for an overridden sync test'
  FROM shown JOIN session ON session.id = session_id
  WHERE shown.sync_overridden <> session.sync_overridden;

SELECT place || ': of a simulated participant, but ' || pseudonym || ' is a person'
  FROM sitting JOIN enrolment ON enrolment.id = enrolment_id
  JOIN participant ON participant.id = participant_id
  WHERE sitting.simulated = 1 AND participant.simulated = 0;

SELECT place || ': of a person, but ' || pseudonym || ' is simulated'
  FROM sitting JOIN enrolment ON enrolment.id = enrolment_id
  JOIN participant ON participant.id = participant_id
  WHERE sitting.simulated = 0 AND participant.simulated = 1;

SELECT place || ': of a person, but it names a simulated observer' FROM sitting
  WHERE simulated = 0 AND observer IS NOT NULL;

SELECT place || ': has an ending without its time, or the time without it'
  FROM sitting WHERE (ending IS NULL) <> (ended_utc IS NULL);

SELECT shown.place || ': its gaze came from another source than its session''s'
  FROM shown JOIN session ON session.id = session_id
  WHERE session.gaze_source IS NOT NULL AND shown.gaze_source <> session.gaze_source;

SELECT shown.place || ': answered by ' || device || ', in a session of ' ||
    iif(session.simulated, 'a simulated participant', 'a person') FROM (
    SELECT attempt_id, device FROM response UNION ALL SELECT attempt_id, device FROM rating
    UNION ALL SELECT attempt_id, device FROM click) AS given
  JOIN shown ON shown.id = attempt_id JOIN session ON session.id = session_id
  WHERE device <> 'none' AND (device = 'simulated') <> session.simulated GROUP BY shown.id;
