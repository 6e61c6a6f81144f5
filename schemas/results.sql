-- The results store of a campaign, format 5: <campaign directory>/results.db.
--
-- Written by `softwall` only; read it with `softwall query DIR "SQL"` or with sqlite3. Start with the view
-- `results`. application_id and user_version are set by campaign/store/store_schema.cpp in the transaction that runs
-- this file; schemas/migrations/from_<format>.sql takes the tables of a store of an earlier format to the next, and
-- its views are made anew.
--
-- The comment behind a column, "[unit] meaning", is its documentation: it is copied into the table `documentation`,
-- and a test fails when a column has none. Unit "-": none. Times of day are ISO 8601 UTC text. Lengths in h,
-- velocities in U_b, density 1. NULL: not known, or not defined for this case.

-- The campaign: one row.
CREATE TABLE campaign (
  id        INTEGER PRIMARY KEY CHECK (id = 1), -- [-] always 1
  name      TEXT NOT NULL,                      -- [-] name of the campaign
  spec      TEXT NOT NULL,                      -- [-] the campaign file, word for word, as last run
  created   TEXT NOT NULL,                      -- [UTC] first recorded
  updated   TEXT NOT NULL                       -- [UTC] last recorded
) STRICT;

-- One row a case, a point of the sweep. Its identity is the hash of its physical parameters.
CREATE TABLE cases (
  case_id          TEXT PRIMARY KEY NOT NULL,   -- [-] hash of the physical parameters, 16 hexadecimal digits
  label            TEXT NOT NULL,               -- [-] for people; never identity
  directory        TEXT NOT NULL,               -- [-] run directory, relative to the campaign directory
  is_precursor     INTEGER NOT NULL CHECK (is_precursor IN (0, 1)), -- [-] 1: a rigid channel whose last checkpoint starts the others
  precursor_id     TEXT,                        -- [-] case_id of the case that this one starts from
  flow             TEXT NOT NULL,               -- [-] rigid_channel, elastic_wall, cavity, rotation, interface_wave
  G                REAL,                        -- [rho U_b^2] modulus of transverse elasticity; NULL without a solid
  viscosity_ratio  REAL,                        -- [-] solid over fluid viscosity; NULL without a solid
  reynolds         REAL NOT NULL,               -- [-] bulk Reynolds number U_b h / nu
  grid             TEXT NOT NULL,               -- [-] cells as nx x (ny_fluid + ny_solid) x nz, e.g. 72x60+24x64
  cells            INTEGER NOT NULL,            -- [-] number of cells
  end_time         REAL NOT NULL,               -- [h/U_b] simulated time to reach
  ranks            INTEGER NOT NULL,            -- [-] MPI ranks for the next attempt
  physics          TEXT NOT NULL CHECK (json_valid(physics)), -- [-] all physical parameters, defaults written out, JSON
  run              TEXT NOT NULL CHECK (json_valid(run)),     -- [-] how far and how it runs, JSON
  state            TEXT NOT NULL DEFAULT 'new' CHECK (state IN
    ('new', 'running', 'finished', 'interrupted', 'diverged', 'failed')), -- [-] new, running, finished, interrupted
                                                -- (checkpointed, not finished), diverged (never retried unchanged), failed
  state_reason     TEXT NOT NULL DEFAULT '',    -- [-] why it is in this state
  state_since      TEXT NOT NULL,               -- [UTC] when it came into this state
  stale            INTEGER NOT NULL GENERATED ALWAYS AS (stale_reason <> '') STORED, -- [-] 1: its results no longer match the program
  stale_reason     TEXT NOT NULL DEFAULT '',    -- [-] why its results are stale; empty: they are not
  forgiven         INTEGER NOT NULL DEFAULT 0,  -- [-] attempts up to this one no longer count as without progress (retry)
  in_campaign      INTEGER NOT NULL DEFAULT 1 CHECK (in_campaign IN (0, 1)), -- [-] 0: left over from an earlier sweep
  created          TEXT NOT NULL,               -- [UTC] first recorded
  varied           TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(varied)) -- [-] what differs among the cases of the sweep, with the values of this one, JSON
) STRICT;

-- One row a launch of the solver. It is written before the launch, so that no launch is ever forgotten.
CREATE TABLE attempts (
  case_id          TEXT NOT NULL REFERENCES cases (case_id), -- [-] the case
  attempt          INTEGER NOT NULL CHECK (attempt > 0), -- [-] 1, 2, ... within the case
  intended         TEXT NOT NULL,               -- [UTC] decided, before the launch
  started          TEXT,                        -- [UTC] launched; NULL: not known to have been
  ended            TEXT,                        -- [UTC] ended; NULL: running, or its manager died
  host             TEXT NOT NULL,               -- [-] machine
  ranks            INTEGER NOT NULL,            -- [-] MPI ranks
  resumed_from     TEXT,                        -- [-] checkpoint it started from; NULL: the initial state
  outcome          TEXT CHECK (outcome IN
    ('finished', 'interrupted', 'diverged', 'bad case', 'bad checkpoint', 'i/o failure', 'timeout', 'killed',
     'out of memory', 'node failure', 'stalled', 'not started', 'lost', 'failed')), -- [-] how it ended, in one or two words
  reason           TEXT,                        -- [-] why it ended so
  exit_code        INTEGER,                     -- [-] exit status of the launcher, 128 + signal when killed
  step             INTEGER,                     -- [-] furthest time step reached
  time             REAL,                        -- [h/U_b] simulated time of that step
  attempt_steps    INTEGER,                     -- [-] time steps made by this attempt
  wall_seconds     REAL,                        -- [s] wall-clock time of the attempt
  ns_per_cell_step REAL,                        -- [ns] wall-clock time of one cell and step
  version          TEXT,                        -- [-] version of softwall-dns
  git_revision     TEXT,                        -- [-] revision softwall-dns was built from
  build_type       TEXT,                        -- [-] Release, Debug, ...
  compiler         TEXT,                        -- [-] compiler and its version
  handle           TEXT,                        -- [-] by which its launcher finds the attempt; NULL: never launched
  PRIMARY KEY (case_id, attempt)
) STRICT;

-- Health numbers that the solver reports at the end of an attempt, by name.
CREATE TABLE diagnostics (
  case_id          TEXT NOT NULL,               -- [-] the case
  attempt          INTEGER NOT NULL,            -- [-] the attempt that reported it
  name             TEXT NOT NULL,               -- [-] e.g. max_divergence, interface_width_cells, min_eigenvalue_B
  value            REAL,                        -- [see name] its value, scaled with h, U_b and density
  PRIMARY KEY (case_id, attempt, name),
  FOREIGN KEY (case_id, attempt) REFERENCES attempts (case_id, attempt)
) STRICT;

-- Every checkpoint that was ever seen, and whether it is still there.
CREATE TABLE checkpoints (
  case_id          TEXT NOT NULL REFERENCES cases (case_id), -- [-] the case
  path             TEXT NOT NULL,               -- [-] file, relative to the run directory
  step             INTEGER NOT NULL,            -- [-] time step
  time             REAL NOT NULL,               -- [h/U_b] simulated time
  bytes            INTEGER NOT NULL,            -- [B] size of the file
  digest           TEXT NOT NULL,               -- [-] xxh3 over its contents, 16 hexadecimal digits
  valid            INTEGER NOT NULL CHECK (valid IN (0, 1)), -- [-] 1: complete, undamaged and of this case
  reason           TEXT NOT NULL DEFAULT '',    -- [-] why it is not valid
  present          INTEGER NOT NULL DEFAULT 1 CHECK (present IN (0, 1)), -- [-] 0: no longer there
  first_seen       TEXT NOT NULL,               -- [UTC] first seen by the manager
  seen             TEXT NOT NULL,               -- [UTC] last seen by the manager
  PRIMARY KEY (case_id, path)
) STRICT;

-- What was measured: one row a case and quantity. The view `results` shows the same with one row a case.
CREATE TABLE quantities (
  case_id          TEXT NOT NULL REFERENCES cases (case_id), -- [-] the case
  quantity         TEXT NOT NULL,               -- [-] name; a column of `results`, or a detail of its average or log-law fit
  value            REAL,                        -- [h, U_b, density] value; NULL: not defined for this case
  ci95             REAL,                        -- [as value] half width of its 95 % confidence interval; NULL: none can be given
  window_start     REAL NOT NULL,               -- [h/U_b] begin of the averaging window
  window_end       REAL NOT NULL,               -- [h/U_b] end of the averaging window
  blocks           INTEGER NOT NULL,            -- [-] statistics blocks used
  note             TEXT NOT NULL,               -- [-] why a value or an interval is missing; empty: all is well
  analysis_version INTEGER NOT NULL,            -- [-] version of the analysis that made it
  git_revision     TEXT NOT NULL,               -- [-] revision of the program that made it
  recorded         TEXT NOT NULL,               -- [UTC] when it was recorded
  PRIMARY KEY (case_id, quantity)
) STRICT;

-- What every table, view and column means. Row with an empty column name: the table or view itself.
CREATE TABLE documentation (
  object           TEXT NOT NULL,               -- [-] table or view
  column_name      TEXT NOT NULL,               -- [-] column; empty: the table or view itself
  unit             TEXT NOT NULL,               -- [-] unit; "-": none
  meaning          TEXT NOT NULL,               -- [-] what it holds
  PRIMARY KEY (object, column_name)
) STRICT;

-- Views. They are made anew whenever a store of an earlier format is opened.

-- The results of all cases that the store knows, one row a case, precursor first; also of those that earlier
-- versions of the campaign file asked for. X_ci95 is the half width of X's 95 % interval.
CREATE VIEW results_all (
  case_id,            -- [-] hash of the physical parameters
  label,              -- [-] for people
  G,                  -- [rho U_b^2] modulus of transverse elasticity; NULL: rigid precursor
  viscosity_ratio,    -- [-] solid over fluid viscosity; NULL: rigid precursor
  re_tau_w,           -- [-] friction Reynolds number of the bottom rigid wall
  re_tau_w_ci95,      -- [-] its interval
  re_tau,             -- [-] friction Reynolds number of the upper wall (elastic; rigid in the precursor)
  re_tau_ci95,        -- [-] its interval
  u_max,              -- [U_b] maximum of the mean velocity
  u_max_ci95,         -- [U_b] its interval
  y_max,              -- [h] where it is, counted from the centre plane, negative toward the bottom wall
  y_max_ci95,         -- [h] its interval
  d,                  -- [h] shift of the origin of the log law at the elastic wall
  d_ci95,             -- [h] its interval
  k_plus_dk,          -- [-] inverse slope of that log law, k + Delta k
  k_plus_dk_ci95,     -- [-] its interval
  delta_u_plus,       -- [-] downward shift of that log law, in its own wall units
  delta_u_plus_ci95,  -- [-] its interval
  delta_max,          -- [h] mean over time of the largest departure of the interface from its mean height
  delta_max_ci95,     -- [h] its interval
  delta_rms,          -- [h] rms of the interface height about its mean
  delta_rms_ci95,     -- [h] its interval
  state,              -- [-] see cases.state; only a finished case has its full window
  stale_reason,       -- [-] why the numbers no longer match the program; empty: they do
  window_start,       -- [h/U_b] begin of the averaging window; NULL: no result yet
  window_end,         -- [h/U_b] end of the averaging window
  blocks,             -- [-] statistics blocks used
  note,               -- [-] why a value or an interval is missing
  reynolds,           -- [-] bulk Reynolds number
  grid,               -- [-] cells as nx x (ny_fluid + ny_solid) x nz
  end_time,           -- [h/U_b] simulated time to reach
  varied,             -- [-] what differs among the cases of the sweep, with the values of this one, JSON: varied ->> 'seed'
  attempts,           -- [-] launches so far
  core_hours,         -- [h] wall-clock time times ranks, all attempts that have ended
  solver_revision,    -- [-] revision of softwall-dns in the newest attempt that told it
  analysis_version,   -- [-] version of the analysis
  git_revision,       -- [-] revision of the program that analysed
  in_campaign         -- [-] 0: left over from an earlier sweep
) AS
WITH pivot AS (
  SELECT case_id,
    max(value) FILTER (WHERE quantity = 're_tau_w') AS re_tau_w,
    max(ci95) FILTER (WHERE quantity = 're_tau_w') AS re_tau_w_ci95,
    max(value) FILTER (WHERE quantity = 're_tau') AS re_tau,
    max(ci95) FILTER (WHERE quantity = 're_tau') AS re_tau_ci95,
    max(value) FILTER (WHERE quantity = 'u_max') AS u_max,
    max(ci95) FILTER (WHERE quantity = 'u_max') AS u_max_ci95,
    max(value) FILTER (WHERE quantity = 'y_max') AS y_max,
    max(ci95) FILTER (WHERE quantity = 'y_max') AS y_max_ci95,
    max(value) FILTER (WHERE quantity = 'd') AS d,
    max(ci95) FILTER (WHERE quantity = 'd') AS d_ci95,
    max(value) FILTER (WHERE quantity = 'k_plus_dk') AS k_plus_dk,
    max(ci95) FILTER (WHERE quantity = 'k_plus_dk') AS k_plus_dk_ci95,
    max(value) FILTER (WHERE quantity = 'delta_u_plus') AS delta_u_plus,
    max(ci95) FILTER (WHERE quantity = 'delta_u_plus') AS delta_u_plus_ci95,
    max(value) FILTER (WHERE quantity = 'delta_max') AS delta_max,
    max(ci95) FILTER (WHERE quantity = 'delta_max') AS delta_max_ci95,
    max(value) FILTER (WHERE quantity = 'delta_rms') AS delta_rms,
    max(ci95) FILTER (WHERE quantity = 'delta_rms') AS delta_rms_ci95,
    max(window_start) AS window_start, max(window_end) AS window_end, max(blocks) AS blocks, max(note) AS note,
    max(analysis_version) AS analysis_version, max(git_revision) AS git_revision
  FROM quantities GROUP BY case_id)
SELECT c.case_id, c.label, c.G, c.viscosity_ratio,
  p.re_tau_w, p.re_tau_w_ci95, p.re_tau, p.re_tau_ci95, p.u_max, p.u_max_ci95, p.y_max, p.y_max_ci95,
  p.d, p.d_ci95, p.k_plus_dk, p.k_plus_dk_ci95, p.delta_u_plus, p.delta_u_plus_ci95,
  p.delta_max, p.delta_max_ci95, p.delta_rms, p.delta_rms_ci95,
  c.state, c.stale_reason, p.window_start, p.window_end, p.blocks, p.note,
  c.reynolds, c.grid, c.end_time, c.varied, (SELECT count(*) FROM attempts a WHERE a.case_id = c.case_id),
  (SELECT sum(a.wall_seconds * a.ranks) / 3600.0 FROM attempts a WHERE a.case_id = c.case_id),
  (SELECT a.git_revision FROM attempts a WHERE a.case_id = c.case_id AND a.git_revision IS NOT NULL
   ORDER BY a.attempt DESC LIMIT 1),
  p.analysis_version, p.git_revision, c.in_campaign
FROM cases c LEFT JOIN pivot p ON p.case_id = c.case_id
ORDER BY c.is_precursor DESC, c.viscosity_ratio = 1 DESC, c.viscosity_ratio, c.G DESC, c.case_id;

-- The result of the campaign: the rows of results_all that are part of the campaign as it is now.
CREATE VIEW results AS SELECT * FROM results_all WHERE in_campaign = 1;

-- Where the initial state of each case is from, and the line of cases that led to it.
CREATE VIEW started_from (
  label,              -- [-] of the case
  start,              -- [-] perturbed_laminar: by itself; precursor: the flow of a rigid channel, under a flat layer at rest; neighbour: flow and deformed layer of another case
  from_label,         -- [-] of the case whose last checkpoint it started from; NULL: by itself
  from_time,          -- [h/U_b] time which that case had reached; NULL: by itself
  generation,         -- [-] cases before it in its line
  line,               -- [-] their labels and its own, from the first on
  case_id,            -- [-] the case
  from_case_id        -- [-] the case that it started from; NULL: by itself
) AS
WITH RECURSIVE lines (case_id, generation, line) AS (
  SELECT case_id, 0, label FROM cases
  WHERE precursor_id IS NULL OR precursor_id NOT IN (SELECT case_id FROM cases)
  UNION ALL
  SELECT c.case_id, l.generation + 1, l.line || ' > ' || c.label
  FROM cases c JOIN lines l ON c.precursor_id = l.case_id)
SELECT c.label, c.physics ->> '$.initial.type', f.label,
  iif(c.precursor_id IS NULL, NULL, c.physics ->> '$.initial.precursor_time'), l.generation, l.line, c.case_id,
  c.precursor_id
FROM cases c JOIN lines l USING (case_id) LEFT JOIN cases f ON f.case_id = c.precursor_id
ORDER BY l.generation, c.rowid;

-- Every launch, in the order of the decisions, with the case's label.
CREATE VIEW attempt_history (
  intended,           -- [UTC] decided
  label,              -- [-] of the case
  attempt,            -- [-] 1, 2, ... within the case
  outcome,            -- [-] how it ended; NULL: running, or its manager died
  reason,             -- [-] why it ended so
  step,               -- [-] furthest time step reached
  time,               -- [h/U_b] its simulated time
  wall_seconds,       -- [s] wall-clock time
  ns_per_cell_step,   -- [ns] wall-clock time of one cell and step
  core_hours,         -- [h] wall-clock time times ranks
  exit_code,          -- [-] exit status of the launcher
  resumed_from,       -- [-] checkpoint it started from
  host,               -- [-] machine
  ranks,              -- [-] MPI ranks
  git_revision,       -- [-] revision softwall-dns was built from
  case_id             -- [-] the case
) AS
SELECT a.intended, c.label, a.attempt, a.outcome, a.reason, a.step, a.time, a.wall_seconds, a.ns_per_cell_step,
  a.wall_seconds * a.ranks / 3600.0, a.exit_code, a.resumed_from, a.host, a.ranks, a.git_revision, a.case_id
FROM attempts a JOIN cases c USING (case_id)
ORDER BY a.intended, a.case_id, a.attempt;

-- How far each case has come, and what it cost.
CREATE VIEW progress (
  label,              -- [-] of the case
  state,              -- [-] see cases.state
  state_reason,       -- [-] why it is in this state
  step,               -- [-] furthest time step of any ended attempt
  time,               -- [h/U_b] furthest simulated time of any ended attempt
  end_time,           -- [h/U_b] simulated time to reach
  percent,            -- [%] time over end_time
  attempts,           -- [-] launches so far
  core_hours,         -- [h] wall-clock time times ranks, all attempts
  case_id             -- [-] the case
) AS
SELECT c.label, c.state, c.state_reason, max(a.step), max(a.time), c.end_time,
  min(100.0, 100.0 * max(a.time) / c.end_time), count(a.attempt), sum(a.wall_seconds * a.ranks) / 3600.0, c.case_id
FROM cases c LEFT JOIN attempts a USING (case_id)
GROUP BY c.case_id ORDER BY c.is_precursor DESC, c.created, c.label;

-- All that happened, in order.
CREATE VIEW timeline (
  at,                 -- [UTC] when
  event,              -- [-] attempt intended, attempt started, attempt ended, checkpoint seen, result recorded
  label,              -- [-] of the case
  attempt,            -- [-] attempt; NULL for checkpoints and results
  detail,             -- [-] outcome and reason, file, or window
  case_id             -- [-] the case
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
ORDER BY e.at, e.case_id, e.rank, e.attempt;
