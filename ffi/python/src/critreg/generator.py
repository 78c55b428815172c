"""A learner as a generator of points: the interface of gest-api (suggest and ingest).

Programs that run campaigns of simulations take it, such as libEnsemble, Optimas and Xopt.
gest-api itself is not needed: the methods are what counts.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Optional, Union

from .domain import Domain
from .learner import UNKNOWN, Learner
from .region import Region

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._numbers import Matrix
    from .learner import Options


class Generator:
    """Suggests samples to try, and takes in what came of them.

        generator = Generator(vocs, DOMAIN, instances, seed=7)
        points = generator.suggest(4)       # [{"mu": 0.3, "instance": 2, "_id": 11}, ...]
        for point in points:
            point["works"] = run(point)
        generator.ingest(points)

    The variables of `vocs` (an object with dictionaries `variables`, `objectives`,
    `observables` and `constraints`) are the parameters of the action and "instance", the
    index of the instance to try them in; "instance" may be left out if there is one. Its
    only output is the outcome: a bool, 1 or 0, -k if step k failed, NaN or None if nobody
    knows.
    """

    returns_id: bool = True

    def __init__(
        self,
        vocs: Any,
        domain: Union[Domain, str],
        instances: Matrix,
        **options: Unpack[Options],
    ) -> None:
        self.learner: Learner = Learner(domain, instances, **options)
        """The learner behind it, for its report, region and `save`."""
        self._validate_vocs(vocs)
        self._names = self.learner.domain.parameters
        self._output = _outputs(vocs)[0]
        self._tells_instance = "instance" in vocs.variables

    def _validate_vocs(self, vocs: Any) -> None:
        """Raises ValueError if the names do not fit the domain."""
        wanted, given = set(self.learner.domain.parameters), set(vocs.variables)
        if given - {"instance"} != wanted:
            raise ValueError(f"the variables are {sorted(given)}, the parameters {sorted(wanted)}")
        if "instance" not in given and len(self.learner.instances) > 1:
            raise ValueError('with several instances there is a variable "instance"')
        outputs = _outputs(vocs)
        if len(outputs) != 1:
            raise ValueError(f"the outcome is the only output, not {outputs}")

    def suggest(self, num_points: Optional[int] = None) -> list[dict[str, Any]]:
        """So many points to try, or one. ValueError if no more are worth trying now."""
        wanted = 1 if num_points is None else num_points
        questions = self.learner.ask_many(wanted)
        if num_points is not None and len(questions) < wanted:
            for question in questions:
                self.learner.forget(question.id)
            raise ValueError(f"{len(questions)} points are worth trying before an answer comes")
        return [self._point(*question) for question in questions]

    def _point(self, id: int, index: int, theta: list[float]) -> dict[str, Any]:
        point: dict[str, Any] = dict(zip(self._names, theta), _id=id)
        if self._tells_instance:
            point["instance"] = index
        return point

    def ingest(self, results: list[dict[str, Any]]) -> None:
        """Points with what came of them. Those without an "_id" were not suggested."""
        waiting = {question.id for question in self.learner.open_questions()}
        ids = [point["_id"] for point in results if "_id" in point]
        unknown = [id for id in ids if id not in waiting]
        if unknown or len(ids) != len(set(ids)):
            raise ValueError(f"no points wait for an answer with these ids: {unknown or ids}")
        for point in results:
            outcome = _outcome(point[self._output])
            if "_id" in point:
                self.learner.tell_id(point["_id"], outcome)
            else:
                theta = [point[name] for name in self._names]
                self.learner.observe(int(point.get("instance", 0)), theta, outcome)

    def finalize(self) -> None:
        """Brings the region up to date with everything that was ingested."""
        self.learner.conclude()

    def region(self) -> Optional[Region]:
        """What is learned so far."""
        return self.learner.region()


def _outputs(vocs: Any) -> list[str]:
    kinds = ("objectives", "observables", "constraints")
    return [name for kind in kinds for name in getattr(vocs, kind, None) or ()]


def _outcome(value: Any) -> Any:
    """Results pass through tables of floats on their way."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return UNKNOWN
    return int(value) if isinstance(value, float) and value.is_integer() else value
