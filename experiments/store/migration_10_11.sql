-- From schema 10 to 11: markers that were sent to another recorder. Views are made anew afterwards.

CREATE TABLE marker (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  event TEXT NOT NULL CHECK (event IN ('fixation', 'onset', 'contact', 'end', 'click', 'answer')),
  code INTEGER NOT NULL CHECK (code BETWEEN 1 AND 255),
  event_ns INTEGER NOT NULL,
  written_ns INTEGER,
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;
