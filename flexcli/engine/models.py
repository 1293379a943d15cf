"""The models of a joint, from the cheapest to the finest, by the names that a user gives them."""

from flexcli.parts.requirements import CLOSED_FORM, Answers

__all__ = ["MODELS", "answers_of"]

MODELS = ("closed-form", "linear", "exact")


def answers_of(model: str) -> Answers:
    """Return the model of a name; the solvers are imported for the models that need them."""
    if model == "linear":
        from flexcli.engine.linear_answers import LinearAnswers

        return LinearAnswers()
    if model == "exact":
        from flexcli.engine.exact_answers import ExactAnswers

        return ExactAnswers()
    return CLOSED_FORM
