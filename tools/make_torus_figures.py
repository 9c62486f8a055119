#!/usr/bin/env python3
# Draws the figures of docs/torus.md as small SVG files; needs nothing but Python 3.
#
#   tools/make_torus_figures.py
import math
import pathlib

IMAGES = pathlib.Path(__file__).resolve().parent.parent / "docs" / "images"
INK, BLUE, RED, GREY = "#222", "#2166ac", "#b2182b", "#999"


class Figure:
    """An SVG in which x runs to the right and y up; `scale` pixels a unit."""

    def __init__(self, width, height, left, low, scale):
        self.width, self.height, self.left, self.low, self.scale = width, height, left, low, scale
        self.parts = []

    def at(self, x, y):
        return round((x - self.left) * self.scale, 1), round(self.height - (y - self.low) * self.scale, 1)

    def path(self, points, color=INK, width=1.5, dash=""):
        data = " ".join(f"{'ML'[i > 0]}{x} {y}" for i, (x, y) in enumerate(self.at(*p) for p in points))
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        style = f'fill="none" stroke="{color}" stroke-width="{width}"{dashes}'
        self.parts.append(f'<path d="{data}" {style}/>')

    def circle(self, x, y, radius, color=INK, fill="none"):
        cx, cy = self.at(x, y)
        size = round(radius * self.scale, 1)
        style = f'fill="{fill}" stroke="{color}" stroke-width="1.5"'
        self.parts.append(f'<circle cx="{cx}" cy="{cy}" r="{size}" {style}/>')

    def dot(self, x, y, color=INK):
        self.circle(x, y, 3 / self.scale, color, color)

    def text(self, x, y, text, color=INK, anchor="middle"):
        px, py = self.at(x, y)
        self.parts.append(f'<text x="{px}" y="{py}" fill="{color}" text-anchor="{anchor}">{text}</text>')

    def arrow(self, start, end, color=INK, width=1.5):
        self.path([start, end], color, width)
        angle, size = math.atan2(end[1] - start[1], end[0] - start[0]), 8 / self.scale
        left, right = ((end[0] - size * math.cos(angle + turn), end[1] - size * math.sin(angle + turn))
                       for turn in (0.4, -0.4))
        self.path([left, end, right], color, width)

    def arc(self, center, radius, start, end, color=INK):
        steps = [start + (end - start) * i / 24 for i in range(25)]
        points = [(center[0] + radius * math.cos(t), center[1] + radius * math.sin(t)) for t in steps]
        self.path(points, color, 1)

    def write(self, name):
        size = f'viewBox="0 0 {self.width} {self.height}" width="{self.width}" height="{self.height}"'
        font = 'font-family="serif" font-style="italic" font-size="17"'
        head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} {font}>'
        background = f'<rect width="{self.width}" height="{self.height}" fill="white"/>'
        (IMAGES / name).write_text("\n".join([head, background, *self.parts, "</svg>", ""]), encoding="utf-8")


def parameters():
    """From above the angle φ; in the half plane of that angle the tube's circle and ψ."""
    figure = Figure(640, 260, -1.75, -1.55, 84)
    r, phi, psi = 0.4, 0.75, 1.0
    for radius, color in ((1 - r, INK), (1 + r, INK), (1, GREY)):
        figure.circle(0, 0, radius, color)
    figure.arrow((-1.6, 0), (1.65, 0), GREY)
    figure.arrow((0, -1.45), (0, 1.5), GREY)
    figure.text(1.6, -0.2, "x", GREY)
    figure.text(0.13, 1.4, "y", GREY)
    direction = (math.cos(phi), math.sin(phi))
    figure.path([(0, 0), (1.55 * direction[0], 1.55 * direction[1])], BLUE, 1.5, "5 4")
    figure.arc((0, 0), 0.4, 0, phi, BLUE)
    figure.text(0.5, 0.14, "φ", BLUE)
    figure.dot(*direction)
    figure.text(direction[0] + 0.13, direction[1] - 0.15, "c")

    origin = 2.6  # the z axis of the half plane
    center = (origin + 1.7, 0)
    figure.arrow((origin - 0.15, 0), (origin + 3.1, 0), BLUE)
    figure.arrow((origin, -1.3), (origin, 1.4), GREY)
    figure.text(origin + 3.0, -0.22, "ρ", BLUE)
    figure.text(origin + 0.14, 1.3, "z", GREY)
    figure.circle(*center, 0.8)
    end = (center[0] + 0.8 * math.cos(psi), center[1] + 0.8 * math.sin(psi))
    figure.path([center, end])
    figure.arrow(end, (end[0] + 0.6 * math.cos(psi), end[1] + 0.6 * math.sin(psi)), RED, 2)
    figure.text(end[0] + 0.48, end[1] + 0.4, "n", RED)
    figure.arc(center, 0.25, 0, psi)
    figure.text(center[0] + 0.38, 0.13, "ψ")
    figure.dot(*center)
    figure.dot(*end)
    figure.text(center[0] - 0.05, -0.24, "c")
    figure.text(end[0] + 0.2, end[1] - 0.08, "p")
    figure.text(center[0] + 0.05, 0.42, "r")
    figure.arrow((origin + 0.6, -1.05), (origin, -1.05))
    figure.arrow((origin + 1.1, -1.05), (center[0], -1.05))
    figure.path([center, (center[0], -1.15)], GREY, 1, "3 4")
    figure.text(origin + 0.85, -1.11, "R")
    figure.write("torus-parameters.svg")


def along_a_ray():
    """f on a ray that crosses the tube twice: its stretches, a safe step and a sure one."""
    a, y, tilt, height = 0.42, 0.35, 0.09, 0.1
    dx = 1 / math.hypot(1, tilt)
    dz = tilt * dx

    def jet(s):
        x, z = s * dx, height + s * dz
        rho = math.hypot(x, y)
        slope, curvature = dx * x / rho, dx * dx * y * y / rho**3
        return ((rho - 1) ** 2 + z * z - a * a) / 2, (rho - 1) * slope + z * dz, 1 - curvature

    figure = Figure(640, 270, -2.35, -0.6, 136)
    figure.arrow((-2.3, 0), (2.3, 0), GREY)
    figure.text(2.25, -0.15, "s", GREY)
    w = math.sqrt((dx * dx * y * y) ** (2 / 3) - y * y) / dx
    for edge, name in ((-w, "−w"), (0, "0"), (w, "w")):
        figure.path([(edge, -0.3), (edge, 1.1)], GREY, 1, "3 4")
        figure.text(edge, -0.45, name, GREY)
    for middle, name in ((-1.3, "convex"), (0, "concave"), (1.3, "convex")):
        figure.text(middle, 1.2, name, GREY)
    start, flat = -2.2, 0.0  # f bends least, not at all, where its stretch ends
    f, f1, f2 = jet(start)
    for curvature, color, name, shift in ((flat, BLUE, "safe", -0.2), (f2, RED, "sure", 0.24)):
        end = start + 2 * f / (math.sqrt(f1 * f1 - 2 * f * curvature) - f1)
        steps = [start + (end - start) * i / 40 for i in range(41)]
        parabola = [(s, f + f1 * (s - start) + curvature * (s - start) ** 2 / 2) for s in steps]
        figure.path(parabola, color, 1.5, "6 3")
        figure.dot(end, 0, color)
        figure.text(end + shift, -0.17 if shift < 0 else 0.08, name, color)
    curve = [(start + 4.4 * i / 300, jet(start + 4.4 * i / 300)[0]) for i in range(301)]
    figure.path(curve, INK, 2)
    figure.dot(start, f)
    figure.text(start + 0.25, f + 0.02, "f")
    figure.write("torus-ray.svg")


if __name__ == "__main__":
    IMAGES.mkdir(parents=True, exist_ok=True)
    parameters()
    along_a_ray()
