"""Lets calls for files fail in chosen processes of a campaign, by tests/support/failing_io.cpp, where that was built beside
softwall."""

import os
from pathlib import Path

from harness import SOFTWALL

LIBRARY = SOFTWALL.parent / "libfailing_io.so"


class FailingIo:
    """Beside a campaign: what is asked for holds at once for all that is started after this was made."""

    def __init__(self, campaign):
        self.control = Path(f"{campaign.folder}.fault")
        self.log = Path(f"{self.control}.struck")
        campaign.environment = {**os.environ, "LD_PRELOAD": str(LIBRARY), "FAILING_IO": str(self.control)}

    def begin(self, program, rank, call, error, path, first=1, count=1):
        """The words of failing_io.cpp."""
        self.log.unlink(missing_ok=True)
        half = Path(f"{self.control}.half")
        half.write_text(f"{program} {rank} {call} {error} {path} {first} {count}\n")
        half.rename(self.control)

    def end(self):
        """The calls that failed, oldest first."""
        self.control.unlink(missing_ok=True)
        failed = self.log.read_text().splitlines() if self.log.exists() else []
        self.log.unlink(missing_ok=True)
        return failed
