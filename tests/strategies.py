"""Designs for tests: a plain builder and random specs of every geometry."""

from hypothesis import strategies as st

from flexcli.parts.design import DesignSpec

TITANIUM = {
    "youngs_modulus": "114 GPa",
    "poisson_ratio": 0.34,
    "density": "4430 kg/m^3",
    "yield_strength": "830 MPa",
    "tensile_strength": "900 MPa",
    "fatigue_amplitude": {"value": "500 MPa", "cycles": 1e7, "stress_ratio": -1},
}
BEND = {"stroke": {"rotation": "1.1746 deg", "cycles": 1e7}}
PUSH = {"load": {"force": "640 N"}, "ends": "clamped-clamped"}
CASES = {"bend": BEND, "push": PUSH}
LOADS = {
    "fatigue": 2.5,
    "buckling": 2.5,
    "yield": {"factor": 2.5, "allowable": "fatigue-amplitude", "cases": ["push"]},
}


class Inconsistent(Exception):
    """Parts that are sound each and do not fit together."""


def rcc(**changes):
    free = {"h": "free", "l": "free", "b": "free"}
    return {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", **free, **changes}


def crossed(**changes):
    free = {"h": "free", "l": "free", "b": "free"}
    return {"kind": "cross-spring", "half_angle": "45 deg", **free, **changes}


def stage(**changes):
    return {"kind": "leaf-spring-stage", "h": "free", "l": "free", "b": "free", **changes}


def three_blade(**changes):
    return {"kind": "three-blade", "h": "free", "l": "free", "b": "free", **changes}


def design(geometry, requirements, cases=None, *, size=None, mechanism=None, material=None):
    """Return a validated design from inline parts, or raise what does not fit."""
    content = {
        "flexure": 1,
        "material": material or TITANIUM,
        "geometry": geometry,
        "cases": cases or CASES,
        "requirements": requirements,
    }
    content |= {"size": size} if size else {}
    content |= {"mechanism": mechanism} if mechanism else {}
    spec = DesignSpec.model_validate(content)
    problems = spec.problems()
    if problems:
        raise Inconsistent("; ".join(problem.text for problem in problems))
    return spec


def bounded(draw, low, high):
    """Draw a dimension between bounds [µm] a factor of ten or more apart."""
    least = draw(st.integers(low, high // 20))
    return {"free": [f"{least} um", f"{draw(st.integers(10 * least, high))} um"]}


@st.composite
def specs(draw):
    """Random specs, most of them feasible: any geometry, loads, bounds and objective."""
    kind = draw(st.sampled_from(["rcc", "cross-spring", "delta", "three-blade", "stage"]))
    sizes = {
        "h": bounded(draw, 20, 3000),
        "l": bounded(draw, 2000, 200_000),
        "b": bounded(draw, 500, 50_000),
    }
    held = draw(st.sampled_from(["", "", "h", "l", "b"]))
    if held:
        sizes[held] = {"h": "200 um", "l": "20 mm", "b": "10 mm"}[held]
    geometry = {
        "rcc": lambda: rcc(p=f"{draw(st.integers(0, 20_000))} um", **sizes),
        "cross-spring": lambda: crossed(p=f"{draw(st.integers(-20_000, 5_000))} um", **sizes),
        "delta": lambda: crossed(delta=draw(st.integers(-150, 100)) / 100, **sizes),
        "three-blade": lambda: three_blade(**sizes),
        "stage": lambda: stage(blades=draw(st.integers(2, 6)), **sizes),
    }[kind]()
    travel = f"{draw(st.integers(50, 3000))} um"
    if kind != "stage":
        travel = f"{draw(st.integers(5, 50)) / 10} deg"
    motion = "translation" if kind == "stage" else "rotation"
    cases = {
        "bend": {"stroke": {motion: travel, "cycles": 1e7}},
        "push": {"load": {"force": f"{draw(st.integers(1, 200))} N"}, "ends": "clamped-guided"},
    }
    if draw(st.booleans()):
        cases["both"] = {
            "stroke": {motion: travel, "cycles": 1e5},
            "load": {"force": f"{draw(st.integers(1, 20))} N"},
        }
    factor = draw(st.integers(10, 25)) / 10
    requirements = {
        "fatigue": {
            "factor": factor,
            "mean_stress": draw(st.sampled_from(["goodman", "soderberg", "swt", "none"])),
        },
        "buckling": {"factor": factor, "cases": ["push"]},
        "yield": factor,
    }
    if draw(st.booleans()):
        requirements["l/h"] = {"min": 10}
    if draw(st.booleans()):
        requirements["b/h"] = {"min": 2, "max": 200}
    objective = draw(
        st.sampled_from(
            ["least-volume", "balanced", "shortest", "least-stiffness", {"minimize": "b"}]
        )
    )
    return design(geometry, requirements, cases, size={"objective": objective})
