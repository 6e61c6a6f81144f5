"""`softwall verify` tells of whatever was changed or damaged in a campaign's folder, and of nothing else."""

import contextlib
import sqlite3
import unittest

from harness import EndToEndTest, changed, seeded
from test_real_use import RIGID


class Verify(EndToEndTest):
    def test_verify_finds_what_was_changed(self):
        campaign = self.campaign(changed(RIGID, run={"end_time": 1, "checkpoint_steps": 4}))
        self.run_to_end(campaign)
        self.assert_sound(campaign)
        (folder,) = campaign.folder.glob("cases/*")
        newest, older = campaign.checkpoints("rigid_channel")[:2]
        sound = {file: file.read_bytes() for file in (newest, older, folder / "summary.json", folder / "case.json",
                                                      folder / "run.json", campaign.folder / "results.db")}

        def flip(file, at, bit):
            contents = bytearray(sound[file])
            contents[at] ^= 1 << bit
            file.write_bytes(contents)

        def change_a_result():
            with contextlib.closing(sqlite3.connect(campaign.folder / "results.db")) as store:
                store.execute("UPDATE quantities SET value = value * 1.0000001 WHERE quantity = 're_tau'")
                store.commit()

        chance = seeded()
        summary = folder / "summary.json"
        damages = [newest.unlink, lambda: newest.write_bytes(sound[older]), (folder / "run.json").unlink,
                   lambda: (folder / "case.json").write_bytes(sound[folder / "case.json"].replace(b"100", b"101")),
                   (campaign.folder / "results.db").unlink, summary.unlink,
                   lambda: summary.write_bytes(sound[summary].replace(b'"finished"', b'"interrupted"')),
                   change_a_result]
        for _ in range(10):
            at, bit = chance.randrange(len(sound[summary])), chance.randrange(8)
            damages.append(lambda at=at, bit=bit: flip(summary, at, bit))
        for number, damage in enumerate(damages):
            with self.subTest(number):
                damage()
                verdict = campaign.call("verify")
                self.assertEqual(verdict.returncode, 3, verdict.stdout)
                for file, contents in sound.items():
                    file.write_bytes(contents)
        self.assert_sound(campaign)

    def test_verify_tells_of_every_bit_of_the_store_that_matters(self):
        """One bit in a hundred places of results.db: SQLite finds it, or no answer changes, or `verify` tells."""
        campaign = self.campaign(changed(RIGID, run={"end_time": 1, "checkpoint_steps": 4}))
        self.run_to_end(campaign)
        campaign.write(changed(RIGID, run={"end_time": 1.3, "checkpoint_steps": 4}))
        self.run_to_end(campaign)  # a case with two attempts
        self.assert_sound(campaign)
        store = campaign.folder / "results.db"
        with contextlib.closing(sqlite3.connect(store)) as connection:
            connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        sound = store.read_bytes()
        # What stands nowhere but in the store: when something was decided, made or seen, and files that are gone.
        nowhere_else = {"campaign": {"spec", "created", "updated"}, "cases": {"state_since", "created", "forgiven"},
                        "attempts": {"intended", "handle"}, "checkpoints": {"first_seen", "seen", "reason"}}

        def answers():
            with contextlib.closing(sqlite3.connect(f"file:{store}?mode=ro", uri=True)) as connection:
                connection.text_factory = bytes
                if connection.execute("PRAGMA integrity_check").fetchall() != [(b"ok",)]:
                    return None
                found = {}
                for name, kind in connection.execute("SELECT name, type FROM sqlite_schema").fetchall():
                    if kind == b"index":
                        continue
                    rows = connection.execute(f'SELECT * FROM "{name.decode()}"')
                    columns = [column[0] for column in rows.description]
                    left_out = nowhere_else.get(name.decode(), set()) if kind == b"table" else set()
                    if kind == b"view" and name in (b"timeline", b"attempt_history", b"progress"):
                        continue  # they show the same times
                    kept = [i for i, column in enumerate(columns) if column not in left_out]
                    gone = columns.index("present") if name == b"checkpoints" else None
                    found[name] = sorted(repr([row[i] for i in kept]) for row in rows
                                         if gone is None or row[gone])
                return found

        before, chance, told = answers(), seeded(), 0
        for number in range(100):
            at, bit = chance.randrange(len(sound)), chance.randrange(8)
            store.write_bytes(sound[:at] + bytes([sound[at] ^ 1 << bit]) + sound[at + 1:])
            with self.subTest(number, byte=at, bit=bit):
                try:
                    now = answers()
                except (sqlite3.Error, UnicodeDecodeError):
                    continue  # SQLite refuses the file
                if now is None or now == before:
                    continue
                verdict = campaign.call("verify")
                self.assertNotEqual(verdict.returncode, 0, verdict.stdout)
                told += 1
        self.assertGreater(told, 0)
        store.write_bytes(sound)
        self.assert_sound(campaign)


if __name__ == "__main__":
    unittest.main(verbosity=2)
