# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the inputs of this folder as legacy VTK files: ASCII, numbers exact to the last bit."""

import os

FOLDER = os.path.dirname(os.path.abspath(__file__))


def write_polydata(name, title, points, lines=(), vertices=(), polygons=(), point_arrays=None,
    cell_arrays=None):
    """Points have two or three coordinates, lines and polygons are tuples of point ids, vertices point
    ids; cell arrays hold vertices first, then lines.
    """
    text = _header(title, "POLYDATA")
    text.append(f"POINTS {len(points)} double")
    text += [f"{float(x)!r} {float(y)!r} {float(z[0])!r}" if z else f"{float(x)!r} {float(y)!r} 0"
        for x, y, *z in points]
    text += _cells("VERTICES", [(vertex,) for vertex in vertices])
    text += _cells("LINES", lines)
    text += _cells("POLYGONS", polygons)
    text += _arrays("CELL_DATA", len(vertices) + len(lines) + len(polygons), cell_arrays)
    text += _arrays("POINT_DATA", len(points), point_arrays)
    _save(name, text)


def write_rectilinear_grid(name, title, x_nodes, y_nodes, point_arrays):
    """Values run fastest along x."""
    text = _header(title, "RECTILINEAR_GRID")
    text.append(f"DIMENSIONS {len(x_nodes)} {len(y_nodes)} 1")
    for axis, nodes in (("X", x_nodes), ("Y", y_nodes), ("Z", [0.0])):
        text += [f"{axis}_COORDINATES {len(nodes)} double", " ".join(map(repr, map(float, nodes)))]
    text += _arrays("POINT_DATA", len(x_nodes) * len(y_nodes), point_arrays)
    _save(name, text)


def _header(title, kind):
    return ["# vtk DataFile Version 3.0", title, "ASCII", f"DATASET {kind}"]


def _cells(kind, cells):
    if not cells:
        return []
    size = sum(len(cell) + 1 for cell in cells)
    return [f"{kind} {len(cells)} {size}"] + [" ".join(map(str, (len(c), *c))) for c in cells]


def _arrays(association, count, arrays):
    if not arrays:
        return []
    text = [f"{association} {count}", f"FIELD FieldData {len(arrays)}"]
    for name, values in arrays.items():
        kind = "int" if all(isinstance(value, int) for value in values) else "double"
        text += [f"{name} 1 {count} {kind}", "\n".join(map(repr, values))]
    return text


def _save(name, text):
    with open(os.path.join(FOLDER, name), "w", encoding="ascii") as file:
        file.write("\n".join(text) + "\n")
