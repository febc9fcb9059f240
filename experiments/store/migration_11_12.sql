-- From schema 11 to 12: sounds at contacts. Views are made anew afterwards.

CREATE TABLE sound (
  attempt_id INTEGER NOT NULL REFERENCES attempt (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  step INTEGER,
  lag_ms REAL NOT NULL,
  loudness REAL NOT NULL CHECK (loudness > 0 AND loudness <= 1),
  shown_ns INTEGER,
  intended_ns INTEGER NOT NULL,
  realised_ns INTEGER,
  interval INTEGER NOT NULL DEFAULT 1 CHECK (interval IN (1, 2)),
  PRIMARY KEY (attempt_id, number)
) STRICT, WITHOUT ROWID;
