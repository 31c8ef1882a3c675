"""Pins: the expected outcome and grade of every check, in one reviewed file."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from checks.claim import Claim
from checks.errors import BadInput
from checks.evidence import Grade
from checks.registry import Registry
from checks.verdict import Result, Verdict, verdict

FILE = Path(__file__).resolve().parent / "pins.json"

Pins = Mapping[str, Mapping[str, Result]]


def read_pins(path: Path = FILE) -> dict[str, dict[str, Result]]:
    """Return the pins by claim and check; none where the file is missing."""
    if not path.is_file():
        return {}
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        return {
            claim: {check: Result(outcome=pin[0], grade=pin[1]) for check, pin in checks.items()}
            for claim, checks in data.items()
        }
    except (ValueError, AttributeError, TypeError, LookupError) as error:
        raise BadInput(f"{path} holds no pins: restore it or run `kminusone pin`") from error


def as_plain(pins: Pins, registry: Registry) -> dict[str, Any]:
    """Pins as JSON data, in the paper's order, without what the catalogue no longer has."""
    return {
        claim.id: {
            check.name: [pins[claim.id][check.name].outcome, pins[claim.id][check.name].grade]
            for check in claim.checks
            if check.name in pins[claim.id]
        }
        for claim in registry.claims
        if claim.id in pins and claim.checks
    }


def expected(claim: Claim, pins: Pins) -> tuple[Verdict, Grade | None] | None:
    """Verdict and grade that the pins imply, None where a check of the claim has no pin."""
    pinned = pins.get(claim.id, {})
    if any(check.name not in pinned for check in claim.checks):
        return None
    return verdict(claim, pinned)


def text(pin: Result | None) -> str:
    """Return a pin in words."""
    return "not pinned" if pin is None else f"{pin.outcome} ({pin.grade or 'no grade'})"


def differences(ran: Pins, pins: Pins) -> list[str]:
    """One line for each check that ran and whose outcome or grade is not the pinned one."""
    lines = []
    for claim, checks in ran.items():
        for check, result in checks.items():
            pin = pins.get(claim, {}).get(check)
            if pin != result:
                lines.append(f"{claim} / {check}: pinned {text(pin)}, came out {text(result)}")
    return lines
