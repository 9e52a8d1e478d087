# SPDX-License-Identifier: GPL-3.0-or-later
# sparkout-reference writes sparkout.pyi from sparkout.pyi.in and the tables of outputs.
"""Cylindrical grinding cycles, computed pass by pass."""

import os
from typing import Any, Optional, TypedDict

import numpy as np
from numpy.typing import NDArray

__version__: str

Floats = NDArray[np.float64]

class Issue:
    """A fault of an input, or a warning."""

    @property
    def path(self) -> str:
        """JSON pointer of the input, "/wheel/width_mm"."""
    @property
    def code(self) -> str:
        """What kind of fault it is, "out_of_range"."""
    @property
    def value(self) -> str: ...
    @property
    def limit(self) -> str: ...
    @property
    def is_error(self) -> bool: ...
    @property
    def text(self) -> str: ...

class ProjectError(ValueError):
    """A project is refused."""

    issues: list[Issue]

class Project:
    """The inputs of a cycle, checked: one that is refused cannot be made."""

    def __init__(self, text: str) -> None: ...
    @staticmethod
    def read(path: str | os.PathLike[str]) -> Project: ...
    def write(self, path: str | os.PathLike[str]) -> None: ...
    def to_text(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __getitem__(self, path: str) -> Any: ...
    def __eq__(self, other: object) -> bool: ...
    def with_values(self, values: dict[str, Any]) -> Project: ...
    @property
    def warnings(self) -> list[Issue]: ...

class SectionForm(TypedDict, total=False):
    diameter_deviation_even_lobes_um: Optional[tuple[float, float]]
    cylindricity_um: Optional[float]
    total_runout_um: Optional[float]
    taper_um: Optional[float]
    crown_um: Optional[float]

class Section(SectionForm):
    where: str
    radii_mm: Floats
    diameter_min_mm: float
    diameter_max_mm: float
    radial_runout_mm: float
    position_mm: float
    compliance_mm_per_n: float
    diameter_deviation_um: Optional[tuple[float, float]]
    radial_runout_um: Optional[float]
    roundness_um: Optional[float]
    roundness_least_squares_um: Optional[float]
    roughness_ra_um: Optional[float]
    roughness_ra_most_um: Optional[float]
    peak_normal_force_n: float

class PartForm:
    """The form of the whole part."""

    @property
    def cylindricity_um(self) -> Optional[float]:
        """minimum zone [µm]"""
    @property
    def cylindricity_least_squares_um(self) -> Optional[float]:
        """least squares [µm]"""
    @property
    def total_runout_um(self) -> Optional[float]:
        """about the centre axis, over all sections [µm]"""
    @property
    def taper_um(self) -> Optional[float]:
        """mean radius at the last section less that at the first [µm]"""
    @property
    def crown_um(self) -> Optional[float]:
        """mean radius in the middle less that at the ends [µm]"""
    @property
    def form(self) -> Optional[str]:
        """straight, taper, barrel or saddle"""

class Burn:
    """The pass nearest to burning."""

    @property
    def depth_of_cut_um(self) -> float:
        """depth of cut of the pass nearest to burning [µm]"""
    @property
    def limit_depth_um(self) -> float:
        """maximum depth of cut for that stock [µm]"""
    @property
    def stock_left_um(self) -> float:
        """stock per side left after that pass [µm]"""
    @property
    def damaged_depth_um(self) -> float:
        """depth of the damaged layer [µm]"""
    @property
    def rise_at_stock_left_k(self) -> float:
        """temperature rise of the finished surface [K]"""

class Requirement(TypedDict):
    name: str
    where: str
    unit: str
    holds: bool
    value: float
    limit: float
    margin: float
    machine_known: bool

class JudgedStocks:
    """A cycle over every stock within one infeed."""

    @property
    def decided(self) -> bool:
        """whether the stocks within one infeed are decided; not under position control, nor for a cycle of too many passes"""
    @property
    def holds(self) -> Optional[bool]:
        """whether every requirement is met for each of these stocks"""
    @property
    def stock_mm(self) -> Optional[tuple[float, float]]:
        """range of stocks per side [mm]"""
    @property
    def failing_share(self) -> Optional[float]:
        """share of these stocks for which a requirement is not met, 0…1"""

class Undecided:
    """A requirement that is asked for and not decided."""

    @property
    def name(self) -> str:
        """of the requirement"""
    @property
    def why(self) -> str:
        """not_calibrated, input_missing or machine_not_known"""
    @property
    def input(self) -> str:
        """JSON pointer of the input that decides it"""

class JudgedBatch:
    """A cycle over the parts of a batch."""

    @property
    def parts(self) -> int:
        """parts that were run"""
    @property
    def seed(self) -> int:
        """seed of their scatter"""
    @property
    def bad(self) -> int:
        """rejected parts"""
    @property
    def interval_95(self) -> Optional[tuple[float, float]]:
        """95 % interval of the share of rejected parts; null for corners"""
    @property
    def low_ppk_95(self) -> Optional[tuple[float, float]]:
        """95 % interval of the lowest P_pk, if it or the expected share outside does not meet the batch's limit; otherwise null"""

class MeasuredBias:
    """Measured parts that differ from the predicted ones."""

    @property
    def name(self) -> str:
        """requirement on the quantity whose measured mean differs from the predicted one; diameter_min for a diameter"""
    @property
    def where(self) -> str:
        """zone, section or part"""
    @property
    def bias_um(self) -> float:
        """measured mean less the predicted one [µm]"""

class Judgement:
    """How a cycle stands."""

    @property
    def state(self) -> str:
        """the first that applies: not_computed, fails, stocks_fail, batch_fails, measured_differ, undecided, close, batch_not_run, batch, every_stock, nominal"""
    @property
    def headline(self) -> str:
        """the state in words"""
    @property
    def nominal(self) -> bool:
        """whether the part that was run reaches size and meets every requirement"""
    @property
    def stocks(self) -> JudgedStocks: ...
    @property
    def batch(self) -> Optional[JudgedBatch]: ...
    @property
    def measured(self) -> Optional[MeasuredBias]: ...
    @property
    def not_decided(self) -> list[Undecided]: ...

class Evaluation:
    """A cycle that was run, and what came out of it."""

    @property
    def status(self) -> str: ...
    @property
    def holds(self) -> bool: ...
    @property
    def time_s(self) -> float: ...
    @property
    def count(self) -> int: ...
    @property
    def time_by_stage_s(self) -> Floats: ...
    @property
    def peak_normal_force_n(self) -> float: ...
    @property
    def peak_power_w(self) -> float: ...
    @property
    def sections(self) -> list[Section]: ...
    @property
    def part(self) -> PartForm: ...
    @property
    def burn(self) -> Optional[Burn]: ...
    @property
    def requirements(self) -> list[Requirement]: ...
    @property
    def warnings(self) -> list[Issue]: ...
    @property
    def judged(self) -> Judgement: ...
    # a value for each double stroke or revolution, merged to at most 500
    def feeds(self) -> dict[str, dict[str, Floats]]: ...
    def trace(self) -> dict[str, Floats]: ...
    def to_dict(self) -> dict[str, Any]: ...

class Remedy:
    """A change of one setting that helps."""

    @property
    def kind(self) -> str:
        """setting; pair, the stock of finishing with a feed of the first stage; or starting_cycle"""
    @property
    def path(self) -> str:
        """JSON pointer of the input; of a stage more, the stage; of a starting cycle, its first stage"""
    @property
    def before(self) -> Optional[float]:
        """current value; none for one more stage or a starting cycle"""
    @property
    def value(self) -> Optional[float]:
        """value to apply: the middle of the interval; none for a starting cycle"""
    @property
    def with_value(self) -> Optional[float]:
        """of a pair: the radial feed of the first stage that goes with it"""
    @property
    def interval(self) -> Optional[tuple[float, float]]:
        """every value in it that can be set was run and helps; none for a starting cycle"""
    @property
    def values(self) -> int:
        """number of the values in the interval"""
    @property
    def failing(self) -> Optional[float]:
        """the next value towards the current one before the interval, which was run and fails"""
    @property
    def holds_beyond(self) -> bool:
        """whether the next value behind the interval helps, too"""
    @property
    def time_min(self) -> float:
        """time of the cycle [min]"""
    @property
    def time_change_min(self) -> Optional[float]:
        """time of the cycle minus that of the unchanged cycle; none if that one does not end by itself [min]"""
    @property
    def stock_mm(self) -> Optional[tuple[float, float]]:
        """stocks per side for each of which the cycle is fit; none under position control, where stocks are drawn at random [mm]"""
    @property
    def rank(self) -> float:
        """cost by which remedies are ordered: the change of time as a share of the time, and the change of the setting"""
    @property
    def time_s(self) -> float: ...
    @property
    def time_change_s(self) -> Optional[float]: ...
    @property
    def phases(self) -> int: ...
    @property
    def requirements(self) -> list[Requirement]: ...
    @property
    def text(self) -> str: ...
    @property
    def project(self) -> Project: ...

class RemedyConflict:
    """Why none of the values that were tried helps."""

    @property
    def kind(self) -> str:
        """narrow, batch, stocks, warned, idle, opposed, several or unmended"""
    @property
    def first(self) -> Optional[str]:
        """requirement violated most; none if the cycle does not end by itself"""
    @property
    def second(self) -> Optional[str]:
        """requirement not met with the setting"""
    @property
    def path(self) -> Optional[str]:
        """JSON pointer of the setting that comes nearest"""
    @property
    def value(self) -> Optional[float]:
        """value of that setting"""
    @property
    def stock_mm(self) -> Optional[float]:
        """stock per side for which the cycle is unfit with it; none unless the kind is stocks [mm]"""

class Remedies:
    """Possible remedies."""

    @property
    def goal(self) -> str:
        """holds, room or none"""
    @property
    def fault(self) -> str:
        """fault of the unchanged project: part (as stated), stocks (another stock within one infeed), batch (too many rejected parts) or none"""
    @property
    def status(self) -> str:
        """completed or stopped"""
    @property
    def settings(self) -> int:
        """settings to try"""
    @property
    def tried(self) -> int:
        """settings that were tried"""
    @property
    def runs(self) -> int:
        """cycles that were run"""
    @property
    def found(self) -> int:
        """settings that help"""
    @property
    def remedies(self) -> list[Remedy]: ...
    @property
    def conflict(self) -> Optional[RemedyConflict]: ...
    @property
    def text(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...

class Batch:
    """The parts of a batch."""

    @property
    def status(self) -> str: ...
    @property
    def factors(self) -> list[str]: ...
    @property
    def quantities(self) -> list[str]: ...
    @property
    def factor_values(self) -> Floats: ...
    @property
    def values(self) -> Floats: ...
    @property
    def good(self) -> NDArray[np.bool_]: ...
    def to_dict(self) -> dict[str, Any]: ...

class Sweep:
    """The points of a sweep."""

    @property
    def status(self) -> str:
        """completed or stopped"""
    @property
    def inputs(self) -> dict[str, Floats]: ...
    @property
    def points(self) -> Floats: ...
    @property
    def quantities(self) -> list[str]: ...
    @property
    def values(self) -> Floats: ...
    @property
    def margins(self) -> Floats: ...
    @property
    def statuses(self) -> list[str]: ...
    def to_dict(self) -> dict[str, Any]: ...

class Search:
    """What a search found."""

    @property
    def status(self) -> str:
        """proved, found, stopped, infeasible or not_found"""
    @property
    def method(self) -> str: ...
    @property
    def heuristic(self) -> bool: ...
    @property
    def aim(self) -> str: ...
    @property
    def margin_within_min(self) -> Optional[float]: ...
    @property
    def cycle_time_min(self) -> Optional[float]:
        """Time of the cycle found [min]."""
    @property
    def least_relative_margin(self) -> Optional[float]:
        """Minimum margin of all requirements, relative to its limit."""
    @property
    def cost_per_part(self) -> Optional[float]:
        """Cost of a part with its share of the dressing."""
    @property
    def limit_time_min(self) -> Optional[float]:
        """Stepless limit [min]."""
    @property
    def gap(self) -> Optional[float]:
        """Excess over the stepless limit."""
    @property
    def limit_by(self) -> str: ...
    @property
    def bound_time_min(self) -> float:
        """No cycle of the grid is quicker than [min]."""
    @property
    def grid_size(self) -> int:
        """Cycles in the grid."""
    @property
    def level_rounds(self) -> int:
        """Rounds of levels."""
    @property
    def evaluations(self) -> int:
        """Cycles judged."""
    @property
    def visits(self) -> int:
        """Radii under the wheel in all runs."""
    @property
    def scenarios_added(self) -> int:
        """Scenarios added."""
    @property
    def rounds(self) -> Optional[int]: ...
    @property
    def holds_in_sample(self) -> Optional[bool]: ...
    @property
    def decided_stock_mm(self) -> Optional[tuple[float, float]]: ...
    @property
    def nominal_time_min(self) -> Optional[float]:
        """Time of the quickest cycle for the part alone [min]."""
    @property
    def time_s(self) -> Optional[float]: ...
    @property
    def project(self) -> Optional[Project]: ...
    @property
    def bound_s(self) -> float: ...
    @property
    def limit_s(self) -> Optional[float]: ...
    @property
    def limit_cycles(self) -> dict[str, Any]: ...
    @property
    def binding(self) -> Optional[list[str]]: ...
    @property
    def text(self) -> list[str]: ...
    def to_dict(self) -> dict[str, Any]: ...

def starting(
    size: str,
    *,
    length_mm: float,
    stock_mm: float,
    bore: bool = False,
    operation: Optional[str] = None,
    shoulder: Optional[str] = None,
    ra_um: Optional[float] = None,
    machine: str = "",
    wheel: str = "",
    material: str = "",
) -> Project: ...
def evaluate(
    project: Project, *, batch: bool = False, threads: int = 0
) -> Evaluation: ...
def remedies(project: Project) -> Remedies: ...
def batch(project: Project, threads: int = 0) -> Batch: ...
def sweep(project: Project, threads: int = 0) -> Sweep: ...
def phases(
    project: Project, *, from_mm: Optional[float] = None, to_mm: Optional[float] = None
) -> dict[str, Any]: ...
def dressing(text: str) -> dict[str, Any]: ...
def waves(
    project: Project, counted: int, *, frequencies_hz: list[float] = ...
) -> dict[str, Any]: ...
def measured(
    project: Project,
    *,
    table: Optional[str] = None,
    fit: Optional[str] = None,
    loss: str = "none",
    threads: int = 0,
) -> dict[str, Any]: ...
def calibrated(
    project: Project,
    *,
    fit: str,
    table: Optional[str] = None,
    loss: str = "none",
    data: str = "table",
    threads: int = 0,
) -> Project: ...
def check_lesson(text: str) -> dict[str, Any]: ...
def check_work(text: str) -> dict[str, Any]: ...
def search(
    project: Project,
    *,
    robust: bool = False,
    refine: bool = False,
    front: bool = False,
    method: str = "search",
    time_limit_s: Optional[float] = None,
    resume: Optional[str | os.PathLike[str]] = None,
) -> Search: ...
