"""Claims, checks and the registry refuse what contradicts itself."""

import pytest
from planted import check, claim

from checks.claim import Check, Citation, Claim, Mutant, Waiver
from checks.evidence import Evidence
from checks.registry import Registry


def test_a_check_without_mutant_is_refused():
    with pytest.raises(ValueError, match="it could not fail"):
        Check(name="x", run="m:f", routes=("a",), mutants=())


def test_a_mutant_that_changes_nothing_is_refused():
    with pytest.raises(ValueError, match="changes nothing"):
        Mutant(name="x", given={})


def test_a_printed_check_may_not_change_the_printed_formula():
    with pytest.raises(ValueError, match="changes the printed formula"):
        check("sound", given={"factor": 2})


def test_a_cited_theorem_needs_a_search():
    fields = {"id": "x", "section": "2", "where": "w", "statement": "s"}
    source = Citation(source="Hilbert 1901", reason="analysis")
    with pytest.raises(ValueError, match="needs a stored search"):
        Claim(kind="theorem", citation=source, **fields)
    assert Claim(kind="sentence", citation=source, **fields).citation is source


def test_a_cited_claim_has_no_deciding_check():
    with pytest.raises(ValueError, match="decides a form"):
        claim("x", "sound", citation=Citation(source="s", reason="r"))


def test_evidence_without_samples_is_no_pass():
    with pytest.raises(ValueError, match="undecided, not pass"):
        Evidence(outcome="pass", grade="numeric", tried=5, met=0)
    with pytest.raises(ValueError, match="witness"):
        Evidence(outcome="fail", grade="exact")


def test_unknown_ids_are_refused():
    with pytest.raises(ValueError, match="unknown ids: nowhere"):
        Registry(claims=(claim("a", rests_on=("nowhere",)),))


def test_cycles_are_refused():
    circle = (claim("a", rests_on=("b",)), claim("b", rests_on=("a",)))
    with pytest.raises(ValueError, match="rest on each other"):
        Registry(claims=circle)


def test_repeated_ids_and_labels_are_refused():
    with pytest.raises(ValueError, match="'a' is given twice"):
        Registry(claims=(claim("a"), claim("a")))
    with pytest.raises(ValueError, match="label 'l' is given twice"):
        Registry(claims=(claim("a", labels=("l",)),), waived=(Waiver(label="l", reason="r"),))


def test_ancestors_and_descendants_are_transitive_and_in_order():
    three = Registry(claims=(claim("a", rests_on=("b",)), claim("b", rests_on=("c",)), claim("c")))
    assert three.ancestors["a"] == ("b", "c")
    assert three.descendants["c"] == ("a", "b")
