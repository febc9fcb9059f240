-- From schema 5 to 6: what the phases of a step were granted, of those that were refused some. Views
-- are made anew afterwards.

ALTER TABLE step ADD COLUMN cut_work TEXT;
