"""The command `flexair`, also as `python -m flexair`."""

import signal
import sys

from ._data import DATA
from ._native import command


def main() -> int:
    """Run the command with the arguments that the shell gives."""
    # Ctrl-C is the command's own matter: it cleans up and ends at once. Whoever has it ignored, as `nohup` does, is left alone.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    return command(["flexair", *sys.argv[1:]], DATA)


if __name__ == "__main__":
    sys.exit(main())
