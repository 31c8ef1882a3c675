"""Picture of a net in the Poincare disk, coloured by curvature, with its branch points."""

from importlib.util import find_spec
from pathlib import Path
from typing import Any, cast

import numpy as np

from checks.errors import BadInput
from checks.files import replacing
from checks.meshes.write import require_format

PICTURES = ("png", "svg")

#: Pixels to an inch.
DPI = 160


def require_picture(name: str) -> str:
    """Extension of a picture; raises BadInput for another one, or without matplotlib."""
    kind = require_format(name, PICTURES)
    if find_spec("matplotlib") is None:
        raise BadInput(
            "cannot draw a picture without matplotlib: install it, pip install 'kminusone[figures]'"
        )
    return kind


def write_picture(name: str, tree: Any, net: Any) -> None:
    """Draw a run and its net: quads by max curvature, branch points by generation, dashed rim.

    Raises BadInput where matplotlib is missing or the file cannot be written.
    """
    kind = require_picture(name)
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.4, 7), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    _draw(axes, figure, tree, net)
    try:
        with replacing(Path(name).resolve()) as stream:
            figure.savefig(stream, format=kind, dpi=DPI)
    except OSError as error:
        raise BadInput(f"cannot write {name}: {error.strerror or error}") from error


def _draw(axes: Any, figure: Any, tree: Any, net: Any) -> None:
    from matplotlib.collections import PolyCollection

    corners = net.disk[net.quads]
    half = net.quad_angles / 2
    curvature = np.log10(np.maximum(np.tan(half), 1 / np.tan(half)))
    quads = PolyCollection(
        cast("Any", np.stack([corners.real, corners.imag], axis=-1)),
        array=curvature,
        cmap="magma_r",
        edgecolors="face",
        linewidths=0.1,
        rasterized=True,
    )
    axes.add_collection(quads)
    rim = np.tanh(float(net.parameters.radius) / 2) * np.exp(1j * np.linspace(0, 2 * np.pi, 721))
    axes.plot(rim.real, rim.imag, "k--", linewidth=0.8)
    _draw_branch_points(axes, tree)
    run = net.parameters
    axes.set_title(
        f"R = {run.radius}, phi0 = {run.phi0}, cutoff {run.cutoff}, edges {run.step}\n"
        f"{tree.branch_point_count} branch points, max curvature {tree.max_curvature:.4g}",
        fontsize=10,
    )
    limit = 1.02 * float(np.abs(corners).max())
    axes.set(xlim=(-limit, limit), ylim=(-limit, limit), aspect="equal")
    axes.set_axis_off()
    bar = figure.colorbar(quads, ax=axes, shrink=0.8)
    bar.set_label("log10 of the max curvature")


def _draw_branch_points(axes: Any, tree: Any) -> None:
    """Branch points, with lines to their parents; the centre is the root."""
    points = list(tree.branch_points())
    where = {p.path: np.tanh(p.rho / 2) * np.exp(1j * p.theta) for p in points}
    where[""] = 0j
    for point in points:
        ends = np.array([where[point.parent], where[point.path]])
        axes.plot(ends.real, ends.imag, color="tab:cyan", linewidth=0.7)
    for generation in range(1, tree.generations + 1):
        z = np.array([where[p.path] for p in points if p.generation == generation])
        size = 22 / generation
        axes.scatter(
            z.real, z.imag, s=size, color="tab:cyan", edgecolors="k", linewidths=0.3, zorder=3
        )
