#!/usr/bin/env python3
"""Lets clang-tidy read every source of src and generators: .ci/read.py alone|tidy

tidy:  all checks, over the batches that the build compiles (CMAKE_UNITY_BUILD): nine tenths of its time go into other
       people's headers, which a batch reads once. A batch is called UnifiedSource, by which clang's analyser knows one. Of 90
       checks that made-up faults set off, all say the same of a batch as of its files one by one, but the two below.
alone: each file of a batch, and each header that no source includes first, by itself and without precompiled headers (every
       file includes what it uses, and leans on no neighbour), with the checks that look at the main file alone.

Trees of commands: .build/alone, .build/batches. What was read without a finding is read again when it, a header that it
includes, its command, the rules, the tool or a library have changed; that is kept for every clone in $OVERTURN_READ."""

import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / ".build" / "read"
SOUND = pathlib.Path(os.environ.get("OVERTURN_READ", WORK))  # a file for each text that was read without a finding
OF_MAIN_FILES = "-*,clang-diagnostic-*,misc-unused-using-decls,misc-unused-alias-decls"
SHALLOW = [f"--extra-arg={word}" for word in ("-Xclang", "-analyzer-config", "-Xclang", "mode=shallow")]  # the same findings so far
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
HEADERS = "_verify_interface_header_sets/"  # a file for each header, made by CMake


def commands(tree):
    """What the build compiles of src and generators, alone or in batches, and the lone headers: by path."""
    sources, headers = {}, {}
    for entry in json.loads((ROOT / ".build" / tree / "compile_commands.json").read_text()):
        path = entry["file"]
        if path.startswith((f"{ROOT}/src/", f"{ROOT}/generators/")) or ("/Unity/" in path and "precompiled" not in path):
            sources[path] = entry
        elif HEADERS in path:
            headers[path] = entry
    if not sources or not headers:
        sys.exit(f"read: .build/{tree} holds no commands to read by. Configure it as .ci/run does")
    return sources, headers


@functools.cache
def included(path):
    """The project's own files that one includes."""
    found = set()
    for name in INCLUDE.findall(pathlib.Path(path).read_text()):
        for folder in ("", ROOT / "src", ROOT, pathlib.Path(path).parent):
            file = os.path.join(folder, name)
            if os.path.isabs(file) and os.path.isfile(file):
                found.add(os.path.normpath(file))
                break
    return found


def made_of(path):
    """A source with all of the project's own that it includes, directly or not."""
    files, open_ones = {path}, [path]
    while open_ones:
        new = included(open_ones.pop()) - files
        files |= new
        open_ones += new
    return sorted(files)


def key(path, words):
    """Stands for all that a finding hangs on."""
    def anywhere(text):
        return text.replace(f"{ROOT}/", "").encode()

    digest = hashlib.sha256(anywhere("\n".join(words)))
    for name in made_of(path):
        digest.update(anywhere(f"\n{name}\n{pathlib.Path(name).read_text()}"))
    return digest.hexdigest()[:32]


def batch_of(entry, name):
    """The command of a batch under the name that the analyser knows."""
    batch = WORK / f"UnifiedSource-{name}.cpp"
    lines = [f'#include "{file}"  // NOLINT(bugprone-suspicious-include)\n' for file in INCLUDE.findall(pathlib.Path(entry["file"]).read_text())]
    batch.write_text("".join(lines))
    return {**entry, "file": str(batch), "command": entry["command"].replace(entry["file"], str(batch))}


def to_be_read(what):
    """The commands, long ones first."""
    batches, _ = commands("batches")
    if what == "tidy":
        return [batch_of(entry, str(number)) if "/Unity/" in path else entry
                for number, (path, entry) in enumerate(sorted(batches.items(), key=lambda item: "/Unity/" not in item[0]))]
    sources, headers = commands("alone")
    first = {found[1] for path in sources if (found := INCLUDE.search(pathlib.Path(path).read_text()))}
    return ([entry for path, entry in sources.items() if path not in batches]
            + [entry for path, entry in headers.items() if path.partition(HEADERS)[2].removesuffix(".cxx") not in first])


def main(what):
    for folder in (WORK, SOUND):
        folder.mkdir(parents=True, exist_ok=True)
    entries = to_be_read(what)
    folder = WORK / what
    folder.mkdir(exist_ok=True)
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    command = ["clang-tidy", "--quiet", "-p", str(folder), *([f"--checks={OF_MAIN_FILES}"] if what == "alone" else SHALLOW)]
    version = subprocess.run(["clang-tidy", "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
    libraries = subprocess.run(["dpkg-query", "-W", "*-dev"], stdout=subprocess.PIPE, text=True).stdout
    words = [version, libraries, (ROOT / ".clang-tidy").read_text(), *command]

    known = []

    def read(entry):
        sound = SOUND / key(entry["file"], [*words, entry["command"]])
        if sound.exists():
            known.append(entry)
            return None
        ended = subprocess.run([*command, entry["file"]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if ended.returncode == 0:
            sound.touch()
            return None
        return "\n".join(line for line in ended.stdout.splitlines() if not re.search(r"warnings? (generated|treated)", line))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        findings = [found for found in workers.map(read, entries) if found]
    print("\n".join(findings), file=sys.stderr)
    print(f"{what}: {len(entries)} readings, {len(known)} of them known to be sound, {len(findings)} with findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
