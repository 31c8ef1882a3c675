"""A claim of the paper and the checks, mutants, erratum and citation that belong to it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal, get_args

Kind = Literal[
    "abstract", "algorithm", "definition", "equation", "example", "figure", "item",
    "lemma", "number", "proposition", "remark", "sentence", "theorem",
]  # fmt: skip
Form = Literal["printed", "corrected", "support"]
Tier = Literal["fast", "full"]
ErratumClass = Literal["false", "constant", "hypothesis", "ambiguous", "misprint"]
Value = int | str | bool
Parameters = Mapping[str, Value]

SECTIONS = ("abstract", "1", "2", "3", "3.1", "3.2", "3.3", "3.4", "3.5",
            "4", "4.1", "5", "5.1", "6", "A")  # fmt: skip


def _frozen(parameters: Parameters) -> Parameters:
    return MappingProxyType(dict(parameters))


def _require(condition: bool, message: str) -> None:
    if not condition:
        raise ValueError(message)


@dataclass(frozen=True, kw_only=True)
class Mutant:
    """One thing changed in the formula that a check tests; a sound check fails on it.

    given: the keyword arguments of the check's function that differ from those of the check;
    near: the change is slight (1 % of a constant, 0.1 of an exponent, 1 of an index).
    """

    name: str
    given: Parameters
    near: bool = False

    def __post_init__(self) -> None:
        _require(bool(self.given), f"mutant {self.name!r} changes nothing: give it a parameter")
        object.__setattr__(self, "given", _frozen(self.given))


@dataclass(frozen=True, kw_only=True)
class Check:
    """How one form of a claim is tested: a function, what it is given, its routes and mutants.

    name: unique within its claim; run: `module:function`, imported only when it runs, called as
    `function(setting, **given)`, its defaults being the printed formula; given: what differs from
    the printed formula, so it is empty where form is `printed`; part: which part of a claim in
    several parts it tests; routes: the independent computations that it compares.
    """

    name: str
    run: str
    routes: tuple[str, ...]
    mutants: tuple[Mutant, ...]
    form: Form = "printed"
    given: Parameters = field(default_factory=dict)
    part: str = ""
    tier: Tier = "fast"

    def __post_init__(self) -> None:
        _require(self.run.count(":") == 1, f"check {self.name!r}: run must be module:function")
        _require(bool(self.routes), f"check {self.name!r} names no route")
        _require(bool(self.mutants), f"check {self.name!r} has no mutant: it could not fail")
        _require(
            self.form != "printed" or not self.given,
            f"check {self.name!r} calls itself printed but changes the printed formula",
        )
        _require(
            self.form in get_args(Form) and self.tier in get_args(Tier),
            f"check {self.name!r}: unknown form {self.form!r} or tier {self.tier!r}",
        )
        tuples = type(self.routes) is tuple and type(self.mutants) is tuple
        _require(tuples, f"check {self.name!r}: routes and mutants must be tuples")
        names = [mutant.name for mutant in self.mutants]
        _require(len(set(names)) == len(names), f"check {self.name!r} repeats a mutant's name")
        object.__setattr__(self, "given", _frozen(self.given))


@dataclass(frozen=True, kw_only=True)
class Erratum:
    """What is wrong with a printed statement, put so that a reader can verify it by hand."""

    printed: str
    corrected: str
    kind: ErratumClass
    witness: str
    conclusion_survives: bool
    remark: str = ""

    def __post_init__(self) -> None:
        told = self.printed.strip() and self.corrected.strip() and self.witness.strip()
        _require(bool(told), "an erratum needs a printed form, a corrected one and a witness")
        _require(self.kind in get_args(ErratumClass), f"unknown class of erratum {self.kind!r}")


@dataclass(frozen=True, kw_only=True)
class Citation:
    """Why a claim is left to the literature: the source, and the reason no computation decides it.

    search: name of the support check that looked for a counterexample (required of theorems).
    """

    source: str
    reason: str
    search: str = ""


@dataclass(frozen=True, kw_only=True)
class Claim:
    r"""One statement of the paper.

    id: the paper's label, or a permanent id of ours; where: the place in the paper, in words;
    statement: LaTeX formulas, words of our own; labels: the paper's labels that it covers;
    rests_on: ids of the claims used; waits_for: sections whose checks decide it later.
    Raises ValueError where a field contradicts another.
    """

    id: str
    section: str
    where: str
    kind: Kind
    statement: str
    labels: tuple[str, ...] = ()
    hypotheses: tuple[str, ...] = ()
    rests_on: tuple[str, ...] = ()
    checks: tuple[Check, ...] = ()
    erratum: Erratum | None = None
    citation: Citation | None = None
    waits_for: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        _require(self.section in SECTIONS, f"claim {self.id!r}: unknown section {self.section!r}")
        _require(self.kind in get_args(Kind), f"claim {self.id!r}: unknown kind {self.kind!r}")
        _require(bool(self.id.strip()), "a claim needs an id")
        _require(set(self.waits_for) <= set(SECTIONS), f"claim {self.id!r}: unknown waits_for")
        _require(bool(self.statement.strip()), f"claim {self.id!r} states nothing")
        for name in ("labels", "hypotheses", "rests_on", "checks", "waits_for"):
            sort = type(getattr(self, name)).__name__
            _require(sort == "tuple", f"claim {self.id!r}: {name} must be a tuple, not a {sort}")
        names = [check.name for check in self.checks]
        _require(len(set(names)) == len(names), f"claim {self.id!r} repeats a check's name")
        _require(self.id not in self.rests_on, f"claim {self.id!r} rests on itself")
        self._check_citation(names)

    def _check_citation(self, names: list[str]) -> None:
        if self.citation is None:
            return
        _require(
            all(check.form == "support" for check in self.checks),
            f"claim {self.id!r} is cited, yet one of its checks decides a form of it",
        )
        needs_search = self.kind in ("lemma", "proposition", "theorem")
        _require(
            not needs_search or self.citation.search in names,
            f"claim {self.id!r} is a cited {self.kind}: it needs a stored search",
        )


@dataclass(frozen=True, kw_only=True)
class Waiver:
    """A label of the paper that states nothing, with the reason."""

    label: str
    reason: str
