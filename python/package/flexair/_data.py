"""Where the data lie that come with the package: libraries of all platforms, aircraft files, licences."""

from pathlib import Path

DATA = Path(__file__).parent / "flexair-data"
