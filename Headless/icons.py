#!/usr/bin/env python3
"""Draws the package's icons: Unity takes no vector graphics for them. Discs in 64 x 64 pixels, so that they are still dots at 16."""
import os, struct, zlib

SIZE, SUB = 64, 4
FOLDER = os.path.join(os.path.dirname(__file__), "../Packages/com.fastpoints.dots/Editor/Icons")
LOW, MIDDLE, HIGH, GREY = (58, 82, 180), (38, 160, 140), (246, 190, 60), (150, 150, 150)


def mix(a, b, t):
    return tuple(round(x + (y - x) * t) for x, y in zip(a, b))


def by_height(y):
    t = 1 - y / SIZE
    return mix(LOW, MIDDLE, t * 2) if t < 0.5 else mix(MIDDLE, HIGH, t * 2 - 1)


def in_cloud(x, y):
    lobes = ((17, 43, 14), (31, 27, 20), (48, 41, 13))
    return y < 55 and any((x - a) ** 2 + (y - b) ** 2 < r * r for a, b, r in lobes)


def dots(step, shift, radius):
    for row, y in enumerate(range(10, SIZE - 3, step)):
        for x in range(5 + (shift if row % 2 else 0), SIZE - 4, step):
            if in_cloud(x, y):
                yield x, y, radius


def disc(x, y, radius, color):
    return lambda u, v: color if (u - x) ** 2 + (v - y) ** 2 <= radius * radius else None


def box(left, top, right, bottom, color):
    return lambda u, v: color if left <= u <= right and top <= v <= bottom else None


def write(name, shapes):
    rows = b""
    for y in range(SIZE):
        rows += b"\0"
        for x in range(SIZE):
            seen = []
            for i in range(SUB * SUB):
                u, v = x + (i % SUB + 0.5) / SUB, y + (i // SUB + 0.5) / SUB
                seen += [c for c in (s(u, v) for s in reversed(shapes)) if c][:1]
            color = tuple(sum(c[i] for c in seen) // len(seen) for i in range(3)) if seen else (0, 0, 0)
            rows += bytes(color) + bytes([255 * len(seen) // (SUB * SUB)])
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 6, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


cloud = list(dots(9, 4, 3.9))
write("PointCloud.png", [disc(x, y, r, by_height(y)) for x, y, r in cloud])
write("PointCloudOrigin.png", [disc(x, y - 6, r, by_height(y)) for x, y, r in cloud] +
      [box(28, 34, 33, 63, GREY), box(14, 53, 48, 58, GREY), disc(30.5, 55.5, 7, HIGH)])
edge = [box(18, 14, 22, 56, GREY), box(18, 14, 60, 18, GREY), box(56, 14, 60, 56, GREY), box(18, 52, 60, 56, GREY)]
write("PointCloudClipBox.png", [disc(x, y, r if x > 20 and y > 16 else r * 0.6, by_height(y) if x > 20 and y > 16 else GREY)
                                for x, y, r in cloud] + edge)
