"""A ledger as a JUnit report: a suite for each section, a case for each check."""

import re
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any
from xml.etree import ElementTree as Xml

# XML 1.0 has no way to write the other characters.
_ILLEGAL = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def _legal(text: str) -> str:
    return _ILLEGAL.sub("?", text)


def _case(
    claim: Mapping[str, Any], check: Mapping[str, Any], troubles: Sequence[str]
) -> Xml.Element:
    """Case of a check: it fails when it differs from its pin or is broken, whatever its outcome."""
    case = Xml.Element("testcase", classname=claim["id"], name=check["name"])
    if check["outcome"] == "not_run":
        Xml.SubElement(case, "skipped", message="not in the tier that ran")
    elif check["outcome"] == "error":
        Xml.SubElement(case, "error", message=_legal(check["error"]))
    elif troubles:
        Xml.SubElement(case, "failure", message=_legal("; ".join(troubles)))
    return case


def junit(ledger: Mapping[str, Any], problems: Sequence[str]) -> str:
    """XML text of the report; problems: lines that begin `claim / check:`."""
    root = Xml.Element("testsuites", name="kminusone")
    for section, group in groupby(ledger["claims"], key=lambda claim: claim["section"]):
        cases = [
            _case(
                claim,
                check,
                [p for p in problems if p.startswith(f"{claim['id']} / {check['name']}:")],
            )
            for claim in group
            for check in claim["checks"]
        ]
        if not cases:
            continue
        found = [child.tag for case in cases for child in case]
        suite = Xml.SubElement(
            root,
            "testsuite",
            name=f"section {section}",
            tests=str(len(cases)),
            failures=str(found.count("failure")),
            errors=str(found.count("error")),
            skipped=str(found.count("skipped")),
        )
        suite.extend(cases)
    Xml.indent(root)
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n' + Xml.tostring(root, encoding="unicode") + "\n"
    )
