# SPDX-License-Identifier: MIT
"""FLIP of the paper of 2020, pixel by pixel and weight by weight: slow, and without a line of shd.golden.

Pictures are lists [height][width] of (r, g, b), sRGB-coded in [0, 1].
"""
import math

# XYZ of the primaries of sRGB, and of their sum, as fractions (sRGB with D65; Lindbloom, "RGB/XYZ Matrices").
M = [[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
     [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
     [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]]
WHITE = [sum(row) for row in M]


def linear(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def to_xyz(rgb):
    """XYZ over that of white."""
    return [sum(M[i][j] * rgb[j] for j in range(3)) / WHITE[i] for i in range(3)]


def from_xyz(xyz):
    """Linear RGB by Cramer's rule."""
    target = [xyz[i] * WHITE[i] for i in range(3)]

    def determinant(m):
        return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))

    whole = determinant(M)
    return [determinant([[target[i] if j == column else M[i][j] for j in range(3)] for i in range(3)]) / whole
            for column in range(3)]


def ycxcz(rgb):
    x, y, z = to_xyz([linear(v) for v in rgb])
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def lab(rgb):
    def curve(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t * 841 / 108 + 4 / 29
    x, y, z = (curve(v) for v in to_xyz(rgb))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def hunt(rgb):
    lightness, a, b = lab(rgb)
    return lightness, 0.01 * lightness * a, 0.01 * lightness * b


def distance(first, second):
    return abs(first[0] - second[0]) + math.sqrt((first[1] - second[1]) ** 2 + (first[2] - second[2]) ** 2)


def c_max():
    return distance(hunt((0, 1, 0)), hunt((0, 0, 1))) ** 0.7


def at(plane, y, x):
    return plane[min(max(y, 0), len(plane) - 1)][min(max(x, 0), len(plane[0]) - 1)]


def correlate(plane, matrix, radius):
    return [[sum(matrix[j + radius][i + radius] * at(plane, y + j, x + i)
                 for j in range(-radius, radius + 1) for i in range(-radius, radius + 1))
             for x in range(len(plane[0]))] for y in range(len(plane))]


def sensitivity(ppd, a1, b1, a2, b2):
    """The matrix of the contrast sensitivity filter, and its radius."""
    radius = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * ppd)

    def weight(i, j):
        square = (i / ppd) ** 2 + (j / ppd) ** 2
        return (a1 * math.sqrt(math.pi / b1) * math.exp(-math.pi ** 2 * square / b1)
                + a2 * math.sqrt(math.pi / b2) * math.exp(-math.pi ** 2 * square / b2))
    matrix = [[weight(i, j) for i in range(-radius, radius + 1)] for j in range(-radius, radius + 1)]
    total = sum(map(sum, matrix))
    return [[w / total for w in row] for row in matrix], radius


def perceived(planes, ppd):
    """Hunt-adjusted L*a*b* of each pixel of the filtered picture."""
    filters = [(1, 0.0047, 0, 1e-5), (1, 0.0053, 0, 1e-5), (34.1, 0.04, 13.5, 0.025)]
    filtered = [correlate(plane, *sensitivity(ppd, *f)) for plane, f in zip(planes, filters)]
    out = []
    for rows in zip(*filtered):
        out.append([])
        for value, cx, cz in zip(*rows):
            y = (value + 16) / 116
            rgb = from_xyz([y + cx / 500, y, y - cz / 200])
            out[-1].append(hunt([min(max(v, 0.0), 1.0) for v in rgb]))
    return out


def feature(plane, ppd, point):
    """Length of the response of the edge or point detector at each pixel."""
    deviation = 0.5 * 0.082 * ppd
    radius = math.ceil(3 * deviation)
    matrix = []
    for j in range(-radius, radius + 1):
        matrix.append([])
        for i in range(-radius, radius + 1):
            bell = math.exp(-(i * i + j * j) / (2 * deviation ** 2))
            matrix[-1].append(bell * ((i * i / deviation ** 2 - 1) if point else -i))
    positive = sum(w for row in matrix for w in row if w > 0)
    negative = -sum(w for row in matrix for w in row if w < 0)
    matrix = [[w / (positive if w > 0 else negative) for w in row] for row in matrix]
    along_x = correlate(plane, matrix, radius)
    along_y = correlate(plane, [list(row) for row in zip(*matrix)], radius)
    return [[math.hypot(gx, gy) for gx, gy in zip(*rows)] for rows in zip(along_x, along_y)]


def flip(reference, picture, ppd):
    pictures = []
    for source in (reference, picture):
        opponent = [[ycxcz(p) for p in row] for row in source]
        planes = [[[p[c] for p in row] for row in opponent] for c in range(3)]
        luminance = [[(v + 16) / 116 for v in row] for row in planes[0]]
        pictures.append((perceived(planes, ppd), feature(luminance, ppd, False), feature(luminance, ppd, True)))
    (colour1, edge1, point1), (colour2, edge2, point2) = pictures
    largest, out = c_max(), []
    for y in range(len(reference)):
        out.append([])
        for x in range(len(reference[0])):
            power = distance(colour1[y][x], colour2[y][x]) ** 0.7
            knee = 0.4 * largest
            error = power / knee * 0.95 if power < knee else 0.95 + 0.05 * (power - knee) / (largest - knee)
            change = max(abs(edge1[y][x] - edge2[y][x]), abs(point1[y][x] - point2[y][x])) / math.sqrt(2)
            out[-1].append(error ** (1 - math.sqrt(change)))
    return out
