-- What a reader of a published study should know of it, and forbids nothing. Each query yields one
-- sentence, or no row where there is nothing to say.

SELECT count(*) || ' of ' || (SELECT count(*) FROM participant) || ' participants ' ||
    iif(count(*) = 1, 'is', 'are') || ' simulated' FROM participant WHERE simulated
  HAVING count(*) > 0;

SELECT count(*) || ' of ' || (SELECT count(*) FROM enrolment) || ' enrolments ' ||
    iif(count(*) = 1, 'was', 'were') || ' declined: no consent, and no trial' FROM enrolment
  WHERE EXISTS (SELECT 1 FROM session WHERE ending = 'declined' AND id =
      (SELECT max(last.id) FROM session AS last WHERE last.enrolment_id = enrolment.id))
    AND NOT EXISTS (SELECT 1 FROM attempt JOIN session ON session.id = session_id
      WHERE enrolment_id = enrolment.id)
  HAVING count(*) > 0;

SELECT count(*) || ' of ' || (SELECT count(*) FROM session) || ' sessions ' ||
    iif(count(*) = 1, 'has', 'have') || ' no ending: killed, or running now' FROM session
  WHERE ending IS NULL HAVING count(*) > 0;

SELECT 'it was anonymised, by ' || anonymised_by FROM study
  WHERE anonymised_by IS NOT NULL;

SELECT count(DISTINCT enrolment_id) ||
    ' people''s enrolments have trials, but no consent that was kept'
  FROM session
  WHERE simulated = 0 AND (SELECT anonymised_by FROM study) IS NULL AND EXISTS (SELECT 1 FROM
    attempt WHERE session_id = session.id) AND NOT EXISTS (SELECT 1 FROM answer JOIN session AS
    other ON other.id = answer.session_id WHERE other.enrolment_id = session.enrolment_id AND kind =
    'consent' AND answer = 'agreed') HAVING count(*) > 0;

SELECT sum(late_timed_frames) || ' of ' || sum(timed_frames) || ' timed frames were late (' ||
    printf('%.2g', 100.0 * sum(late_timed_frames) / sum(timed_frames)) || ' %)'
  FROM attempt HAVING sum(late_timed_frames) > 0;

SELECT count(*) || iif(count(*) = 1, ' trial showed', ' trials showed') ||
    ' gaze-dependent detail too late (marked gaze_late)'
  FROM attempt WHERE gaze_late AND outcome = 'completed' HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' trial held its', ' trials held their') ||
    ' contact otherwise than intended, rounded to the display''s frames'
  FROM attempt
  WHERE outcome = 'completed' AND abs(realised_hold_ms - intended_hold_ms) > 1e-6
  HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' session', ' sessions') ||
    ' of people before a screen whose size was assumed, not entered'
  FROM session WHERE simulated = 0 AND screen_measured = 0 HAVING count(*) > 0;

SELECT count(*) || ' of ' || (SELECT count(*) FROM session) ||
    iif(count(*) = 1, ' session ran', ' sessions ran') || ' in a web page (' ||
    group_concat(DISTINCT browser) ||
    '), which knows when a frame begins, not when its light leaves the screen'
  FROM session_provenance WHERE browser IS NOT NULL HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' attempt was', ' attempts were') ||
    ' interrupted and shown again' FROM attempt
  WHERE outcome = 'interrupted' HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1,
    ' completed attempt was set aside: a resumed session began its block anew',
    ' completed attempts were set aside: resumed sessions began their blocks anew')
  FROM attempt WHERE outcome = 'set aside' HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' note says', ' notes say') ||
    ' that the state of a body was no longer finite'
  FROM note WHERE kind = 'not finite' HAVING count(*) > 0;

SELECT 'left out of the analysis: ' || people ||
    iif(people = 1, ' participant, ', ' participants, ') || trials ||
    iif(trials = 1, ' single trial', ' single trials') || ', with reasons'
  FROM (SELECT count(*) FILTER (WHERE trial IS NULL) AS people,
    count(*) FILTER (WHERE trial IS NOT NULL) AS trials FROM excluded) WHERE people + trials > 0;

SELECT 'it holds ' || count(*) || ' versions of ' || name FROM protocol
  GROUP BY name HAVING count(*) > 1;

SELECT 'it was merged from ' || count(*) || iif(count(*) = 1, ' file', ' files') || ' of stations'
  FROM merged_file HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' session was', ' sessions were') ||
    ' recorded by a build with changes that no commit holds (-dirty)'
  FROM session WHERE build LIKE '%-dirty%' HAVING count(*) > 0;

SELECT count(*) || iif(count(*) = 1, ' session was', ' sessions were') ||
    ' recorded by a build whose commit is not known'
  FROM session WHERE build LIKE '%unknown commit%' HAVING count(*) > 0;

SELECT 'participants'' own words are in it: ' || count(*) ||
    iif(count(*) = 1, ' answer', ' answers') ||
    ' about themselves or in free text; impetus export --anonymise leaves them out'
  FROM (SELECT answer FROM answer WHERE kind IN ('demographic', 'question') AND answer IS NOT NULL
    UNION ALL SELECT answer FROM response WHERE kind = 'free_text' AND answer IS NOT NULL)
  HAVING count(*) > 0;
