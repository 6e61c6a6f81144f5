-- Format 4 tells what the sweep varies; it is filled in when the campaign is run again. Times of day have one precision,
-- the millisecond: those of results had more, and did not sort with the others.
ALTER TABLE cases ADD COLUMN varied TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(varied));
UPDATE quantities SET recorded = substr(recorded, 1, 23) || 'Z' WHERE length(recorded) > 24;
