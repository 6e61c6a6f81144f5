"""`softwall figures` and `softwall report` on a campaign that has ended and on one that has not."""

import html.parser
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from harness import CAMPAIGN, SOFTWALL, WAIT, EndToEndTest, changed

LONG = changed(CAMPAIGN, run={"end_time": 60, "checkpoint_steps": 20})


class Page(html.parser.HTMLParser):
    """What a page shows and where it points to."""

    def __init__(self, text):
        super().__init__()
        self.text, self.pictures, self.addresses, self.open = "", 0, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        named = dict(attributes)
        self.pictures += tag == "img"
        self.addresses += [value for key, value in named.items() if key in ("src", "href")]

    def handle_data(self, data):
        self.text += data


class Reports(EndToEndTest):
    def report(self, path, *more):
        answer = subprocess.run([SOFTWALL, "report", path, *more], capture_output=True, text=True, timeout=WAIT)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        file = Path(answer.stdout.strip())
        self.assertLess(file.stat().st_size, 15e6)
        page = Page(file.read_text())
        inside = ("data:image/svg+xml;base64,", "data:image/png;base64,")
        self.assertTrue(all(address.startswith(inside) for address in page.addresses))
        return page

    def test_a_finished_campaign_is_drawn_and_reported(self):
        campaign = self.campaign(changed(CAMPAIGN, description="<b>bold & plain</b>"))
        self.run_to_end(campaign)
        drawn = campaign.call("figures", "--format", "pdf", "-o", str(campaign.folder / "pictures"))
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        for file in map(Path, drawn.stdout.split()):
            self.assertEqual(file.read_bytes()[:5], b"%PDF-", file)
        self.assertRegex(drawn.stderr, r"\Anot drawn, wave_speeds: [^\n]*\n\Z")  # they want a longer run
        self.assertEqual(len(drawn.stdout.split()), 17)
        (row,) = campaign.query("SELECT re_tau_w FROM results WHERE label = 'G=2_mu=1'")
        labels = campaign.states()
        study = (campaign.folder / "campaign.json").rename(campaign.folder / "study.json")  # the file's own name is free
        page = self.report(study)
        self.assertEqual(page.pictures, len(drawn.stdout.split()))
        for label in labels:
            self.assertIn(label, page.text)
        for words in ("4 of 4 cases finished", "<b>bold & plain</b>", "Half of the text's G", "Every attempt"):
            self.assertIn(words, page.text)
        self.assertIn(f"{row['re_tau_w']:.1f}", page.text)
        refused = subprocess.run([SOFTWALL, "report", study, "-o", study], capture_output=True, text=True, timeout=WAIT)
        self.assertEqual(refused.returncode, 2, refused.stderr)

    def test_an_unfinished_campaign_is_reported(self):
        campaign = self.campaign(LONG)
        runner = campaign.start()
        campaign.wait_for_checkpoint("G=1_mu=1")
        page = self.report(campaign.folder, "-o", campaign.folder / "so far.html")
        campaign.kill_all(runner)
        for words in ("running", "1 of 4 cases finished"):
            self.assertIn(words, page.text)

    def test_a_campaign_that_never_ran_is_refused(self):
        campaign = self.campaign()
        for command in ("figures", "report"):
            answer = campaign.call(command)
            self.assertEqual(answer.returncode, 2)
            self.assertIn("no results store there", answer.stderr)


if __name__ == "__main__":
    drawing = [shutil.which("python3", path="/usr/bin") or "python3", "-c", "import h5py, matplotlib"]
    if subprocess.run(drawing, capture_output=True).returncode != 0:
        print("skipped: the system's Python has no h5py or no matplotlib")
        sys.exit(77)
    unittest.main()
