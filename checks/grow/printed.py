"""Runs of the greedy algorithm as printed: variants by name, results as plain data and a table."""

import math
import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from checks.errors import BadInput
from checks.grow.bar import share_bar
from checks.grow.printed_cover import PrintedCover, cover
from checks.grow.summary import as_texts, centre, in_floats
from checks.printed.greedy_algorithm import PrintedParameters, PrintedRun, printed_run
from checks.printed.greedy_reading import VARIANTS
from checks.printed.greedy_sector import PrintedSector, inside

#: Most nodes N of an axis: every sector has N^2 of them.
MOST_NODES = 1000

#: Most nodes of all sectors together: about 3 GB.
MOST_IN_ALL = 10**8


@dataclass(frozen=True, kw_only=True, eq=False)
class PrintedResult:
    """Run under a variant, what it covers, and the seconds that it took."""

    variant: str
    exact: Any
    run: PrintedRun
    cover: PrintedCover
    seconds: float

    @property
    def terminated(self) -> bool:
        """Whether the run ends as step 25 says."""
        return self.run.end == "step 25"

    @property
    def cuts(self) -> int:
        """Number of cuts made."""
        return sum(sector.cut is not None for sector in self.run.sectors)


def require_variant(name: str) -> None:
    """Refuse an unknown variant; raises BadInput."""
    if name not in VARIANTS:
        raise BadInput(f"--as-printed {name}: expected one of {', '.join(VARIANTS)}, give one")


def printed_result(exact: Any, variant: str, *, max_cuts: int) -> PrintedResult:
    """Run the printed algorithm with the parameters, a discrete GreedyParameters, of a user."""
    parameters = PrintedParameters(
        radius=float(exact.radius),
        sectors=exact.sectors,
        cutoff=float(exact.cutoff),
        step=float(exact.step),
        nodes=math.ceil(2 * exact.radius / exact.step),
    )
    if parameters.nodes > MOST_NODES:
        raise BadInput(
            f"--as-printed: N = {parameters.nodes} nodes on each axis: expected at most "
            f"{MOST_NODES}, since every sector has N^2 of them: take a larger --step"
        )
    most = min(max_cuts, max(MOST_IN_ALL // (3 * parameters.nodes**2), 1))
    start = time.perf_counter()
    with share_bar("sectors done") as progress:
        run = printed_run(
            parameters,
            VARIANTS[variant],
            max_cuts=most,
            progress=lambda cuts, waiting: progress(cuts / (cuts + waiting)),
        )
        found = cover(run)
    return PrintedResult(
        variant=variant, exact=exact, run=run, cover=found, seconds=time.perf_counter() - start
    )


def _angles(run: PrintedRun, sector: PrintedSector) -> Any:
    """Unsigned angles at the nodes of the disk that a sector keeps."""
    near = sector.kept & inside(sector.zeta, run.parameters.radius) & np.isfinite(sector.angles)
    return np.abs(sector.angles[near])


def _branch(result: PrintedResult) -> list[dict[str, Any]]:
    radius, found = result.run.parameters.radius, centre(result.exact)
    for sector in result.run.sectors:
        if sector.cut is None:
            continue
        z = complex(*sector.zeta[:, sector.cut[0], sector.cut[1]])
        rho = 2 * math.atanh(abs(z))
        cut_angle = float(abs(sector.angles[sector.cut]))
        generation = len(sector.path.lstrip("0123456789")) + 1
        found.append(
            {"generation": generation, "path": sector.path,
             "parent": sector.path[:-1] if generation > 1 else "", "rho": rho,
             "theta": math.atan2(z.imag, z.real) % (2 * math.pi), "angle": cut_angle / 3,
             "cut_angle": cut_angle, "distance_to_rim": radius - rho}
        )  # fmt: skip
    return found


def plain(result: PrintedResult) -> dict[str, Any]:
    """Data of a run: the fields of the shipped algorithm, and variant, end, uncovered, twice."""
    exact, run, branch = result.exact, result.run, _branch(result)
    angles = np.concatenate([_angles(run, sector) for sector in run.sectors])
    low = float(angles.min()) if len(angles) else None
    high = float(angles.max()) if len(angles) else None
    curvature = None
    if low and high:
        curvature = max(math.tan(high / 2), 1 / math.tan(low / 2))
    return {
        **in_floats(exact),
        "sectors": len(run.sectors),
        "branch_points": len(branch),
        "generations": max((entry["generation"] for entry in branch), default=0),
        "min_angle": low,
        "max_angle": high,
        "max_curvature": curvature,
        "willmore": result.cover.willmore,
        "area": result.cover.area,
        "area_expected": exact.area,
        "terminated": result.terminated,
        "seconds": round(result.seconds, 6),
        "branch": branch,
        "exact": as_texts(exact),
        "variant": result.variant,
        "end": run.end,
        "uncovered": result.cover.uncovered,
        "twice": result.cover.twice,
    }


def table(data: dict[str, Any]) -> list[str]:
    """Lines for a reader, from the plain data."""
    exact, low = data["exact"], data["min_angle"]
    rows = [
        ("as printed", f"variant {data['variant']}, ended by: {data['end']}"),
        ("disk", f"radius {exact['radius']}, initial sectors of angle {exact['phi0']}"),
        ("net", f"step {exact['step']}, cutoff {exact['cutoff']}"),
        ("sectors", f"{data['sectors']}"),
        ("branch points", f"{data['branch_points']}, generations {data['generations']}"),
        ("angles", "none" if low is None else f"{low:.10g} to {data['max_angle']:.10g}"),
        ("area", f"{data['area']:.10g}, expected {data['area_expected']:.10g}"),
        ("in no quad", f"{data['uncovered']:.3%} of the disk"),
        ("in several", f"{data['twice']:.3%} of the disk"),
        ("computed in", f"{data['seconds']:.3g} s"),
    ]
    width = max(len(name) for name, _ in rows)
    return [f"{name:<{width}}  {text}" for name, text in rows]
