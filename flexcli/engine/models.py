"""The models of a joint, from the cheapest to the finest, by the names that a user gives them."""

from flexcli.errors import SolveError
from flexcli.parts.geometries import Geometry
from flexcli.parts.requirements import CLOSED_FORM, Answers

__all__ = ["MODELS", "answers_for", "answers_of"]

MODELS = ("closed-form", "linear", "exact")


def answers_of(model: str) -> Answers:
    """Return the model of a name; the solvers are imported for the models that need them."""
    if model == "linear":
        from flexcli.engine.answers.linear import LinearAnswers

        return LinearAnswers()
    if model == "exact":
        from flexcli.engine.answers.exact import ExactAnswers

        return ExactAnswers()
    return CLOSED_FORM


def answers_for(geometry: Geometry, model: str | None) -> Answers:
    """Return the model asked for, else the cheapest that the geometry has.

    Raises
    ------
    SolveError
        When closed forms are asked of a geometry that has none.

    """
    if not geometry.closed_forms and model == CLOSED_FORM.model:
        text = f"a {geometry.name} has no closed forms"
        raise SolveError("no-closed-forms", text, "take --model linear or exact")
    return answers_of(model or (CLOSED_FORM.model if geometry.closed_forms else "exact"))
