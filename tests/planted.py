"""Checks planted by the tests: sound, vacuous, broken in every way that a child can break."""

import os
import signal
import sys
import threading
import time

from checks.claim import Check, Claim, Mutant
from checks.evidence import Evidence, Setting


def sound(setting: Setting, *, factor: int = 2) -> Evidence:
    if factor == 2:
        return Evidence(outcome="pass", grade="exact", residual="0")
    return Evidence(outcome="fail", grade="exact", witness=f"1 + 1 is not {factor}")


def vacuous(setting: Setting, *, factor: int = 2) -> Evidence:
    return Evidence(outcome="pass", grade="exact", residual="0")


def measured(setting: Setting, *, factor: int = 2) -> Evidence:
    return Evidence(outcome="pass" if factor == 2 else "fail", grade="experiment", witness="x")


def raising(setting: Setting, *, factor: int = 2) -> Evidence:
    raise ArithmeticError("planted")


def wrong_type(setting: Setting, *, factor: int = 2) -> str:
    return "pass"


def killed(setting: Setting, *, factor: int = 2) -> Evidence:
    os.kill(os.getpid(), signal.SIGKILL)
    return sound(setting)


def exiting(setting: Setting, *, factor: int = 2) -> Evidence:
    os._exit(7)


def slow(setting: Setting, *, factor: int = 2) -> Evidence:
    time.sleep(60)
    return sound(setting)


def undecided(setting: Setting, *, factor: int = 2) -> Evidence:
    if factor == 2:
        return Evidence(outcome="undecided", grade="exact")
    return sound(setting, factor=factor)


def printing(setting: Setting, *, factor: int = 2) -> Evidence:
    sys.stdout.write("noise\n")
    return sound(setting, factor=factor)


def leaving_a_thread(setting: Setting, *, factor: int = 2) -> Evidence:
    threading.Thread(target=time.sleep, args=(60,)).start()
    return sound(setting, factor=factor)


def leaving_the_process(setting: Setting, *, factor: int = 2) -> Evidence:
    raise SystemExit("planted exit")


def drawn(setting: Setting, *, factor: int = 2) -> Evidence:
    number = setting.random().random()
    return Evidence(
        outcome="pass" if factor == 2 else "fail",
        grade="exact",
        shown=f"drew {number}",
        witness="x",
    )


def check(name: str, *, form: str = "printed", near: bool = False, **fields: object) -> Check:
    return Check(
        name=name,
        run=f"planted:{name}",
        form=form,
        routes=("planted",),
        mutants=(Mutant(name="factor", given={"factor": 3}, near=near),),
        **fields,
    )


def claim(id_: str, *names: str, **fields: object) -> Claim:
    return Claim(
        id=id_,
        section="1",
        where="planted",
        kind="sentence",
        statement="planted",
        checks=tuple(check(name) for name in names),
        **fields,
    )
