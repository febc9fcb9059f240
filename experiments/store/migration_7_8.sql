-- From schema 7 to 8: how bright the screen was, where the lab has measured it. Views are made anew
-- afterwards.

ALTER TABLE session ADD COLUMN screen_black_cd_m2 REAL CHECK (screen_black_cd_m2 >= 0);
ALTER TABLE session ADD COLUMN screen_white_cd_m2 REAL CHECK (screen_white_cd_m2 > screen_black_cd_m2);
ALTER TABLE session ADD COLUMN screen_gamma REAL CHECK (screen_gamma > 0);
