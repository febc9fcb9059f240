-- From schema 8 to 9: sessions that ran in a web page. Views are made anew afterwards.

ALTER TABLE session ADD COLUMN page_name TEXT;
ALTER TABLE session ADD COLUMN page_key TEXT;
ALTER TABLE session ADD COLUMN page_parts INTEGER CHECK (page_parts >= 0);
