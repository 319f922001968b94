"""Draws model.png, the icon of the FMU: a business jet from above.

Run it in this folder; it needs nothing but Python. Lengths are in pixels of the finished icon.
"""

import struct
import zlib

SIZE = 256
SAMPLES = 4  # per pixel and direction

SKY, WHITE, GREY, ORANGE, NAVY = (27, 73, 118), (245, 248, 251), (190, 203, 216), (242, 160, 61), (13, 38, 64)


def mirrored(right):
    """A polygon of the right half, given from its front centre to its rear centre, with its mirror image."""
    return right + [(SIZE - x, y) for x, y in reversed(right)]


FUSELAGE = mirrored([(128, 18), (134, 26), (139, 42), (141, 70), (141, 170), (136, 205), (131, 236), (128, 240)])
WING = mirrored([(140, 104), (186, 112), (246, 118), (247, 127), (188, 136), (140, 146)])
AILERON = [(206, 126.5), (244, 123), (245, 127), (206, 133)]
TAIL = mirrored([(128, 206), (172, 214), (173, 223), (130, 232)])
ELEVATOR = [(134, 227), (171, 219.5), (172.5, 223), (134, 231)]
ENGINE = [(143, 152), (152, 150), (154, 156), (153, 182), (149, 186), (144, 184)]
FIN = mirrored([(128, 196), (129.5, 204), (130, 238), (128, 244)])
WINDSCREEN = mirrored([(128, 34), (135, 38), (136.5, 45), (128, 42)])


def both(polygon):
    return [polygon, [(SIZE - x, y) for x, y in polygon]]


LAYERS = [(GREY, polygon) for polygon in both(ENGINE)]
LAYERS += [(WHITE, WING), (WHITE, TAIL), (WHITE, FUSELAGE), (GREY, FIN), (NAVY, WINDSCREEN)]
LAYERS += [(ORANGE, polygon) for polygon in both(AILERON) + both(ELEVATOR)]


def inside(polygon, x, y):
    """Even-odd rule."""
    found = False
    for (x1, y1), (x2, y2) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            found = not found
    return found


def in_badge(x, y, radius=40):
    """The square with rounded corners behind the aircraft."""
    dx = max(radius - x, x - (SIZE - radius), 0)
    dy = max(radius - y, y - (SIZE - radius), 0)
    return dx * dx + dy * dy <= radius * radius


def sample(x, y):
    """Colour and opacity at a point."""
    if not in_badge(x, y):
        return (0, 0, 0, 0)
    for colour, polygon in reversed(LAYERS):
        if inside(polygon, x, y):
            return (*colour, 255)
    return (*SKY, 255)


def pixel(column, row):
    """Mean of the samples, colours weighted by opacity."""
    places = [(i + 0.5) / SAMPLES for i in range(SAMPLES)]
    samples = [sample(column + dx, row + dy) for dx in places for dy in places]
    opacity = sum(s[3] for s in samples)
    colour = [round(sum(s[c] * s[3] for s in samples) / opacity) if opacity else 0 for c in range(3)]
    return bytes([*colour, round(opacity / len(samples))])


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


rows = (b"\0" + b"".join(pixel(column, row) for column in range(SIZE)) for row in range(SIZE))
with open("model.png", "wb") as png:
    png.write(b"\x89PNG\r\n\x1a\n")
    png.write(chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 6, 0, 0, 0)))
    png.write(chunk(b"IDAT", zlib.compress(b"".join(rows), 9)))
    png.write(chunk(b"IEND", b""))
