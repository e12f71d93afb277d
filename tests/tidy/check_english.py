#!/usr/bin/env python3
"""Checks the English of everything that users read.

Usage: check_english.py ROOT [FILE...]
Checked are README.md, CHANGELOG.md, CONTRIBUTING.md, SECURITY.md and docs/ (without records/), the comments of public headers and
.proto files, and strings of four words or more in the sources of programs and libraries: help texts, errors and log lines.

Faults are words that docs/glossary_banned.txt lists, sentences that begin with a free relative clause ("Who simulates ..."), lines of
documents, public headers and .proto files over 120 columns, and, if codespell is installed, misspellings.

Without FILE, all of them are checked.
"""

import bisect
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
BANNED = HERE.parents[1] / "docs" / "glossary_banned.txt"
SPELLING = HERE / "codespell_words.txt"
COLUMNS = 120

DOCUMENTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md")
SOURCES = ("base", "bench", "clients/bot", "clients/cpp", "examples", "modules", "physics/src", "scenes/src", "server", "tools")
FREE_RELATIVE = re.compile(
    r"(?:^|[.;:]\s+)((?:Who|What|Whom|Whoever|Whatever) (?!(?:is|are|does|do|did|was|were|can|should|happens|if)\b[^.]*\?)[\w']+)")
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def banned_words():
    """[(pattern, what to use)]"""
    words = []
    for line in BANNED.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            pattern, use = re.split(r" {2,}", line.strip(), maxsplit=1)
            words.append((re.compile(rf"\b(?:{pattern})\b", re.I), use))
    return words


def without(text, pattern, flags=0):
    """The text with matches blanked, so that lines and columns stay."""
    return re.sub(pattern, lambda match: re.sub(r"[^\n]", " ", match.group()), text, flags=flags)


def prose_of_markdown(text):
    text = without(text, r"^---\n.*?^---\n", re.M | re.S) if text.startswith("---\n") else text
    text = without(text, r"^( *)(```|~~~).*?^\1\2 *$", re.M | re.S)
    text = without(text, r"^(?: {4}|\t)(?! *(?:[-*]|\d+\.) ).*$", re.M)
    text = re.sub(r"`[^`\n]*`", lambda match: "X" * len(match.group()), text)
    text = without(text, r"\]\([^)\s]*\)")
    return without(text, r"<[^>\n]*>")


def comments_of(text):
    """Comments alone. In a block of them a line goes on with the sentence of the line before."""
    lines = []
    for line in text.splitlines():
        code = STRING.sub(lambda match: "X" * len(match.group()), line)
        match = re.search(r"//+!?<?", code)
        lines.append(" " * match.end() + line[match.end():] if match else "")
    return "\n".join(lines) + "\n"


def strings_of(text):
    lines = []
    for line in text.splitlines():
        strings = [match for match in STRING.finditer(line) if len(match.group(1).split()) >= 4 and not line.lstrip().startswith(("//", "#include"))]
        lines.append(" ".join(match.group(1) for match in strings))
    raw = re.compile(r'R"(\w*)\((.*?)\)\1"', re.S)
    blanked = "\n".join(lines) + "\n"
    # Raw strings, such as the examples below a help text, are whole.
    pieces = blanked.splitlines()
    for match in raw.finditer(text):
        first = text.count("\n", 0, match.start(2))
        for offset, line in enumerate(match.group(2).splitlines()):
            if first + offset < len(pieces):
                pieces[first + offset] = line
    return "\n".join(pieces) + "\n"


def sentences(prose):
    """[(position in the prose, text)]: paragraphs with their lines joined, so that a sentence has a beginning."""
    for match in re.finditer(r"(?:^[ \t]*\S.*\n)+", prose, re.M):
        yield match.start(), match.group()


def faults_of_text(text, words, *, wide=False, prose=None):
    """[(line, message)]"""
    starts = [0] + [match.end() for match in re.finditer("\n", prose)]
    line_at = lambda position: bisect.bisect_right(starts, position)  # noqa: E731
    faults = []
    for start, paragraph in sentences(prose):
        joined = re.sub(r"\n", " ", paragraph)
        lead = re.match(r"[\s>*+#|-]*(?:\d+\. )?(?:\*\*)?", joined).end()
        for match in FREE_RELATIVE.finditer(re.sub(r" {2,}", lambda gap: " " * len(gap.group()), joined[lead:])):
            faults.append((line_at(start + lead + match.start(1)), f'"{match.group(1)} ..." begins with a free relative clause; name the subject'))
        for pattern, use in words:
            for match in pattern.finditer(joined):
                faults.append((line_at(start + match.start()), f'"{match.group()}"; use: {use}'))
    if wide:
        for number, line in enumerate(text.splitlines(), 1):
            breakable = not line.lstrip().startswith(("|", "![", "[!")) and max(map(len, line.split()), default=0) <= 60
            if len(line) > COLUMNS and breakable:
                faults.append((number, f"{len(line)} columns; wrap at {COLUMNS}"))
    return sorted(faults)


def checked_files(root):
    """{path: kind}"""
    files = {path: "document" for path in DOCUMENTS if (root / path).is_file()}
    for path in sorted((root / "docs").rglob("*.md")):
        name = path.relative_to(root).as_posix()
        if not name.startswith("docs/records/") and name != "docs/glossary.md":
            files[name] = "document"
    for path in [*sorted((root / "proto").rglob("*.md")), *sorted((root / "clients").glob("**/README.md")), *sorted((root / "examples").glob("*.md"))]:
        if "node_modules" not in path.parts:
            files[path.relative_to(root).as_posix()] = "document"
    for path in sorted((root / "proto" / "jostle").rglob("*.proto")):
        files[path.relative_to(root).as_posix()] = "header"
    for folder in ("base", "clients", "modules", "physics", "proto", "scenes", "tools"):
        for path in sorted((root / folder).rglob("*.h")):
            name = path.relative_to(root).as_posix()
            if "/include/" in name and "node_modules" not in name:
                files[name] = "header"
    for folder in SOURCES:
        for path in sorted([*(root / folder).rglob("*.cpp"), *(root / folder).rglob("*.h")]):
            files.setdefault(path.relative_to(root).as_posix(), "source")
    return files


def faults_of_file(root, name, kind, words):
    text = (root / name).read_text(encoding="utf-8")
    if kind == "document":
        return faults_of_text(text, words, wide=True, prose=prose_of_markdown(text))
    if kind == "header":
        return sorted(faults_of_text(text, words, wide=True, prose=comments_of(text)) + faults_of_text(text, words, prose=strings_of(text)))
    return faults_of_text(text, words, prose=strings_of(text))


def misspellings(root, files):
    """Findings of codespell in documents, headers and .proto files; None without codespell."""
    if shutil.which("codespell") is None:
        return None
    names = [name for name, kind in files.items() if kind != "source"]
    run = subprocess.run(["codespell", "--ignore-words", str(SPELLING), "--ignore-regex", "`[^`]*`", *names], cwd=root, capture_output=True, text=True)
    return [line for line in run.stdout.splitlines() if "==>" in line]


def main():
    if len(sys.argv) < 2:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root, words = pathlib.Path(sys.argv[1]).resolve(), banned_words()
    files = checked_files(root)
    if sys.argv[2:]:
        files = {name: files.get(name, "source") for name in sys.argv[2:]}
    faults = 0
    for name, kind in files.items():
        for line, message in faults_of_file(root, name, kind, words):
            faults += 1
            print(f"{name}:{line}: {message}")
    spelling = misspellings(root, files)
    if spelling is None:
        print("skipped: the spelling, because codespell is not installed (scripts/setup installs it)")
    for line in spelling or []:
        faults += 1
        print(line)
    print(f"english: {len(files)} files, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
