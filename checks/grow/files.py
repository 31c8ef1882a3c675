"""Files asked of a run: its data, the net and a picture, found possible before it and made after.

The JSON is written first, so that a net which fails at last does not take it along.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from checks.errors import BadInput, Interrupted
from checks.output import STDOUT, require_writable, write_long_json

#: Most vertices of a net that is built: about 5 GB of arrays.
MOST_VERTICES = 2 * 10**7


@dataclass(frozen=True, kw_only=True)
class Files:
    """Names of the files wanted; None for each that is not."""

    json: str | None
    net: str | None
    picture: str | None

    @property
    def names(self) -> list[str]:
        """Names in the order of writing."""
        return [name for name in (self.json, self.net, self.picture) if name is not None]

    def require_possible(self) -> None:
        """Refuse what could not be written at the end; raises BadInput."""
        if self.net is not None:
            from checks.meshes.write import require_format

            require_format(self.net)
        if self.picture is not None:
            from checks.meshes.picture import require_picture

            require_picture(self.picture)
        for name in self.names:
            require_writable(name)
        places = [Path(name).resolve() for name in self.names if name != STDOUT]
        if len(set(places)) < len(places):
            raise BadInput("two results cannot go to one file: expected different names, give them")

    def require_feasible(self, run: Any) -> None:
        """Refuse a net of too many vertices, by the area of the disk; raises BadInput."""
        if self.net is not None or self.picture is not None:
            step = float(run.step)
            # A net has more vertices than quads, and no quad is larger than that of right angles.
            _require_few(run, run.area / (4 * math.asin(math.tanh(step / 2) ** 2)))

    def write(self, tree: Any, data: dict[str, Any]) -> None:
        """Write all of them, each whole or not at all; raises BadInput and Interrupted."""
        if self.net is not None or self.picture is not None:
            quads = tree.sectors["quads"] * tree.sectors["copies"]
            _require_few(tree.parameters, float(quads.sum()))
        written: list[str] = []
        writers: list[tuple[str | None, Callable[[str], None]]] = [
            (self.json, lambda name: write_long_json(name, data)),
            (self.net, lambda name: _write_net(name, tree)),
            (self.picture, lambda name: _write_picture(name, tree)),
        ]
        try:
            for name, write in writers:
                if name is not None:
                    write(name)
                    written.append("stdout" if name == STDOUT else name)
        except KeyboardInterrupt:
            if not written:
                raise
            raise Interrupted(f"interrupted; written whole: {', '.join(written)}") from None


def _require_few(run: Any, vertices: float) -> None:
    if vertices <= MOST_VERTICES:
        return
    # Large disks have 2.3 vertices to each square of the step, which are quads of small angles.
    radius = math.acosh(1 + float(run.step) ** 2 * MOST_VERTICES / (2 * math.pi * 2.3))
    raise BadInput(
        f"the net would have more than {vertices:.2g} vertices: expected at most "
        f"{MOST_VERTICES:.0e}: take a larger --step, a --radius of at most {radius:.1f} at this "
        "step, or leave out --out and --picture"
    )


def _write_net(name: str, tree: Any) -> None:
    from checks.meshes.write import write_mesh
    from discrete.greedy_net import greedy_net

    write_mesh(name, greedy_net(tree))


def _write_picture(name: str, tree: Any) -> None:
    from checks.meshes.picture import write_picture
    from discrete.greedy_net import greedy_net

    write_picture(name, tree, greedy_net(tree))
