-- Format 1 kept the number of the process that started an attempt; format 2 keeps the launcher's own handle.
DROP VIEW timeline;
ALTER TABLE attempts ADD COLUMN handle TEXT;
UPDATE attempts SET handle = json_object('host', host, 'pid', pid) WHERE pid IS NOT NULL;
ALTER TABLE attempts DROP COLUMN pid;
CREATE VIEW timeline (
  at,
  event,
  label,
  attempt,
  detail,
  case_id
) AS
WITH events (at, rank, event, attempt, detail, case_id) AS (
  SELECT intended, 1, 'attempt intended', attempt, ranks || ' ranks on ' || host, case_id FROM attempts
  UNION ALL
  SELECT started, 2, 'attempt started', attempt, handle, case_id FROM attempts WHERE started IS NOT NULL
  UNION ALL
  SELECT ended, 3, 'attempt ended', attempt, outcome || iif(coalesce(reason, '') = '', '', ': ' || reason), case_id
  FROM attempts WHERE ended IS NOT NULL
  UNION ALL
  SELECT first_seen, 4, 'checkpoint seen', NULL, path || iif(valid, '', ': not valid, ' || reason), case_id
  FROM checkpoints
  UNION ALL
  SELECT max(recorded), 5, 'result recorded', NULL, 't = ' || max(window_start) || ' to ' || max(window_end), case_id
  FROM quantities GROUP BY case_id)
SELECT e.at, e.event, c.label, e.attempt, e.detail, e.case_id
FROM events e JOIN cases c USING (case_id)
ORDER BY substr(e.at, 1, 23), e.case_id, e.rank, e.attempt;
