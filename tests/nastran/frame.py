"""A frame of Euler beams and rigid bodies from a deck, clamped at a grid: what pyNastran is used for are fields and places alone.

Each beam has its mass at its two Gauss points, which give its mass, centre and inertia, moved by the cubic shapes of the beam; so the
elements of the aircraft file have it. Lengths, forces and masses stay the deck's."""

import numpy as np
from pyNastran.bdf.bdf import BDF

GAUSS = (0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0))


def read(path):
    """The deck; one without case control is bulk data from its first line on."""
    model = BDF(debug=None)
    model.read_bdf(str(path), punch="BEGIN BULK" not in path.read_text().upper())
    return model


def cross(r):
    return np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])


def axes(system, place):
    """The axes of a coordinate system at a place, as columns: of a cylindrical one out, around, along."""
    rows = system.beta()
    if system.type == "CORD2C":
        angle = np.radians(system.transform_node_to_local(place)[1])
        rows = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]]) @ rows
    return rows.T


def section(element):
    """Area, I1, I2, I12, J of a property; of PBEAM the mean of both ends."""
    prop = element.pid_ref
    if prop.type == "PBAR":
        return prop.A, prop.i1, prop.i2, prop.i12, prop.j
    if prop.type == "PBEAM":
        return tuple(0.5 * (of[0] + of[-1]) for of in (prop.A, prop.i1, prop.i2, prop.i12, prop.j))
    assert prop.type == "PBARL"
    if prop.beam_type == "TUBE":
        outer, inner = prop.dim
        second = np.pi / 4 * (outer**4 - inner**4)
        return np.pi * (outer**2 - inner**2), second, second, 0.0, 2 * second
    assert prop.beam_type == "BOX"
    width, height, flange, web = prop.dim
    inside = (width - 2 * web, height - 2 * flange)
    middle = (width - web, height - flange)
    area = width * height - inside[0] * inside[1]
    i1 = (width * height**3 - inside[0] * inside[1] ** 3) / 12
    i2 = (height * width**3 - inside[1] * inside[0] ** 3) / 12
    # Bredt's formula.
    torsion = 2 * flange * web * (middle[0] * middle[1]) ** 2 / (middle[0] * flange + middle[1] * web)
    return area, i1, i2, 0.0, torsion


class Beam:
    """An element: its ends with offsets, its axes as rows, length and section."""

    def __init__(self, element, places):
        grids = element.nodes_ref
        self.grids = [grid.nid for grid in grids]
        first = axes(grids[0].cd_ref, places[grids[0].nid])
        if element.g0:
            direction = places[element.g0] - places[grids[0].nid]
        else:
            direction = first @ element.x if element.offt[0] == "G" else np.array(element.x, dtype=float)
        own = self.rows(places[self.grids[1]] - places[self.grids[0]], direction).T
        self.ends = []
        for grid, offset, letter in zip(grids, (element.wa, element.wb), element.offt[1:]):
            of = own if letter == "O" else axes(grid.cd_ref, places[grid.nid])
            self.ends.append(places[grid.nid] + of @ np.array(offset, dtype=float))
        along = self.ends[1] - self.ends[0]
        self.length = np.linalg.norm(along)
        self.axes = self.rows(along, direction)
        self.area, self.i1, self.i2, self.i12, self.torsion = section(element)
        prop = element.pid_ref
        self.material = prop.mid_ref
        self.mass = prop.MassPerLength() * self.length
        is_beam = element.type == "CBEAM"
        other = 0.5 * (prop.nsia + prop.nsib) if is_beam else 0.0
        self.polar = (self.material.rho * (self.i1 + self.i2) + other) * self.length if is_beam else 0.0

    @staticmethod
    def rows(along, direction):
        x = along / np.linalg.norm(along)
        y = direction - x * (x @ direction)
        y /= np.linalg.norm(y)
        return np.array([x, y, np.cross(x, y)])

    def inertia(self):
        """Of the element about its middle."""
        along, x = self.ends[1] - self.ends[0], self.axes[0]
        rod = self.mass / 12 * (along @ along * np.eye(3) - np.outer(along, along))
        return rod + 0.5 * self.polar * (np.eye(3) + np.outer(x, x))

    def matrices(self):
        """Stiffness and mass of both ends, each three displacements and three rotations in the basic axes."""
        young, shear, length = self.material.e, self.material.g, self.length
        stiffness = np.zeros((12, 12))
        pair = np.array([[1, -1], [-1, 1]]) / length
        stiffness[np.ix_([0, 6], [0, 6])] = young * self.area * pair
        stiffness[np.ix_([3, 9], [3, 9])] = shear * self.torsion * pair
        bending = np.array(
            [[12, 6 * length, -12, 6 * length], [6 * length, 4 * length**2, -6 * length, 2 * length**2]]
            + [[-12, -6 * length, 12, -6 * length], [6 * length, 2 * length**2, -6 * length, 4 * length**2]]
        ) * (young / length**3)
        # Along y with rotations about z, along z with rotations about y, which are minus its slopes.
        aside, up, sign = [1, 5, 7, 11], [2, 4, 8, 10], np.array([1, -1, 1, -1])
        stiffness[np.ix_(aside, aside)] += bending * self.i1
        stiffness[np.ix_(up, up)] += bending * self.i2 * np.outer(sign, sign)
        stiffness[np.ix_(aside, up)] += bending * self.i12 * sign[None, :]
        stiffness[np.ix_(up, aside)] += bending * self.i12 * sign[:, None]
        mass = np.zeros((12, 12))
        half = np.diag([self.mass / 2] * 3 + [self.polar / 2, self.polar / 4, self.polar / 4])
        for s in GAUSS:
            shapes = np.array([1 - 3 * s**2 + 2 * s**3, length * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, length * (s**3 - s**2)])
            slopes = np.array([(6 * s * s - 6 * s) / length, 1 - 4 * s + 3 * s * s, (6 * s - 6 * s * s) / length, 3 * s * s - 2 * s])
            at = np.zeros((6, 12))
            at[0, [0, 6]] = at[3, [3, 9]] = 1 - s, s
            at[1, aside], at[5, aside] = shapes, slopes
            at[2, up], at[4, up] = shapes * sign, -slopes * sign
            mass += at.T @ half @ at
        turn = np.kron(np.eye(4), self.axes)
        return turn.T @ stiffness @ turn, turn.T @ mass @ turn


class Lump:
    """A CONM2: its mass, centre, and inertia about it in the basic axes."""

    def __init__(self, element, places):
        self.grid = element.nid_ref.nid
        self.mass = element.mass
        i11, i21, i22, i31, i32, i33 = element.I
        local = np.array([[i11, -i21, -i31], [-i21, i22, -i32], [-i31, -i32, i33]])
        place = places[self.grid]
        of = axes(element.cid_ref, place) if element.Cid() > 0 else np.eye(3)
        self.inertia = of @ local @ of.T
        self.centre = np.array(element.X, dtype=float) if element.Cid() == -1 else place + of @ element.X


class Frame:
    """All of it."""

    def __init__(self, model):
        self.factor = model.params["WTMASS"].values[0] if "WTMASS" in model.params else 1.0
        self.places = {grid: node.get_position() for grid, node in model.nodes.items()}
        self.beams = [Beam(element, self.places) for element in model.elements.values()]
        self.lumps = [Lump(element, self.places) for element in model.masses.values()]
        self.head = {grid: grid for grid in model.nodes}
        for link in model.rigid_elements.values():
            for grid in link.dependent_nodes:
                old, new = self.head[grid], self.head[link.gn]
                self.head = {of: new if head == old else head for of, head in self.head.items()}

    def mass_properties(self):
        """Mass, centre, inertia about the centre."""
        parts = [(beam.mass, 0.5 * (beam.ends[0] + beam.ends[1]), beam.inertia()) for beam in self.beams]
        parts += [(lump.mass, lump.centre, lump.inertia) for lump in self.lumps]
        mass = sum(part[0] for part in parts)
        centre = sum(part[0] * part[1] for part in parts) / mass
        arms = [(part, place - centre, own) for part, place, own in parts]
        inertia = sum(own + part * (arm @ arm * np.eye(3) - np.outer(arm, arm)) for part, arm, own in arms)
        return self.factor * mass, centre, self.factor * inertia

    def frequencies(self, root):
        """Hz, ascending, with the body of a grid held."""
        bodies = sorted({self.head[grid] for beam in self.beams for grid in beam.grids})
        start = {body: 6 * place for place, body in enumerate(bodies)}
        stiffness, mass = np.zeros((2, 6 * len(bodies), 6 * len(bodies)))

        def moved(grid, place):
            """What a point of a body does by what the body's own grid does, and where that stands."""
            body = self.head[grid]
            point = np.eye(6)
            point[:3, 3:] = -cross(place - self.places[body])
            return point, range(start[body], start[body] + 6)

        for beam in self.beams:
            ends = [moved(grid, end) for grid, end in zip(beam.grids, beam.ends)]
            both = np.zeros((12, 12))
            both[:6, :6], both[6:, 6:] = ends[0][0], ends[1][0]
            at = np.ix_([*ends[0][1], *ends[1][1]], [*ends[0][1], *ends[1][1]])
            of_stiffness, of_mass = beam.matrices()
            stiffness[at] += both.T @ of_stiffness @ both
            mass[at] += both.T @ of_mass @ both
        for lump in self.lumps:
            point, at = moved(lump.grid, lump.centre)
            own = np.zeros((6, 6))
            own[:3, :3], own[3:, 3:] = lump.mass * np.eye(3), lump.inertia
            mass[np.ix_(at, at)] += point.T @ own @ point
        free = [row for body in bodies if body != self.head[root] for row in range(start[body], start[body] + 6)]
        flexibility = np.linalg.solve(stiffness[np.ix_(free, free)], self.factor * mass[np.ix_(free, free)])
        roots = np.sort(np.real(np.linalg.eigvals(flexibility)))[::-1]
        return 1 / np.sqrt(roots[roots > 1e-14]) / (2 * np.pi)
