# PNG files and seamless noise for tools/make_textures, of the Python standard library alone.
import math
import random
import struct
import zlib


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def filtered(row, above, size):
    """The row behind the PNG filter (none, left, up or Paeth) with the smallest differences."""
    left = bytes(size) + row[:-size]
    corner = bytes(size) + above[:-size]

    def paeth(a, b, c):
        pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
        return a if pa <= pb and pa <= pc else b if pb <= pc else c

    candidates = {0: row,
                  1: bytes(x - a & 255 for x, a in zip(row, left)),
                  2: bytes(x - b & 255 for x, b in zip(row, above)),
                  4: bytes(x - paeth(a, b, c) & 255 for x, a, b, c in zip(row, left, above, corner))}
    best = min(candidates, key=lambda kind: sum(min(x, 256 - x) for x in candidates[kind]))
    return bytes([best]) + candidates[best]


def write_png(path, width, height, texel):
    """texel(u, v) is a number or (r, g, b) in [0, 1], asked for at the centres of the texels."""
    channels = 3 if isinstance(texel(0.5, 0.5), tuple) else 1
    data, above = bytearray(), bytes(width * channels)
    for j in range(height):
        v = 1 - (j + 0.5) / height
        values = [texel((i + 0.5) / width, v) for i in range(width)]
        flat = values if channels == 1 else [c for value in values for c in value]
        row = bytes(int(255 * min(max(c, 0.0), 1.0) + 0.5) for c in flat)
        data += filtered(row, above, channels)
        above = row
    header = struct.pack(">IIBBBBB", width, height, 8, 0 if channels == 1 else 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) +
                     png_chunk(b"IDAT", zlib.compress(bytes(data), 9)) + png_chunk(b"IEND", b""))


def smoothstep(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def scaled(color, factor):
    return tuple(c * factor for c in color)


class Noise:
    """Smooth noise in [0, 1] with period 1 in u and v: random numbers on columns × rows points."""

    def __init__(self, seed, columns, rows):
        numbers = random.Random(seed)
        self.columns, self.rows = columns, rows
        self.table = [[numbers.random() for _ in range(columns)] for _ in range(rows)]

    def __call__(self, u, v):
        x, y = u * self.columns, v * self.rows
        i, j = math.floor(x), math.floor(y)
        s, t = x - i, y - j
        s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
        low, high = self.table[j % self.rows], self.table[(j + 1) % self.rows]
        i, k = i % self.columns, (i + 1) % self.columns
        a = low[i] + (low[k] - low[i]) * s
        return a + (high[i] + (high[k] - high[i]) * s - a) * t


class Fractal:
    """Noise of several octaves in [0, 1], each twice as fine and half as strong as the one before."""

    def __init__(self, seed, columns, rows, octaves):
        self.layers = [(Noise(seed + k, columns << k, rows << k), 0.5 ** k) for k in range(octaves)]
        self.sum = sum(weight for _, weight in self.layers)

    def __call__(self, u, v):
        return sum(weight * noise(u, v) for noise, weight in self.layers) / self.sum


class Cells:
    """How far (u, v) is from the nearest and from the second nearest of random points, and a random number of
    the nearest. One point in each of count × count cells, distances in cells, period 1."""

    def __init__(self, seed, count):
        numbers = random.Random(seed)
        self.count = count
        self.points = [[[numbers.random() for _ in range(3)] for _ in range(count)] for _ in range(count)]

    def __call__(self, u, v):
        x, y = u * self.count, v * self.count
        i, j = math.floor(x), math.floor(y)
        found = []
        for b in (j - 1, j, j + 1):
            for a in (i - 1, i, i + 1):
                point = self.points[b % self.count][a % self.count]
                found.append((math.hypot(a + point[0] - x, b + point[1] - y), point[2]))
        found.sort()
        return found[0][0], found[1][0], found[0][1]
