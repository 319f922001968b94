"""Frames of Euler-Bernoulli beams by finite elements, from a deck as pyNastran reads it: mass, centre, inertia; natural frequencies of what is
clamped. Lengths, forces and masses stay the deck's, masses times WTMASS.

Nothing here is the importer's: cubic elements, one per CBAR, CBEAM and CROD, with consistent masses or, as the elements of an aircraft file
have them, half of each at its two Gauss points; pinned ends have unknowns of their own; rigid bodies carry ends and masses by arms; places,
orientations, offsets and masses are in whatever frames their cards name. Beams are [Przemieniecki, Theory of Matrix Structural Analysis, sections 5.6 and 11.6]; a product of
inertia I12 = int y z dA couples the two planes with 12 E I12/L^3 [MYSTRAN, BAR1], and the neutral axis of a PBEAM is apart from the shear
centre, which is on the line between the ends."""

import numpy as np
from pyNastran.bdf.bdf import BDF


def read(path):
    """The deck; one without case control is bulk data from its first line on."""
    model = BDF(debug=None)
    model.read_bdf(str(path), punch="BEGIN BULK" not in path.read_text().upper())
    return model


def axes(system, place):
    """The axes of a coordinate system at a place, as columns: of a cylindrical one out, around, along."""
    rows = system.beta()
    if system.type == "CORD2C":
        angle = np.radians(system.transform_node_to_local(place)[1])
        rows = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]]) @ rows
    return rows.T


def cross(arm):
    """The matrix of arm x."""
    return np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])


def carried(arm):
    """Displacement and rotation at the end of an arm by those of the body."""
    return np.block([[np.eye(3), -cross(arm)], [np.zeros((3, 3)), np.eye(3)]])


class Frame:
    """The deck's bodies, stiffness and mass, of beams at so many points along each: two Gauss points, or eight, which are exact."""

    def __init__(self, deck, points=8):
        self.points = points
        self.factor = deck.params["WTMASS"].values[0] if "WTMASS" in deck.params else 1.0
        self.place = {grid: node.get_position() for grid, node in deck.nodes.items()}
        self.head = {grid: grid for grid in deck.nodes}
        for link in deck.rigid_elements.values():
            for grid in link.dependent_nodes:
                self.head[self.body(grid)] = self.body(link.independent_nodes[0])
        on_beams = {self.body(grid) for element in deck.elements.values() if element.type != "CBUSH" for grid in element.node_ids}
        self.first = {body: 6 * count for count, body in enumerate(sorted(on_beams))}
        self.count = 6 * len(on_beams)
        self.terms = []
        # Mass, centre and inertia about it of each part.
        self.parts = []
        for element in deck.elements.values():
            {"CROD": self.rod, "CBUSH": self.bush}.get(element.type, self.beam)(element)
        for mass in deck.masses.values():
            self.lump(mass)

    def lump(self, element):
        """A CONM2: its mass, centre, and inertia about it, in the basic axes where CID is -1, else in those of its frame at the grid."""
        xx, xy, yy, xz, yz, zz = element.I
        local = np.array([[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]])
        place = self.place[element.nid_ref.nid]
        own = axes(element.cid_ref, place) if element.Cid() > 0 else np.eye(3)
        centre = np.array(element.X, dtype=float) if element.Cid() == -1 else place + own @ element.X
        inertia = own @ local @ own.T
        self.parts.append((element.mass, centre, inertia))
        matrix = np.block([[element.mass * np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), inertia]])
        self.add([(self.body(element.nid_ref.nid), centre)], None, matrix)

    def body(self, grid):
        """The first grid of the body that a grid is on."""
        while self.head[grid] != grid:
            grid = self.head[grid]
        return grid

    def add(self, ends, stiffness, mass, free=()):
        """A matrix of points on bodies; unknowns that are free get a place of their own."""
        rows = np.zeros((6 * len(ends), 6 * len(ends)))
        places = []
        for number, (body, point) in enumerate(ends):
            rows[6 * number:6 * number + 6, 6 * number:6 * number + 6] = carried(point - self.place[body])
            places += range(self.first[body], self.first[body] + 6)
        self.terms.append((places, rows, stiffness, mass, free))

    def rod(self, element):
        """Axial force and torque; half of the mass at each end."""
        ends = [(self.body(grid), self.place[grid]) for grid in element.node_ids]
        span = ends[1][1] - ends[0][1]
        length = np.linalg.norm(span)
        along, section = span / length, element.pid_ref
        force, torque = (np.r_[a, b, -a, -b] for a, b in ((along, 0 * along), (0 * along, along)))
        material = section.mid_ref
        stiffness = material.e * section.A / length * np.outer(force, force) + material.g * section.j / length * np.outer(torque, torque)
        half = np.diag([0.5 * element.Mass()] * 3 + [0] * 3)
        self.parts += [(0.5 * element.Mass(), place, np.zeros((3, 3))) for _, place in ends]
        self.add(ends, stiffness, np.kron(np.eye(2), half))

    def bush(self, element):
        """Springs to the ground about the basic axes; those along them are taken as rigid ones by whoever clamps the grid's displacements."""
        turning = [0 if k in (None, "RIGID") else k for k in element.pid_ref.Ki[3:]]
        body = self.body(element.node_ids[0])
        self.add([(body, self.place[body])], np.diag([0, 0, 0, *turning]), np.zeros((6, 6)))

    def beam(self, element):
        """A CBAR or CBEAM."""
        grids = element.nodes_ref
        places = [self.place[grid.nid] for grid in grids]
        direction = self.direction(element, places[0])
        # Offsets by O of OFFT are in the element's axes without them.
        own = rows(places[1] - places[0], direction).T
        ends = []
        for grid, place, offset, letter in zip(grids, places, (element.wa, element.wb), element.offt[1:]):
            frame = own if letter == "O" else axes(grid.cd_ref, place)
            ends.append((self.body(grid.nid), place + frame @ np.asarray(offset, float)))
        span = ends[1][1] - ends[0][1]
        length = np.linalg.norm(span)
        turn = rows(span, direction)
        section, material = element.pid_ref, element.pid_ref.mid_ref
        stiffness = local_stiffness(second_moments(section), (material.e, material.g), length)
        neutral = np.zeros(3)
        if section.type == "PBEAM":
            neutral = np.array([0, section.n1a, section.n2a])
            at_neutral = np.eye(12)
            for first in (0, 6):
                at_neutral[first, first + 3:first + 6] = -cross(neutral)[0]
            stiffness = at_neutral.T @ stiffness @ at_neutral
        # pyNastran's own mass of an element leaves out offsets.
        whole, about = section.MassPerLength() * length, polar(element) * length
        mass = local_mass(whole, about, neutral, length, self.points)
        along = whole / 12 * (span @ span * np.eye(3) - np.outer(span, span))
        disc = 0.5 * about * (np.eye(3) + np.outer(turn[0], turn[0]))
        self.parts.append((whole, 0.5 * (ends[0][1] + ends[1][1]) + turn.T @ neutral, along + disc))
        turns = np.kron(np.eye(4), turn)
        free = [number for first, digits in ((0, element.pa), (6, element.pb)) for number in pins(first, digits)]
        self.add(ends, (stiffness, turns), (mass, turns), free)

    def direction(self, element, place):
        """In the plane of the element's x and y axes: to a grid, or in the frame of displacements of its first one, else the basic one."""
        if element.g0:
            return self.place[element.g0] - place
        given = np.asarray(element.x, float)
        return axes(element.nodes_ref[0].cd_ref, place) @ given if element.offt[0] == "G" else given

    def mass_properties(self):
        """Mass, centre, inertia about the centre."""
        mass = sum(part[0] for part in self.parts)
        centre = sum(part[0] * part[1] for part in self.parts) / mass
        arms = [(part, place - centre, own) for part, place, own in self.parts]
        inertia = sum(own + part * (arm @ arm * np.eye(3) - np.outer(arm, arm)) for part, arm, own in arms)
        return self.factor * mass, centre, self.factor * inertia

    def frequencies(self, clamped, components=range(6)):
        """Natural frequencies, rad/s, ascending, with components of a grid held."""
        count = self.count + sum(len(free) for *_, free in self.terms)
        stiffness, mass = np.zeros((count, count)), np.zeros((count, count))
        own = self.count
        for places, rows, k, m, free in self.terms:
            select = np.zeros((len(rows), count))
            select[:, places] = rows
            if isinstance(k, tuple):
                select = k[1] @ select
                k, m = k[0], m[0]
            for number in free:
                select[number] = 0
                select[number, own] = 1
                own += 1
            if k is not None:
                stiffness += select.T @ k @ select
            mass += self.factor * select.T @ m @ select
        held = {self.first[self.body(clamped)] + component for component in components}
        # Free unknowns that nothing strains, as a rotation of a rod's end, are left out.
        kept = [place for place in range(count) if place not in held and stiffness[place, place] > 0]
        stiffness, mass = stiffness[np.ix_(kept, kept)], mass[np.ix_(kept, kept)]
        lower = np.linalg.cholesky(stiffness)
        flexible = np.linalg.solve(lower, np.linalg.solve(lower, mass).T)
        squares = np.linalg.eigvalsh(0.5 * (flexible + flexible.T))
        return 1 / np.sqrt(squares[squares > 1e-9 * squares.max()][::-1])


def rows(along, direction):
    """The axes of a beam, as rows."""
    x = along / np.linalg.norm(along)
    y = direction - x * (x @ direction)
    y /= np.linalg.norm(y)
    return np.array([x, y, np.cross(x, y)])


def pins(first, digits):
    """Unknowns of an end that are free."""
    return [first + int(digit) - 1 for digit in str(digits or 0) if digit != "0"]


def second_moments(section):
    """Area, I1, I2, I12, J; of boxes torsion by Bredt."""
    if section.type == "PBARL" and section.Type == "BOX":
        width, height, level, upright = section.dim
        inner = (width - 2 * upright, height - 2 * level)
        i1 = (width * height**3 - inner[0] * inner[1] ** 3) / 12
        i2 = (height * width**3 - inner[1] * inner[0] ** 3) / 12
        middle = (width - upright, height - level)
        torsion = 4 * (middle[0] * middle[1]) ** 2 / (2 * middle[0] / level + 2 * middle[1] / upright)
        return width * height - inner[0] * inner[1], i1, i2, 0.0, torsion
    if section.type == "PBARL" and section.Type == "TUBE":
        outer, inner = section.dim
        second = np.pi / 4 * (outer**4 - inner**4)
        return np.pi * (outer**2 - inner**2), second, second, 0.0, 2 * second
    if section.type == "PBAR":
        return section.A, section.i1, section.i2, section.i12, section.j
    if section.type == "PBEAM":
        return tuple(0.5 * (of[0] + of[-1]) for of in (section.A, section.i1, section.i2, section.i12, section.j))
    raise NotImplementedError(section.type)


def polar(element):
    """About its axis a CBEAM has rho (I1 + I2) per length and what NSI says, a CBAR nothing."""
    if element.type == "CBAR":
        return 0.0
    section = element.pid_ref
    _, i1, i2, _, _ = second_moments(section)
    return section.mid_ref.rho * (i1 + i2) + 0.5 * (section.nsia + section.nsib)


def local_stiffness(section, moduli, length):
    """Of a beam in its own axes: displacements and rotations at one end, then at the other."""
    (area, i1, i2, i12, torsion), (young, shear) = section, moduli
    matrix = np.zeros((12, 12))
    difference = np.array([[1, -1], [-1, 1]])
    matrix[np.ix_([0, 6], [0, 6])] = young * area / length * difference
    matrix[np.ix_([3, 9], [3, 9])] = shear * torsion / length * difference
    one = length
    bending = young / length**3 * np.array(
        [[12, 6 * one, -12, 6 * one], [6 * one, 4 * one**2, -6 * one, 2 * one**2], [-12, -6 * one, 12, -6 * one], [6 * one, 2 * one**2, -6 * one, 4 * one**2]]
    )
    in_y, in_z, sign = [1, 5, 7, 11], [2, 4, 8, 10], np.array([1, -1, 1, -1])
    matrix[np.ix_(in_y, in_y)] += i1 * bending
    matrix[np.ix_(in_z, in_z)] += i2 * bending * np.outer(sign, sign)
    matrix[np.ix_(in_y, in_z)] += i12 * bending * sign
    matrix[np.ix_(in_z, in_y)] += i12 * (bending * sign).T
    return matrix


def local_mass(mass, polar_inertia, centre, length, count):
    """Of a beam whose mass lies along a line through a place in the section, at so many of Gauss's points."""
    points, weights = np.polynomial.legendre.leggauss(count)
    matrix = np.zeros((12, 12))
    for s, weight in zip(0.5 + 0.5 * points, 0.5 * weights):
        cubic = np.array([1 - 3 * s**2 + 2 * s**3, length * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, length * (s**3 - s**2)])
        slope = np.array([(6 * s**2 - 6 * s) / length, 1 - 4 * s + 3 * s**2, (6 * s - 6 * s**2) / length, 3 * s**2 - 2 * s])
        sign = np.array([1, -1, 1, -1])
        shape = np.zeros((6, 12))
        shape[0, [0, 6]] = shape[3, [3, 9]] = 1 - s, s
        shape[1, [1, 5, 7, 11]], shape[5, [1, 5, 7, 11]] = cubic, slope
        shape[2, [2, 4, 8, 10]], shape[4, [2, 4, 8, 10]] = cubic * sign, -slope * sign
        at_centre = carried(centre) @ shape
        own = np.diag([mass] * 3 + [polar_inertia] + [polar_inertia / 2] * 2)
        matrix += weight * at_centre.T @ own @ at_centre
    return matrix
