-- The ledger of a power analysis: one question, and which simulated studies were done to answer it.
-- A study is written with all its tests in one transaction; whoever finds it here need not do it.

CREATE TABLE question (
  id             INTEGER PRIMARY KEY CHECK (id = 1),
  created_utc    TEXT NOT NULL,
  protocol       TEXT NOT NULL,     -- its name
  protocol_hash  TEXT NOT NULL,     -- of the protocol and its scene
  observer       TEXT NOT NULL,     -- JSON
  null_observer  TEXT NOT NULL,     -- JSON; '': none is known
  screen         TEXT NOT NULL,     -- that the sessions assume
  response       TEXT NOT NULL CHECK (response IN ('rating', 'answer', 'clicks')),
  model          TEXT NOT NULL CHECK (model IN ('means', 'mixed')),
  factors        TEXT NOT NULL,     -- JSON array of those tested; []: every one that varies
  compared       TEXT NOT NULL,     -- JSON array of the two levels that alone are; []: all
  seed           INTEGER NOT NULL
) STRICT;

-- A simulated study of so many participants: the first ones of its number.
CREATE TABLE study (
  effect        INTEGER NOT NULL CHECK (effect IN (0, 1)),  -- 0: set to zero
  number        INTEGER NOT NULL CHECK (number >= 1),
  participants  INTEGER NOT NULL CHECK (participants >= 2),
  seed          INTEGER NOT NULL,   -- impetus run --participants N --seed SEED makes it again
  build         TEXT NOT NULL,      -- that simulated it
  simulated_s   REAL NOT NULL,      -- what it took, of all its participants
  PRIMARY KEY (effect, number, participants)
) STRICT;

CREATE TABLE test (
  effect        INTEGER NOT NULL,
  number        INTEGER NOT NULL,
  participants  INTEGER NOT NULL,
  factor        TEXT NOT NULL,
  p             REAL,               -- NULL: no test could be made, and the remark says why
  method        TEXT NOT NULL,
  remark        TEXT NOT NULL,
  PRIMARY KEY (effect, number, participants, factor),
  FOREIGN KEY (effect, number, participants) REFERENCES study
) STRICT;

-- Who is at it now, so that several processes do not do the same; void once the process has ended.
CREATE TABLE taken (
  effect   INTEGER NOT NULL,
  number   INTEGER NOT NULL,
  process  TEXT NOT NULL,
  PRIMARY KEY (effect, number)
) STRICT;
