#!/usr/bin/env python3
"""Check that programs are hardened against memory errors and name each protection that is missing.

Usage: check_hardening.py PROGRAM...
       check_hardening.py --self-test COMPILER    a program built without each protection is rejected

Needs readelf. docs/design/security_model.md lists the protections.
"""

import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

# endbr64 at the targets of indirect calls. Start-up code of the toolchain contains a few.
BRANCH_TARGETS_MIN = 100


def readelf(option, program):
    done = subprocess.run(["readelf", "--wide", option, program], capture_output=True, text=True,
                          env={**os.environ, "LC_ALL": "C"})
    if done.returncode != 0 or "Not an ELF file" in done.stderr:
        raise ValueError(done.stderr.strip() or f"readelf {option} failed")
    return done.stdout


def branch_targets(program):
    """Number of endbr64 instructions in .text."""
    match = re.search(r"\]\s+\.text\s+PROGBITS\s+\S+\s+(\S+)\s+(\S+)", readelf("--section-headers", program))
    offset, size = int(match[1], 16), int(match[2], 16)
    return pathlib.Path(program).read_bytes()[offset:offset + size].count(b"\xf3\x0f\x1e\xfa")


def faults(program, branch_targets_min=BRANCH_TARGETS_MIN):
    found = []
    if not re.search(r"Type:\s+DYN \(Position-Independent Executable file\)", readelf("--file-header", program)):
        found.append("not a position-independent executable; link with -pie")
    segments = readelf("--program-headers", program)
    stack = re.search(r"GNU_STACK(?:\s+0x\S+){5}\s+(\S+)", segments)
    if not stack or "E" in stack[1]:
        found.append("the stack is executable; link with -z noexecstack")
    if "GNU_RELRO" not in segments:
        found.append("no GNU_RELRO segment; link with -z relro")
    if re.search(r"LOAD(?:\s+0x\S+){5}\s+RWE", segments):
        found.append("a segment is both writable and executable")
    if not re.search(r"BIND_NOW|Flags:.*\bNOW\b", readelf("--dynamic", program)):
        found.append("symbols are bound lazily; link with -z now")
    symbols = set(re.findall(r"\s(\w+)(?:@\S+)?(?: \(\d+\))?$", readelf("--dyn-syms", program), re.M))
    if "__stack_chk_fail" not in symbols:
        found.append("no stack protector; compile with -fstack-protector-strong")
    if not any(re.fullmatch(r"__\w+_chk", symbol) for symbol in symbols):
        found.append("no checked library calls; compile with -D_FORTIFY_SOURCE=3 and optimization")
    if not any("__glibcxx_assert_fail" in symbol for symbol in symbols):
        found.append("no assertions of the C++ library; compile with -D_GLIBCXX_ASSERTIONS")
    # The linker writes the property only if all of its inputs have it, and the start files of Debian's glibc do not.
    if platform.machine() == "x86_64" and "IBT, SHSTK" not in readelf("--notes", program):
        count = branch_targets(program)
        if count < branch_targets_min:
            found.append(f"{count} endbr64 instructions, expected at least {branch_targets_min}; "
                         "compile with -fcf-protection")
    return found


SAMPLE = r"""
#include <cstdio>
#include <cstring>
#include <vector>
int twice(int n) { return 2 * n; }
int thrice(int n) { return 3 * n; }
int main(int count, char** words) {
    char text[16];
    std::strcpy(text, words[0] + count);
    std::vector<int> numbers(count);
    std::printf("%s %d\n", text, numbers[count - 1]);
}
"""
HARDENED = ["-O2", "-fPIE", "-fstack-protector-strong", "-fcf-protection=full", "-U_FORTIFY_SOURCE",
            "-D_FORTIFY_SOURCE=3", "-D_GLIBCXX_ASSERTIONS", "-pie", "-Wl,-z,relro,-z,now,-z,noexecstack"]
# The flag to drop or add, and a word of the expected fault.
WITHOUT = [
    (["-fPIE", "-pie"], ["-no-pie"], "position-independent"),
    ([], ["-Wl,-z,execstack"], "stack is executable"),
    ([], ["-Wl,-z,norelro"], "GNU_RELRO"),
    ([], ["-Wl,-z,lazy"], "lazily"),
    (["-fstack-protector-strong"], ["-fno-stack-protector"], "stack protector"),
    (["-D_FORTIFY_SOURCE=3"], [], "checked library calls"),
    (["-D_GLIBCXX_ASSERTIONS"], [], "assertions of the C++ library"),
    (["-fcf-protection=full"], ["-fcf-protection=none"], "endbr64"),
]


def self_test(compiler):
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder, "sample.cpp"), pathlib.Path(folder, "sample")
        source.write_text(SAMPLE)

        def build(flags):
            subprocess.run([compiler, source, *flags, "-o", program], check=True)
            # Start-up code has up to three endbr64, the three functions of the sample one each.
            return faults(program, branch_targets_min=4)

        if found := build(HARDENED):
            return [f"a hardened program was rejected: {found[0]}"]
        wrong = []
        for dropped, added, word in WITHOUT:
            found = build([flag for flag in HARDENED if flag not in dropped] + added)
            if not any(word in fault for fault in found):
                wrong.append(f"{' '.join(added or dropped)}: no fault says {word!r}; found {found}")
        return wrong


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--self-test":
        wrong = self_test(arguments[1])
        print("\n".join(wrong) or f"{len(WITHOUT)} programs with one protection missing were rejected")
        return 1 if wrong else 0
    if not arguments or arguments[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    failed = False
    for program in arguments:
        try:
            found = faults(program)
        except (OSError, ValueError) as error:
            found = [str(error)]
        for fault in found:
            print(f"{program}: {fault}")
        failed |= bool(found)
    if not failed:
        print(f"{len(arguments)} hardened: {' '.join(os.path.basename(program) for program in arguments)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
