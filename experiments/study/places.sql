-- What comes before each rule: rows with `place`, as sentences name them, such as "P01, causality,
-- slot 5, attempt 1".
WITH enrolled AS (
  SELECT enrolment.*, pseudonym || ', ' || name AS place FROM enrolment
  JOIN participant ON participant.id = participant_id
  JOIN protocol ON protocol.id = protocol_id),
planned AS (
  SELECT trial.*, place || ', slot ' || slot AS place FROM trial
  JOIN enrolled ON enrolled.id = enrolment_id),
shown AS (
  SELECT attempt.*, slot, phase, enrolment_id, track, adaptive_state,
    place || ', attempt ' || number AS place FROM attempt
  JOIN planned ON planned.id = trial_id),
sitting AS (
  SELECT session.*, place || ', session ' || session.id AS place FROM session
  JOIN enrolled ON enrolled.id = enrolment_id)
