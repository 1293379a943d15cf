"""Keys of specs that few designs have: each in a share of the specs of a campaign.

They are drawn after everything else, so that what was drawn before them stays as it was.
"""

from twins.kinds import BARS, NOTCHES

PLAIN = "none of these"


def what_is_rare(spec):
    """Return which of the keys that make a joint less known a spec has."""
    has = {
        "temperature": any("temperature" in case for case in spec["cases"].values()),
        "crystal or sheet": "orientation" in spec["material"],
        "fillets at roots": "root_radius" in spec["geometry"],
    }
    return [name for name, is_given in has.items() if is_given] or [PLAIN]


def draw_rare_keys(w, spec, requirements, easy):
    """Draw them by a writer of specs; ``easy`` is a factor that everything keeps."""
    _of_sheets(w, spec["material"])
    _warmed_unevenly(w, spec)
    _shaken_otherwise(w, spec)
    _worn(w, spec, requirements)
    _misseated(w, requirements, easy)


def _of_sheets(w, material):
    """Make some joints of a crystal or of a sheet that is stiffer one way."""
    rng = w.rng
    if rng.random() > 0.06 or w.kind in (*BARS, "linkage"):
        return
    for isotropic in ("youngs_modulus", "poisson_ratio"):
        material.pop(isotropic, None)
    if rng.random() < 0.6:
        material["crystal"] = {"c11": "165.7 GPa", "c12": "63.9 GPa", "c44": "79.6 GPa"}
        material["orientation"] = {"wafer": w.one("100", "110", "111")}
    else:
        material["orthotropic"] = {
            "E_1": "140 GPa", "E_2": "60 GPa", "G_12": "20 GPa", "nu_12": 0.3,
        }  # fmt: skip
        material["orientation"] = {}
    material["orientation"]["turned"] = f"{w.one(0.0, float(rng.uniform(0, 90)))!r} deg"
    if rng.random() < 0.3:
        material["orientation"]["width"] = "in-plane"


def _warmed_unevenly(w, spec):
    """Let the temperature of a case rise from place to place, bodies be of another material."""
    rng, case, material = w.rng, spec["cases"]["work"], spec["material"]
    alone = spec.get("mechanism", {}).get("kind") != "parallel-stage"
    warm = case.get("temperature")
    if warm is None:
        if rng.random() > 0.08 or not alone or w.kind in (*BARS, "linkage"):
            return
        warm = case["temperature"] = {}
        material["thermal_expansion"] = f"{w.log(1e-6, 25e-6)!r} 1/K"
    elif rng.random() > 0.6:
        return
    if not warm or rng.random() < 0.6:
        rise = w.log(0.1, 30.0) / w.l * w.one(-1, 1)
        axes = w.one("x", "y", "xy")
        warm["gradient"] = {axis: f"{rise * rng.uniform(0.2, 1.0)!r} K/m" for axis in axes}
    if rng.random() < 0.4:
        moving = spec["geometry"].get("moving", "moving")
        for body in w.one(("ground",), (moving,), ("ground", moving)):
            warm.setdefault("expansion", {})[body] = f"{w.log(3e-7, 25e-6)!r} 1/K"
    if rng.random() < 0.5:
        # stiffer and stronger where it is colder
        strengths = ("yield_strength", "tensile_strength", "youngs_modulus")
        material["over_temperature"] = {
            name: {"points": [
                [f"{kelvin} K", f"{float(material[name].split()[0]) * share!r} Pa"]
                for kelvin, share in ((4, 1.3), (150, 1.2), (293, 1.0), (700, 0.6))
            ]}
            for name in strengths
            if name in material
        }  # fmt: skip


def _shaken_otherwise(w, spec):
    """Put sines, sweeps, other shocks and vibration along several axes in the place of some."""
    rng = w.rng
    for case in spec["cases"].values():
        if "shock" in case and rng.random() < 0.5:
            shock = {"q": w.one(10, 50), "axis": w.one("x", "y", "z")}
            if rng.random() < 0.5:
                shock["velocity"] = f"{w.log(0.01, 5.0)!r} m/s"
            else:
                shock["srs"] = [
                    {"frequency": f"{f} Hz", "acceleration": f"{w.log(1.0, 1e3)!r} g"}
                    for f in (10, 300, 2000)
                ]
            case["shock"] = shock
        if "asd" in case and rng.random() < 0.6:
            way = rng.random()
            if "lock" not in case and spec["mechanism"]["kind"] == "parallel-stage":
                continue  # along other axes it swings
            if way < 0.35:
                del case["asd"]
                axes = w.one("xy", "xz", "yz", "xyz")
                case["axes"] = {
                    axis: {"asd": "gevs-qualification", "scale": f"{w.one(0, -3)} dB"}
                    for axis in axes
                }
                case |= {"q": w.one(20, 50), "combine": w.one("at-once", "in-turn")}
            elif way < 0.7:
                low = w.log(5.0, 1000.0)
                tone = {"acceleration": f"{w.log(0.1, 30.0)!r} g", "from": f"{low!r} Hz"}
                case["sines"] = [tone | {"to": f"{low * w.log(1.01, 3.0)!r} Hz"}]
            else:
                del case["asd"]
                level = {"acceleration": f"{w.log(0.1, 30.0)!r} g", "axis": w.one(*"xyz")}
                f = w.log(5.0, 2000.0)
                case["q"] = w.one(20, 50)
                if rng.random() < 0.5:
                    case["sine"] = level | {"frequency": f"{f!r} Hz"}
                else:
                    ends = {"from": f"{f!r} Hz", "to": f"{10.0 * f!r} Hz"}
                    case["sweep"] = level | ends | {"rate": "2 oct/min"}


def _worn(w, spec, requirements):
    """Give the fatigue of some materials by an S-N curve."""
    if w.rng.random() > 0.15 or "fatigue" not in requirements:
        return
    material = spec["material"]
    tensile = float(material["tensile_strength"].split()[0])
    if w.rng.random() < 0.5:
        basquin = {"coefficient": f"{1.5 * tensile!r} Pa", "exponent": -0.08, "to_cycles": 1e7}
        curve = {"basquin": basquin}
    else:
        shares = {1e3: 0.8, 1e5: 0.6, 1e8: 0.35}
        curve = {"points": [
            {"cycles": n, "amplitude": f"{share * tensile!r} Pa"} for n, share in shares.items()
        ]}  # fmt: skip
    material["sn_amplitudes"] = curve | {"stress_ratio": w.one(-1, 0.1)}
    del material["fatigue_amplitude"]
    for case in spec["cases"].values():
        if "stroke" in case:
            case["stroke"]["cycles"] = w.log(1e3, 1e7)


def _misseated(w, requirements, easy):
    """Ask what a missed seat stresses."""
    rng = w.rng
    if rng.random() > 0.15 or w.kind in (*BARS, "linkage"):
        return
    first = {
        "layout": "in-a", "layout-pivot": "b0", "hinged-pivot": "limb 1 inner hinge",
        "hinged-stage": "limb 1 inner hinge", "unseparated-cross": "blade 1 base",
        "cantilever": "blade", "guided-blade": "blade", "moment-blade": "blade",
    }  # fmt: skip
    of = "hinge" if w.kind in NOTCHES else first.get(w.kind, "blade 1")
    turns, way = rng.random() < 0.5, [float(x) for x in rng.normal(size=3)]
    way = w.one("x", "y", "z", way)
    by = w.log(1e-7, 1e-2)
    asked = {"rotation": {"about": way, "by": f"{by!r} rad"}}
    if not turns:
        asked = {"translation": {"along": way, "by": f"{by * w.l!r} m"}}
    requirements["misalignment_stress"] = {"of": of, "factor": easy} | asked
