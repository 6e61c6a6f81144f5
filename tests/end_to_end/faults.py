"""What may happen to a campaign: each fault is a function of the trial that it is done to and of a random generator. It
returns what it has done, in words, or None where there was nothing to do it to."""

import os
import signal
import subprocess
import time

from harness import WAIT

PAGE = 4096


def is_finished(directory):
    """By its own end record."""
    try:
        return '"outcome": "finished"' in (directory / "summary.json").read_text()
    except OSError:
        return False


def signal_one(trial, random, what):
    """To the runner, an mpirun or a rank, by its place in a list that does not depend on process numbers."""
    everybody = [("softwall", "", trial.runner.pid)] if trial.runner.poll() is None else []
    everybody += [(name, place, pid) for pid, (name, place) in trial.campaign.solvers().items()]
    if not everybody:
        return None
    name, place, pid = random.choice(sorted(everybody))
    try:
        os.kill(pid, what)
    except ProcessLookupError:
        return None
    return pid, f"{name} {os.path.basename(place)}".strip()


# -- to processes -----------------------------------------------------------------------------------------------------


def kill_one(trial, random):
    hit = signal_one(trial, random, signal.SIGKILL)
    return hit and f"SIGKILL to {hit[1]}"


def terminate_one(trial, random):
    hit = signal_one(trial, random, signal.SIGTERM)
    return hit and f"SIGTERM to {hit[1]}"


def stop_one_for_a_while(trial, random):
    hit = signal_one(trial, random, signal.SIGSTOP)
    if not hit:
        return None
    time.sleep(random.uniform(0.1, 1))
    try:
        os.kill(hit[0], signal.SIGCONT)
    except ProcessLookupError:
        pass
    return f"SIGSTOP, later SIGCONT, to {hit[1]}"


def kill_the_runner(trial, random):
    if trial.runner.poll() is not None:
        return None
    trial.runner.kill()
    trial.runner.wait()
    return "SIGKILL to softwall, resumed at once"


def kill_everything(trial, random):
    trial.campaign.kill_all(trial.runner)
    return "SIGKILL to all"


def ask_to_stop(trial, random):
    if trial.runner.poll() is not None:
        return None
    trial.runner.send_signal(signal.SIGINT)
    trial.wait_for_runner("to stop on request")
    return "SIGINT to softwall"


# -- two managers -----------------------------------------------------------------------------------------------------


def second_manager(trial, random):
    """While one works."""
    second = trial.campaign.start("resume")
    trial.expect_refusal(second, trial.runner)
    return "a second softwall"


def two_managers_at_once(trial, random):
    """Where there was none: one of them becomes the runner."""
    trial.campaign.kill_all(trial.runner)
    first, second = trial.campaign.start("resume"), trial.campaign.start("resume")
    end = time.monotonic() + WAIT
    while first.poll() is None and second.poll() is None and time.monotonic() < end:
        time.sleep(0.02)
    loser, trial.runner = (first, second) if first.poll() is not None else (second, first)
    trial.expect_refusal(loser, trial.runner)
    return "SIGKILL to all, then two softwalls at once"


# -- to files ---------------------------------------------------------------------------------------------------------


def overwrite(file, at, contents):
    with open(file, "r+b") as opened:
        opened.seek(at)
        opened.write(contents)


def flip_a_bit(file, random):
    contents = file.read_bytes()
    at = random.randrange(len(contents))
    overwrite(file, at, bytes([contents[at] ^ 1 << random.randrange(8)]))
    return f"bit flipped at byte {at}"


def truncate(file, random):
    size = random.choice([0, 1, file.stat().st_size // 2, file.stat().st_size - 1])
    os.truncate(file, size)
    return f"truncated to {size} bytes"


def zero_a_page(file, random):
    page = random.randrange(max(1, file.stat().st_size // PAGE))
    contents = file.read_bytes()[page * PAGE : (page + 1) * PAGE]
    if not contents.strip(b"\0"):
        return None  # it was zero before
    overwrite(file, page * PAGE, bytes(len(contents)))
    return f"page {page} zeroed"


def zero_a_page_of_a_tree(store, random):
    """SQLite notices what has lost its structure. The text of a page that only continues a long value has none: another
    text there is found by `softwall verify` and mended by `rebuild`, which a person has to ask for."""
    contents = store.read_bytes()
    kinds = (2, 5, 10, 13)  # of pages of tables and indices, in their first byte
    pages = [page for page in range(1, len(contents) // PAGE) if contents[page * PAGE] in kinds]
    if not pages:
        return None
    page = random.choice(pages)
    overwrite(store, page * PAGE, bytes(PAGE))
    return f"page {page} zeroed"


def newest_checkpoints(trial):
    """[newest, ...] of every case that has another one left to go on from, and has not finished: nobody looks into
    the checkpoints of a finished case, but for a precursor's, until all have finished that start from it."""
    if all(is_finished(directory) for directory in trial.campaign.folder.glob("cases/*")):
        return []
    found = []
    for directory in sorted(trial.campaign.folder.glob("cases/*")):
        good = [file for file in sorted(directory.glob("checkpoints/checkpoint-*.h5"), reverse=True)
                if file not in trial.damaged and not file.is_symlink()]
        if len(good) > 1 and (directory.name.startswith("precursor") or not is_finished(directory)):
            found.append(good[0])
    return found


def damage_the_newest_checkpoint(trial, random):
    trial.campaign.kill_all(trial.runner)
    files = newest_checkpoints(trial)
    if not files:
        return None
    file = random.choice(files)
    done = random.choice([flip_a_bit, truncate, zero_a_page])(file, random)
    trial.damaged.add(file)
    return done and f"SIGKILL to all, {file.parent.parent.name}/{file.name} {done}"


def make_a_checkpoint_unreadable(trial, random):
    """For a while, as a server that does not answer would: root can read whatever its mode, but no link to itself."""
    trial.campaign.kill_all(trial.runner)
    files = newest_checkpoints(trial)
    if not files:
        return None
    file = random.choice(files)
    contents = file.read_bytes()
    file.unlink()
    file.symlink_to(file)
    trial.resume()
    time.sleep(random.uniform(0.3, 1.5))
    trial.campaign.kill_all(trial.runner)
    if not file.is_symlink():
        trial.wrong(f"{file} could not be read, and was not left alone")
    file.unlink(missing_ok=True)
    file.write_bytes(contents)
    return f"SIGKILL to all, {file.parent.parent.name}/{file.name} not readable for a while"


def damage_the_store(trial, random):
    trial.campaign.kill_all(trial.runner)
    store = trial.campaign.folder / "results.db"
    if not store.exists():
        return None
    for suffix in ("-wal", "-shm"):
        (trial.campaign.folder / f"results.db{suffix}").unlink(missing_ok=True)
    kind = random.choice(["removed", "garbage", "truncated", "zeroed"])
    if kind == "removed":
        store.unlink()
    elif kind == "garbage":
        store.write_bytes(random.randbytes(len(store.read_bytes())))
    else:
        (truncate if kind == "truncated" else zero_a_page_of_a_tree)(store, random)
    return f"SIGKILL to all, results.db {kind}"


def damage_the_store_at_work(trial, random):
    store = trial.campaign.folder / "results.db"
    if trial.runner.poll() is not None or not store.exists():
        return None
    done = zero_a_page_of_a_tree(store, random)
    return done and f"results.db {done} while softwall works"


def lose_statistics(trial, random):
    files = sorted(trial.campaign.folder.glob("cases/*/statistics.h5"))
    if not files:
        return None
    file = random.choice(files)
    try:
        done = "removed" if random.random() < 0.5 else truncate(file, random)
        if done == "removed":
            file.unlink()
    except OSError:
        return None  # its solver was faster
    return f"{file.parent.name}/statistics.h5 {done}"


def lose_a_summary(trial, random):
    trial.campaign.kill_all(trial.runner)
    files = sorted(trial.campaign.folder.glob("cases/*/summary.json"))
    if not files:
        return None
    file = random.choice(files)
    file.unlink()
    return f"SIGKILL to all, {file.parent.name}/summary.json removed"


def fill_the_disk(trial, random):
    """Of a small disk of its own; where that cannot be mounted, files are limited to a size that no checkpoint has."""
    if not trial.disk:
        trial.campaign.kill_all(trial.runner)
        trial.resume(file_limit=random.choice([16, 48]) * 1024)
        time.sleep(random.uniform(0.3, 1.5))
        trial.campaign.kill_all(trial.runner)
        return "SIGKILL to all, files limited for a while"
    ballast = trial.campaign.folder / "ballast"
    subprocess.run(["dd", "if=/dev/zero", f"of={ballast}", "bs=4096"], capture_output=True, check=False)
    time.sleep(random.uniform(0.3, 1.5))
    ballast.unlink()
    return "disk full for a while"


def let_calls_for_files_fail(trial, random):
    """Of one kind, on one rank or in softwall, some or all for a while."""
    if trial.failing is None:
        return None  # built without tests
    program, rank, path = random.choice([
        ("softwall-dns", 0, "/checkpoints/"), ("softwall-dns", 1, "/checkpoints/"), ("softwall-dns", 0, "statistics.h5"),
        ("softwall-dns", 0, "summary.json"), ("softwall-dns", 0, "status.json"), ("softwall", "-", "results.db"),
        ("softwall", "-", "run.json"), ("softwall", "-", "history.json"), ("softwall", "-", "case.json"),
        ("softwall", "-", "manager.log")])
    call, error = random.choice(["write", "write", "sync", "rename", "create"]), random.choice(["ENOSPC", "EIO", "EDQUOT"])
    if call == "write" and random.random() < 0.3:
        error = "SHORT"
    first, count = random.choice([1, 1, 2, 5, 11]), random.choice([1, 1000000])
    trial.failing.begin(program, rank, call, error, path, first, count)
    end = time.monotonic() + random.uniform(0.5, 2)
    while time.monotonic() < end and not trial.failing.log.exists():
        time.sleep(0.02)
    failed = trial.failing.end()
    return f"{error} from {len(failed)} calls to {call} {path} in {program} {rank}" if failed else None


# What is named twice strikes twice as often.
FAULTS = [
    kill_one, kill_one, kill_one, terminate_one, terminate_one, stop_one_for_a_while, kill_the_runner, kill_everything,
    ask_to_stop, second_manager, two_managers_at_once, damage_the_newest_checkpoint, damage_the_newest_checkpoint,
    make_a_checkpoint_unreadable, damage_the_store, damage_the_store_at_work, lose_statistics, lose_statistics,
    lose_a_summary, fill_the_disk, let_calls_for_files_fail, let_calls_for_files_fail, let_calls_for_files_fail,
]
