"""The registry: every claim of the catalogue, in the paper's order, joined and validated."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from graphlib import CycleError, TopologicalSorter

from checks.catalogue import (
    abstract,
    amsler,
    amsler_boundary,
    amsler_patches,
    amsler_recursion_lemma,
    amsler_recursion_proof,
    amsler_scaling,
    approximability,
    assembly,
    asymptotic_complexes,
    asymptotic_coordinates,
    balanced_curvature,
    bobbin_coordinates,
    bobbin_front,
    bobbin_lemma,
    bobbin_metric,
    bobbin_orbit,
    bounded_distortion,
    branch_tree,
    branched_scaling,
    branched_sine_gordon,
    branched_surfaces,
    concentration,
    curvature_energy,
    cut_scaling,
    discrete_assembly,
    discrete_surfaces,
    discrete_surgery,
    discussion,
    discussion_conjecture,
    dual_vectors,
    elasticity,
    forms_and_moutard,
    frenet_frames,
    fronts,
    greedy,
    greedy_cuts,
    greedy_daughters,
    greedy_dual,
    greedy_dual_comparison,
    greedy_dual_result,
    greedy_dual_stages,
    greedy_start,
    hamburger_polygons,
    hazzidakis,
    hyperbolic_examples,
    hyperbolic_nets,
    immersion_theorems,
    inserted_sectors,
    introduction,
    invariant_angle,
    isometries,
    lelieuvre_consistency,
    linearised_painleve,
    m_stars,
    matched_painleve,
    monkey_saddle,
    normal_map,
    oriented_normal,
    painleve_crossing,
    painleve_regimes,
    pendulum,
    pendulum_amplitude,
    periodic_amsler_energy,
    plate_limits,
    plates,
    poincare_disk,
    poincare_rhombus,
    recursion,
    recursion_angles,
    reversals,
    saddle_orders,
    sector_coordinates,
    smooth_scaling,
    spherical_nets,
    spherical_quads,
    star_concentration,
    star_coordinates,
    surgery,
    symmetries,
    thin_strips,
    topological_theorem,
    waived,
    zero_curvature,
)
from checks.claim import Claim, Waiver

_ROOMS = (
    abstract,
    introduction,
    elasticity,
    plates,
    plate_limits,
    isometries,
    immersion_theorems,
    branched_surfaces,
    asymptotic_coordinates,
    frenet_frames,
    lelieuvre_consistency,
    symmetries,
    oriented_normal,
    invariant_angle,
    forms_and_moutard,
    zero_curvature,
    fronts,
    bobbin_metric,
    bobbin_coordinates,
    bobbin_lemma,
    bobbin_orbit,
    bobbin_front,
    amsler,
    m_stars,
    star_coordinates,
    dual_vectors,
    sector_coordinates,
    amsler_boundary,
    amsler_patches,
    monkey_saddle,
    assembly,
    saddle_orders,
    asymptotic_complexes,
    normal_map,
    bounded_distortion,
    topological_theorem,
    approximability,
    surgery,
    inserted_sectors,
    hazzidakis,
    hamburger_polygons,
    concentration,
    thin_strips,
    star_concentration,
    branched_sine_gordon,
    balanced_curvature,
    discrete_surfaces,
    spherical_quads,
    spherical_nets,
    discrete_assembly,
    discrete_surgery,
    poincare_disk,
    poincare_rhombus,
    hyperbolic_nets,
    hyperbolic_examples,
    reversals,
    greedy,
    greedy_start,
    greedy_cuts,
    greedy_daughters,
    greedy_dual,
    greedy_dual_stages,
    greedy_dual_comparison,
    greedy_dual_result,
    curvature_energy,
    smooth_scaling,
    periodic_amsler_energy,
    branched_scaling,
    recursion,
    recursion_angles,
    amsler_recursion_lemma,
    amsler_recursion_proof,
    amsler_scaling,
    branch_tree,
    cut_scaling,
    discussion,
    discussion_conjecture,
    linearised_painleve,
    pendulum,
    pendulum_amplitude,
    matched_painleve,
    painleve_regimes,
    painleve_crossing,
)


@dataclass(frozen=True, kw_only=True)
class Registry:
    """Claims in the paper's order and the labels waived; unknown ids and cycles are refused.

    Raises ValueError for an id or label given twice, an unknown id in rests_on, or a cycle.
    """

    claims: tuple[Claim, ...]
    waived: tuple[Waiver, ...] = ()

    def __post_init__(self) -> None:
        _refuse_repeats("id", (claim.id for claim in self.claims))
        labels = [label for claim in self.claims for label in claim.labels]
        _refuse_repeats("label", labels + [waiver.label for waiver in self.waived])
        for claim in self.claims:
            if unknown := sorted(set(claim.rests_on) - self.by_id.keys()):
                raise ValueError(f"claim {claim.id!r} rests on unknown ids: {', '.join(unknown)}")
        try:
            TopologicalSorter({c.id: c.rests_on for c in self.claims}).prepare()
        except CycleError as error:
            raise ValueError(
                f"the claims rest on each other: {' < '.join(error.args[1])}"
            ) from error

    @cached_property
    def by_id(self) -> dict[str, Claim]:
        """Claims by id."""
        return {claim.id: claim for claim in self.claims}

    @cached_property
    def ancestors(self) -> dict[str, tuple[str, ...]]:
        """Ids that each claim rests on, directly or not, in the paper's order."""
        place = {claim.id: n for n, claim in enumerate(self.claims)}
        found: dict[str, set[str]] = {}
        for id_ in TopologicalSorter({c.id: c.rests_on for c in self.claims}).static_order():
            direct = self.by_id[id_].rests_on
            found[id_] = set(direct).union(*(found[other] for other in direct))
        return {id_: tuple(sorted(ids, key=place.__getitem__)) for id_, ids in found.items()}

    @cached_property
    def descendants(self) -> dict[str, tuple[str, ...]]:
        """Ids that rest on each claim, directly or not, in the paper's order."""
        resting: dict[str, list[str]] = {claim.id: [] for claim in self.claims}
        for claim in self.claims:
            for ancestor in self.ancestors[claim.id]:
                resting[ancestor].append(claim.id)
        return {id_: tuple(ids) for id_, ids in resting.items()}


def _refuse_repeats(what: str, values: Iterable[str]) -> None:
    seen: set[str] = set()
    for value in values:
        if value in seen:
            raise ValueError(f"{what} {value!r} is given twice")
        seen.add(value)


def registry() -> Registry:
    """Return the registry of the whole paper."""
    claims = tuple(claim for room in _ROOMS for claim in room.CLAIMS)
    return Registry(claims=claims, waived=waived.WAIVED)
