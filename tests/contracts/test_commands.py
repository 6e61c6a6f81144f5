"""The commands of softwall are the documented ones."""

import re
import unittest

from repository import committed_files, run_softwall, text_of

MENTION = re.compile(r"(?:^|[`\s/;(])softwall ([a-z]+)\b(?=[^`\n]*(?:`|\n))")


def commands():
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", run_softwall("--help"), re.MULTILINE)
    return re.findall(r"^  (\w+) ", listed.group(1), re.MULTILINE)


def code_in(markdown):
    """What stands in backquotes, in fenced blocks or in indented ones, line by line."""
    lines = re.findall(r"^```.*?^```|^ {4,}[^\n]*$|`[^`\n]+`", markdown, re.MULTILINE | re.DOTALL)
    return "\n".join(lines) + "\n"


class Commands(unittest.TestCase):
    def test_help_lists_commands(self):
        self.assertIn("run", commands())

    def test_every_command_is_documented(self):
        documented = MENTION.findall(code_in(text_of("campaign/README.md")))
        self.assertEqual(sorted(set(commands()) - set(documented)), [])

    def test_the_manual_page_lists_the_commands(self):
        page = text_of("campaign/softwall.1")
        explained = re.findall(r"^\.It Cm (\w+)$", page, re.MULTILINE)
        self.assertEqual(sorted(explained), sorted(commands()))
        called = " | ".join(re.findall(r"^\.Cm (.+)$", page.partition(".Sh DESCRIPTION")[0], re.MULTILINE))
        self.assertEqual(sorted(called.split(" | ")), sorted(commands()), "in the synopsis")

    def test_every_documented_command_exists(self):
        for path in committed_files():
            if path.suffix != ".md":
                continue
            for command in MENTION.findall(code_in(text_of(path))):
                self.assertIn(command, commands(), f"{path} mentions 'softwall {command}'")

    def test_every_command_has_help(self):
        for command in commands():
            self.assertIn("Usage:", run_softwall(command, "--help"))


if __name__ == "__main__":
    unittest.main()
