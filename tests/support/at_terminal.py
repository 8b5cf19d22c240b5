"""at_terminal.py PROGRAM ARGUMENT ...: runs it at a terminal of its own, types the lines of stdin one after the other,
each when it is asked for, and then ends the input. Prints what the terminal showed, ends as the program did."""

import os
import pty
import select
import sys

lines = sys.stdin.read().splitlines(keepends=True)
child, terminal = pty.fork()
if child == 0:
    os.execvp(sys.argv[1], sys.argv[1:])
shown = b""
ends = 0
while True:
    ready, _, _ = select.select([terminal], [], [], 20)
    if not ready:
        break
    try:
        said = os.read(terminal, 4096)
    except OSError:  # the program has ended
        break
    if not said:
        break
    shown += said
    if shown.endswith(b": "):
        if lines:
            os.write(terminal, lines.pop(0).encode())
        elif ends < 2:
            os.write(terminal, b"\x04")
            ends += 1
sys.stdout.write(shown.decode(errors="replace").replace("\r\n", "\n"))
sys.stdout.flush()
os._exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
