#!/usr/bin/env python3
"""Draws the two pictures of docs/dual_pass.md: docs/ring_of_pieces.svg and
docs/turn_round_cut_edge.svg. Wants nothing but Python 3.

    docs/dual_pass_figures.py
"""

import math
import pathlib

BLUE, ORANGE, GREY = "#1f6fb4", "#d9730d", "#9aa0a6"
DARK, GREEN, RED = "#222222", "#2e8b57", "#b3261e"
SUBSCRIPTS = "₀₁₂₃₄"
FONT = "DejaVu Sans, Helvetica, Arial, sans-serif"


class Drawing:
    def __init__(self, width, height, title):
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" font-family="{FONT}" font-size="15">',
            f"<title>{title}</title>",
            f'<rect width="{width}" height="{height}" fill="white"/>',
        ]

    def path(self, points, stroke=DARK, width=1.5, fill="none", opacity=1.0, dash="", closed=False):
        steps = " L ".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.parts.append(
            f'<path d="M {steps}{" Z" if closed else ""}" stroke="{stroke}" '
            f'stroke-width="{width}" fill="{fill}" fill-opacity="{opacity}" '
            f'stroke-linecap="round" stroke-linejoin="round"'
            + (f' stroke-dasharray="{dash}"' if dash else "")
            + "/>"
        )

    def arrow_head(self, before, tip, colour):
        angle = math.atan2(tip[1] - before[1], tip[0] - before[0])
        wings = [
            (tip[0] - 11 * math.cos(angle + turn), tip[1] - 11 * math.sin(angle + turn))
            for turn in (-0.42, 0.42)
        ]
        self.path([wings[0], tip, wings[1]], colour, 1, colour, 1.0, closed=True)

    def dot(self, at, radius=4.0, fill=DARK):
        self.parts.append(
            f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius}" fill="{fill}" '
            'stroke="white" stroke-width="1"/>'
        )

    def text(self, at, text, colour=DARK, anchor="middle", size=15, weight="normal"):
        self.parts.append(
            f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="{colour}" text-anchor="{anchor}" '
            f'font-size="{size}" font-weight="{weight}" paint-order="stroke" stroke="white" '
            f'stroke-width="4" stroke-linejoin="round">{text}</text>'
        )

    def write(self, name):
        file = pathlib.Path(__file__).resolve().parent / name
        file.write_text("\n".join([*self.parts, "</svg>", ""]), encoding="utf-8")


def view_from_aside(centre, scale):
    """(x, y, z) to the picture: x to the right and down, y to the right and up, z up."""

    def project(x, y, z):
        return (
            centre[0] + scale * (0.95 * x + 0.52 * y),
            centre[1] + scale * (0.20 * x - 0.42 * y - z),
        )

    return project


def arc(centre, radius, first, last, steps=48):
    """Angles in degrees, anticlockwise."""
    return [
        (
            centre[0] + radius * math.cos(math.radians(first + (last - first) * i / steps)),
            centre[1] - radius * math.sin(math.radians(first + (last - first) * i / steps)),
        )
        for i in range(steps + 1)
    ]


AXES = [(1, 0), (0, 1), (-1, 0), (0, -1)]  # of the four faces round an edge, anticlockwise


def ring_of_pieces():
    title = "The ring of pieces round an interior edge, with labels that sum to 0"
    drawing = Drawing(820, 456, title)
    # Generators in the labels of the pieces, in the order of AXES.
    labels = [("1",), ("1", "2"), (), ("2",)]
    shown = ["{1}", "{1, 2}", "0", "{2}"]
    colours = {"1": BLUE, "2": ORANGE}

    drawing.text((205, 32), "from aside", size=16, weight="bold")
    at = view_from_aside((205, 225), 120)
    order = [1, 2, 0, 3]  # from the back to the front
    for k in order:
        x, y = AXES[k]
        face = [at(0, 0, -1), at(x, y, -1), at(x, y, 1), at(0, 0, 1)]
        tint = {0: BLUE, 1: "#7b6a94", 2: GREY, 3: ORANGE}[k]
        drawing.path(face, GREY, 1.2, tint, 0.22 if labels[k] else 0.12, closed=True)
    drawing.path([at(0, 0, -1.15), at(0, 0, 1.15)], DARK, 3.5)
    drawing.text((at(0, 0, 1.15)[0], at(0, 0, 1.15)[1] - 8), "interior edge e")
    places = ((0, -1, (14, -12)), (1, 1, (18, 16)), (2, 1, (-14, 16)), (3, -1, (-18, -8)))
    for k, z, shift in places:
        x, y = at(AXES[k][0], AXES[k][1], z)
        drawing.text((x + shift[0], y + shift[1]), f"p{SUBSCRIPTS[k + 1]}")

    centre = (585, 212)
    drawing.text((centre[0], 32), "along the edge", size=16, weight="bold")
    side = 140
    for sx, sy, name in ((1, 1, "A"), (-1, 1, "B"), (-1, -1, "C"), (1, -1, "D")):
        x0, y0 = centre[0], centre[1]
        x1, y1 = x0 + sx * side, y0 - sy * side
        square = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        drawing.path(square, "#c8ccd0", 1, "#f4f6f8", 1.0, closed=True)
        drawing.text((x0 + sx * 112, y0 - sy * 104), f"cell {name}", "#5f6368", size=13)
    for k, (x, y) in enumerate(AXES):
        far = (centre[0] + side * x, centre[1] - side * y)
        if not labels[k]:
            drawing.path([centre, far], GREY, 3)
        for j, name in enumerate(labels[k]):
            # Two generators: two lines beside each other.
            shift = (j - (len(labels[k]) - 1) / 2) * 7
            drawing.path(
                [
                    (centre[0] + shift * abs(y), centre[1] + shift * abs(x)),
                    (far[0] + shift * abs(y), far[1] + shift * abs(x)),
                ],
                colours[name],
                4,
            )
    walk = arc(centre, 62, 40, 393)
    drawing.path(walk, RED, 2, dash="7 5")
    drawing.arrow_head(walk[-2], walk[-1], RED)
    for degrees in (90, 180, 270, 360):
        drawing.dot(arc(centre, 62, degrees, degrees, 1)[0], 5, RED)
    drawing.dot(centre, 7)
    drawing.text((centre[0] + 14, centre[1] + 21), "e", anchor="start")
    place = [(side + 34, 6), (0, -side - 10), (-side - 22, 6), (0, side + 22)]
    for k, (x, y) in enumerate(place):
        name = f"p{SUBSCRIPTS[k + 1]}: {shown[k]}"
        drawing.text((centre[0] + x, centre[1] + y), name)
    drawing.text((410, 412), "the walk round e crosses all four:  {1} + {1, 2} + 0 + {2} = 0", RED)
    drawing.text((272, 440), "pieces with 1 in their label: surface S₁", BLUE)
    drawing.text((582, 440), "with 2: surface S₂", ORANGE)
    drawing.write("ring_of_pieces.svg")


def turn_round_cut_edge():
    drawing = Drawing(860, 470, "A walk on M turns round a cut grid edge")
    drawing.text((215, 30), "from aside", size=16, weight="bold")
    at = view_from_aside((215, 205), 122)
    # The pieces below M, then M, then the half of the edge above it.
    for k in [1, 2, 0, 3]:
        x, y = AXES[k]
        face = [at(0, 0, 0), at(x, y, 0), at(x, y, -1), at(0, 0, -1)]
        drawing.path(face, GREY, 1.2, BLUE if k in (0, 1) else GREY, 0.20, closed=True)
    drawing.path([at(0, 0, 0), at(0, 0, -1.15)], DARK, 3.5)
    drawing.text((at(0, 0, -1.15)[0], at(0, 0, -1.15)[1] + 20), "inside half of e")
    circle = [
        at(0.42 * math.cos(math.radians(a)), 0.42 * math.sin(math.radians(a)), -0.42)
        for a in range(45, 226, 5)
    ]
    start, end = at(0.8, 0.8, -0.3), at(-0.8, -0.8, -0.3)
    pushed = [start, *circle, end]
    drawing.path(pushed, GREEN, 2.5, dash="7 5")
    drawing.arrow_head(pushed[-2], pushed[-1], GREEN)
    sheet = [at(1, 1, 0), at(-1, 1, 0), at(-1, -1, 0), at(1, -1, 0)]
    drawing.path(sheet, "#b9a77a", 1.4, "#efe3bf", 0.42, closed=True)
    drawing.text(at(0.72, -0.82, -0.03), "M", "#7a6a3a", size=17, weight="bold")
    on_m = [at(0.8, 0.8, 0), at(0, 0, 0), at(-0.8, -0.8, 0)]
    drawing.path(on_m, RED, 3)
    drawing.arrow_head(on_m[1], on_m[2], RED)
    drawing.path([at(0, 0, 0), at(0, 0, 1.05)], DARK, 3.5)
    drawing.text((at(0, 0, 1.05)[0], at(0, 0, 1.05)[1] - 8), "outside half of e")
    shifts = ((13, 2), (15, -8), (-13, 4))
    for point, name, shift in zip(on_m, "uvw", shifts):
        drawing.dot(point, 5, RED)
        drawing.text((point[0] + shift[0], point[1] + shift[1]), name, RED)

    centre = (630, 214)
    side = 145
    drawing.text((centre[0], 30), "along the edge, from outside", size=16, weight="bold")
    labels = ["{3}", "{3}", "0", "0"]
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        square = [
            centre,
            (centre[0] + sx * side, centre[1]),
            (centre[0] + sx * side, centre[1] - sy * side),
            (centre[0], centre[1] - sy * side),
        ]
        drawing.path(square, "#d8c99a", 1, "#faf5e4", 1.0, closed=True)
        place = ((112, -24), (-104, -118), (-106, 32), (104, 124))[k]
        drawing.text((centre[0] + place[0], centre[1] + place[1]), f"cube {k}", "#7a6a3a", size=13)
    for k, (x, y) in enumerate(AXES):
        far = (centre[0] + side * x, centre[1] - side * y)
        drawing.path([centre, far], BLUE if labels[k] != "0" else GREY, 4)
    u = (centre[0] + 108, centre[1] - 108)
    w = (centre[0] - 108, centre[1] + 108)
    drawing.path([u, centre, w], RED, 3)
    drawing.arrow_head(centre, w, RED)
    turn = [(u[0] - 12, u[1] - 4), *arc(centre, 58, 50, 220), (w[0] - 6, w[1] - 14)]
    drawing.path(turn, GREEN, 2.5, dash="7 5")
    drawing.arrow_head(turn[-2], turn[-1], GREEN)
    for degrees in (90, 180):
        drawing.dot(arc(centre, 58, degrees, degrees, 1)[0], 5, GREEN)
    for point, name, shift in ((u, "u", (15, 6)), (centre, "v", (17, 22)), (w, "w", (6, 22))):
        drawing.dot(point, 5.5, RED)
        drawing.text((point[0] + shift[0], point[1] + shift[1]), name, RED)
    place = [(side + 36, 6), (0, -side - 10), (-side - 26, 6), (0, side + 22)]
    for k, (x, y) in enumerate(place):
        name = f"p{SUBSCRIPTS[k]}: {labels[k]}"
        drawing.text((centre[0] + x, centre[1] + y), name)
    drawing.text(
        (430, 425),
        "pushed to the inside, the walk u, v, w passes p₁ and p₂:  {3} + 0 = {3}",
        GREEN,
    )
    drawing.text(
        (430, 452),
        "round the other way it passes p₀ and "
        "p₃: {3} + 0, the same, for all four sum to 0",
        "#5f6368",
    )
    drawing.write("turn_round_cut_edge.svg")


if __name__ == "__main__":
    ring_of_pieces()
    turn_round_cut_edge()
