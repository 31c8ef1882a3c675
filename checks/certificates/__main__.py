"""Check a certificate of the greedy algorithm: `python -m checks.certificates FILE`.

The file is what `kminusone grow --certified --json FILE` writes. Exit code: 0 sound, 1 refuted,
2 no certificate, 4 undecided.
"""

import json
import sys
from pathlib import Path

from checks.certificates.greedy import verdict
from checks.certificates.greedy_format import MalformedError, certificate

USAGE = "usage: python -m checks.certificates FILE, as written by kminusone grow --certified\n"


def main(arguments: list[str]) -> int:
    """Print the verdict on the certificate in a file and return the exit code."""
    if len(arguments) != 1:
        sys.stderr.write(USAGE)
        return 2
    try:
        data = json.loads(Path(arguments[0]).read_text(encoding="utf-8"))
        found = certificate(data.get("certificate", data) if isinstance(data, dict) else data)
    except (OSError, ValueError, RecursionError) as error:
        kind = "" if isinstance(error, MalformedError) else "cannot be read: "
        sys.stderr.write(f"{arguments[0]}: {kind}{' '.join(str(error).split())}\n")
        return 2
    said = verdict(found)
    if said.wrong:
        sys.stdout.write(f"refuted: {said.wrong}\n")
        return 1
    if said.open:
        sys.stdout.write(f"undecided: {said.open}\n")
        return 4
    sys.stdout.write(f"sound: {said.quads} quads checked with {said.bits} bits\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
