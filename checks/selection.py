"""Which claims a run is about: ids, globs, sections, tiers."""

from collections.abc import Sequence
from difflib import get_close_matches
from fnmatch import fnmatchcase

from checks.claim import SECTIONS, Check, Claim, Tier
from checks.errors import BadInput
from checks.registry import Registry

_GLOB = frozenset("*?[")


def _matching(registry: Registry, pattern: str) -> set[str]:
    if pattern in registry.by_id:
        return {pattern}
    covering = {claim.id for claim in registry.claims if pattern in claim.labels}
    if covering:
        return covering
    found = {id_ for id_ in registry.by_id if fnmatchcase(id_, pattern)}
    if found:
        return found
    if _GLOB & set(pattern):
        raise BadInput(f"no claim matches {pattern!r}: `kminusone claims` lists them")
    known = [*registry.by_id, *(label for claim in registry.claims for label in claim.labels)]
    close = get_close_matches(pattern, known, n=4, cutoff=0.5)
    hint = f"did you mean {', '.join(close)}?" if close else "`kminusone claims` lists them"
    raise BadInput(f"unknown claim {pattern!r}: {hint}")


def in_section(claim: Claim, section: str) -> bool:
    """Whether the claim stands in the section or in one of its subsections."""
    return claim.section == section or claim.section.startswith(f"{section}.")


def select(
    registry: Registry, patterns: Sequence[str] = (), *, section: str | None = None
) -> tuple[Claim, ...]:
    """Claims whose id or label is among the patterns, in the paper's order; all if none is given.

    Raises BadInput for a pattern that matches nothing or an unknown section.
    """
    if section is not None and section not in SECTIONS:
        raise BadInput(f"unknown section {section!r}: expected one of {', '.join(SECTIONS)}")
    wanted = set[str]().union(*(_matching(registry, pattern) for pattern in patterns))
    return tuple(
        claim
        for claim in registry.claims
        if (not patterns or claim.id in wanted) and (section is None or in_section(claim, section))
    )


def runs_in(check: Check, tier: Tier) -> bool:
    """Whether the check belongs to the tier: full contains fast."""
    return tier == "full" or check.tier == "fast"
