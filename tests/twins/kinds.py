"""The kinds of joint that random specs are drawn of."""

PIVOTS = ("rcc", "cross-spring", "star", "three-blade", "unseparated-cross", "hinged-pivot")
HINGES = ("moment-blade", "notch-hinge", "elliptic-hinge", "filleted-hinge")
NOTCHES = HINGES[1:]
LIMBS = ("hinged-pivot", "hinged-stage")
BARS = ("torsion-bar", "round-torsion-bar", "torsion-star")
STAGES = ("cantilever", "guided-blade", "leaf-spring-stage", "necked-down-stage", "hinged-stage")
DRAWN = ("layout", "layout-pivot")
KINDS = PIVOTS + HINGES + BARS + STAGES + DRAWN + ("linkage",)
TURNS = PIVOTS + HINGES + BARS + ("layout-pivot", "linkage")
ROOTED = ("rcc", "cross-spring", "star", "three-blade", "cantilever", "guided-blade",
          "moment-blade", "leaf-spring-stage")  # fmt: skip
"""Joints of blades that may have fillets at their roots."""
