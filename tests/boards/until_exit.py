#!/usr/bin/env python3
"""Runs an emulator whose image prints on a serial line and never leaves by itself: passes its lines on until one is "exit <status>",
which becomes the status.

usage: until_exit.py COMMAND...
"""
import re
import subprocess
import sys
import threading

PATIENCE_S = 120


def main() -> int:
    process = subprocess.Popen(sys.argv[1:], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    patience = threading.Timer(PATIENCE_S, process.kill)
    patience.start()
    try:
        for line in process.stdout:
            end = re.fullmatch(r"exit (\d+)\n", line)
            if end:
                return int(end[1])
            print(line, end="")
        print(f"The image did not end within {PATIENCE_S} s.", file=sys.stderr)
        return 1
    finally:
        patience.cancel()
        process.kill()
        process.wait()


if __name__ == "__main__":
    sys.exit(main())
