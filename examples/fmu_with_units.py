"""Real variables with units, for FMUs written in Python: pythonfmu 0.7 does not write them."""

from xml.etree.ElementTree import Element, SubElement

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real

# Exponents of the SI base units, as FMI 2.0 wants them.
UNITS = {
    "rad": {"rad": "1"},
    "rad/s": {"rad": "1", "s": "-1"},
    "s": {"s": "1"},
    "m/s": {"m": "1", "s": "-1"},
    "m/s2": {"m": "1", "s": "-2"},
    "rad.s2/m": {"rad": "1", "s": "2", "m": "-1"},
    "1": {},
    "1/s": {"s": "-1"},
}


class FmuWithUnits(Fmi2Slave):
    """An FMU whose variables are declared by `input`, `output` and `parameter`, each with a unit of `UNITS`."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.unit_of = {}

    def input(self, name, unit, description):
        self.declare(name, unit, description, Fmi2Causality.input, Fmi2Variability.continuous)

    def output(self, name, unit, description):
        self.declare(name, unit, description, Fmi2Causality.output, Fmi2Variability.discrete)

    def parameter(self, name, unit, description):
        self.declare(name, unit, description, Fmi2Causality.parameter, Fmi2Variability.fixed)

    def declare(self, name, unit, description, causality, variability):
        """Makes the attribute `name` a variable of the FMU."""
        self.unit_of[name] = unit
        self.register_variable(
            Real(name, causality=causality, variability=variability, description=description)
        )

    def to_xml(self, *options) -> Element:
        """pythonfmu's model description, completed by the units."""
        root = super().to_xml(*options)
        definitions = Element("UnitDefinitions")
        for unit in sorted(set(self.unit_of.values())):
            SubElement(SubElement(definitions, "Unit", name=unit), "BaseUnit", UNITS[unit])
        root.insert(list(root).index(root.find("CoSimulation")) + 1, definitions)
        for variable in root.iter("ScalarVariable"):
            variable.find("Real").set("unit", self.unit_of[variable.get("name")])
        return root
