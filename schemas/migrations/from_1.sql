-- Format 1 kept the number of the process that started an attempt; format 2 keeps the launcher's own handle.
DROP VIEW timeline;
ALTER TABLE attempts ADD COLUMN handle TEXT;
UPDATE attempts SET handle = json_object('host', host, 'pid', pid) WHERE pid IS NOT NULL;
ALTER TABLE attempts DROP COLUMN pid;
