"""Checks every command of an app that a README prints: readme_commands.py SOURCE_DIR BIN_DIR

A command is a line of a code block with the name of an app. Each of its options has to be in the app's --help, each key
of --set in --list-keys, each format of dataset2rawlog in its help, and the files of this tree that it names have to exist.
`landmark-localization CONFIG.ini` with a data set of this tree is also run as printed, with --dry-run.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

APPS = {"landmark-localization", "landmark-simulator", "images2rawlog", "dataset2rawlog", "localization-report"}
OWN_FOLDERS = {"ini", "datasets", "apps", "tests"}  # below them every named file is part of the tree
NOT_SHIPPED = {"build", "out"}


def read(path):
    return path.read_text(encoding="utf-8").split("\n")


def code_lines(path):
    """(number, text) of the lines of code blocks; continued lines are joined."""
    joined, start = "", 0
    for number, line in enumerate(read(path), 1):
        if not line.startswith("    "):
            joined = ""
            continue
        start = start if joined else number
        joined += " " + line.strip().removesuffix("\\")
        if line.rstrip().endswith("\\"):
            continue
        yield start, joined.strip()
        joined = ""


def command_in(text):
    """The words of the command from the app's name on; none where the line has no app."""
    try:
        words = shlex.split(text, comments=True)
    except ValueError:
        return []
    for index, word in enumerate(words):
        if pathlib.PurePath(word).name in APPS and index <= 2:
            following = [w for w in words[index + 1 :]]
            return [pathlib.PurePath(word).name, *following]
    return []


def is_synopsis(words):
    return any(re.fullmatch(r"\[?[A-Z][A-Z_]+(\.\.\.)?\]?|\[.*|.*\]|.*\|.*", word) for word in words[1:])


class Checker:
    def __init__(self, source, programs):
        self.source, self.programs, self.wrong, self.checked, self.run_count = source, programs, [], 0, 0
        self.helps = {}

    def output(self, app, *arguments):
        result = subprocess.run([self.programs / app, *arguments], capture_output=True, text=True, cwd=self.source)
        return result.returncode, result.stdout + result.stderr

    def help_of(self, app):
        if app not in self.helps:
            self.helps[app] = self.output(app, "--help")[1]
        return self.helps[app]

    def check(self, readme, number, words):
        app, arguments = words[0], words[1:]
        self.checked += 1

        def fail(what):
            self.wrong.append(f"{readme.relative_to(self.source)}:{number}: {' '.join(words)}: {what}")

        for word in arguments:
            option = word.strip("[]").split("=")[0]
            if re.fullmatch(r"-{1,2}[a-z][a-z-]*", option) and not re.search(
                rf"(?<![\w-]){re.escape(option)}(?![\w-])", self.help_of(app)
            ):
                fail(f"no option {option}")
            path = pathlib.PurePath(word)
            if len(path.parts) > 1 and path.parts[0] in OWN_FOLDERS and not (self.source / word).exists():
                fail(f"no file {word}")
        if app == "dataset2rawlog" and arguments and re.fullmatch(r"[a-z][a-z-]*", arguments[0]):
            if not re.search(rf"^ *{re.escape(arguments[0])}:", self.help_of(app), re.MULTILINE):
                fail(f"no format {arguments[0]}")
        self.dry_run(app, arguments, fail)

    def dry_run(self, app, arguments, fail):
        """A localization in a configuration whose files are all shipped."""
        if app != "landmark-localization" or is_synopsis(["", *arguments]):
            return
        if not arguments or not arguments[0].startswith("ini/") or not (self.source / arguments[0]).exists():
            return
        text = (self.source / arguments[0]).read_text(encoding="utf-8")
        if "/out/" in text or "/usr/" in text or any(w.startswith("my") for w in arguments):
            return
        with tempfile.TemporaryDirectory() as folder:
            code, output = self.output(app, *arguments, "--dry-run", "-o", folder) if "-o" not in arguments else (
                self.output(app, *arguments, "--dry-run")
            )
        self.run_count += 1
        if code != 0:
            fail(f"exit code {code}: {output.strip().splitlines()[-1:]}")


def main():
    source, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    checker = Checker(source, programs)
    for folder, folders, files in os.walk(source):
        folders[:] = [f for f in folders if not f.startswith((".", "build")) and f not in NOT_SHIPPED]
        if "README.md" not in files:
            continue
        readme = pathlib.Path(folder) / "README.md"
        for number, text in code_lines(readme):
            words = command_in(text)
            if words and (programs / words[0]).exists():
                checker.check(readme, number, words)
    print("\n".join(checker.wrong) or f"{checker.checked} commands, {checker.run_count} of them run")
    if checker.checked < 20:
        sys.exit("fewer than 20 commands found: are the apps built?")
    sys.exit(1 if checker.wrong else 0)


if __name__ == "__main__":
    main()
