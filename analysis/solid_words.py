"""What carries a solid, in the same words in every figure and table."""

FORMULATIONS = {"reference_map": "reference map", "transported_B": "transported B"}
TRANSPORTS = {"height": "height", "mthinc": "MTHINC", "z": "WENO-Z", "js": "WENO-JS"}
HIGHEST_THRESHOLD_OF_A_HEIGHT = 0.75  # higher ones count as this (solver/solid/README.md)


def formulation_of(case):
    return FORMULATIONS[case.physics["solid"]["formulation"]]


def transport_of(case):
    """Of phi of a transported B: "height", "mthinc", or the weights of WENO."""
    solid = case.physics["solid"]
    return solid["weno"] if solid["interface"] == "weno" else solid["interface"]


def option_of(case):
    """What the solid is made with, in a few words."""
    if case.physics["solid"]["formulation"] == "reference_map":
        return formulation_of(case)
    transport, threshold = transport_of(case), case.physics["solid"]["threshold"]
    if transport == "height":
        threshold = min(threshold, HIGHEST_THRESHOLD_OF_A_HEIGHT)
    return f"{TRANSPORTS[transport]}, threshold {threshold:g}"
