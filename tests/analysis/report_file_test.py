"""report_file_test.py ROOT: where a report goes. ROOT is the source folder.

Exit 77 (skipped) where h5py or matplotlib is not installed.
"""

import os
import pathlib
import sys
import tempfile
import unittest

import packages_or_skip

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "analysis"))


class ReportFile(unittest.TestCase):
    def test_a_report_goes_to_what_is_named(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            new, link, kept, other = (folder / each for each in ("new.html", "link.html", "kept.html", "other name"))
            link.symlink_to("new.html")
            kept.write_text("old")
            kept.chmod(0o640)
            os.link(kept, other)
            for file in (new, link, kept):
                report.write_whole(file, f"to {file.name}")
            self.assertTrue(link.is_symlink())
            self.assertEqual((new.read_text(), other.read_text()), ("to link.html", "to kept.html"))
            self.assertEqual(kept.stat().st_mode & 0o777, 0o640)
            os.mkfifo(folder / "pipe")
            reader = os.open(folder / "pipe", os.O_RDONLY | os.O_NONBLOCK)
            report.write_whole(folder / "pipe", "through")
            self.assertEqual(os.read(reader, 100), b"through")
            os.close(reader)
            with self.assertRaisesRegex(SystemExit, "cannot write: Is a directory"):
                report.write_whole(folder, "nowhere")
            self.assertEqual(sorted(path.name for path in folder.iterdir()), sorted((
                "new.html", "link.html", "kept.html", "other name", "pipe")))


if __name__ == "__main__":
    packages_or_skip.needed("h5py", "matplotlib")
    import report
    unittest.main(argv=sys.argv[:1])
