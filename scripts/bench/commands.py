"""Other programs, run from the project's top folder."""
import shlex
import subprocess
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]


class BenchError(Exception):
    """One sentence for the user."""


def run(command, what, text=None, seconds=None):
    """The command's output; `text` is its input. `what` begins the sentence that says that it failed."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, input=text, capture_output=True, text=True, cwd=PROJECT, timeout=seconds)
    except subprocess.TimeoutExpired as error:
        raise BenchError(f"{what}: '{shlex.join(words)}' was still running after {seconds} seconds.") from error
    except OSError as error:
        raise BenchError(f"{what}: '{words[0]}' cannot be run: {error.strerror}.") from error
    if done.returncode != 0:
        raise BenchError(f"{what}: '{shlex.join(words)}' ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout
