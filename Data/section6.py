# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""The experiment of the paper's section 6: pvpython section6.py BitingMesh.so OUTPUT_FOLDER

Figures 16 and 17: the 9 by 9 square with the spacing of George and Borouchaki, bitten by squares of
constants 0.5 and 0.7; both meshes, and the histograms of their angles and conformities. Prints our
figures beside the paper's, for two orders of the front, of which the paper has the first.
"""

import os
import sys

from paraview.simple import *

import views

HERE = os.path.dirname(os.path.abspath(__file__))
CONSTANTS = (0.5, 0.7)
ORDERS = ('Largest Y', 'Layers')
COLORS = {0.5: (0.85, 0.37, 0.1), 0.7: (0.1, 0.4, 0.7)}
BINS = 60

# By biting constant: vertices, smallest angle in degrees, and where the conformities crowd.
PAPER = {0.5: (6728, 13, 0.5), 0.7: (3435, 7, 0.7)}

# Field data of the mesh, and the heads of their columns.
SUMMARY = (
    ('NumberOfVertices', 'vertices', '8.0f'), ('SmallestAngle', 'smallest angle', '14.1f'),
    ('SmallestConformity', 'conformity: smallest', '20.3f'), ('MeanConformity', 'mean', '5.3f'))


def main(plugin, folder):
    load(plugin)
    print_table()
    draw(os.path.join(folder, 'section6.png'))


def load(plugin):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())


def bite(constant, order):
    """The mesh as in the paper: squares at corners of the front, the spacing as given, no finishing."""
    return BitingMesher(Input=read('square_9x9.vtk'), SpacingSource=read('section6_spacing.vtk'),
        BitingConstant=constant, BiteShape='Square', Placement='Corners', FrontOrder=order,
        Gradation=0, LimitByFeatureSize=0, Relaxation=0)


def read(name):
    return LegacyVTKReader(FileNames=[os.path.join(HERE, name)])


def print_table():
    heads = [head for _, head, _ in SUMMARY]
    print('  '.join(['c_b  mesh          ', *heads, 'most frequent']))
    for constant in CONSTANTS:
        vertices, angle, conformity = PAPER[constant]
        print(f'{constant}  {"the paper":14}  {vertices:8}  {angle:14}  {"":20}  {"":5}'
              f'  {conformity:13}')
        for order in ORDERS:
            figures = figures_of(bite(constant, order))
            texts = [f'{value:{form}}' for value, (_, _, form) in zip(figures, SUMMARY)]
            print('  '.join([f'{constant}  {"ours, " + order:14}', *texts, f'{figures[-1]:13.2f}']))


def figures_of(mesh):
    """The summary, and the middle of the fullest bin of conformity."""
    fields = servermanager.Fetch(mesh).GetFieldData()
    table = servermanager.Fetch(MeshConformity(Input=mesh, NumberOfBins=BINS), idx=1)
    percents = [table.GetValueByName(row, 'ConformityPercent').ToDouble()
                for row in range(table.GetNumberOfRows())]
    fullest = percents.index(max(percents))
    return [fields.GetArray(name).GetValue(0) for name, _, _ in SUMMARY] + [
        table.GetValueByName(fullest, 'Conformity').ToDouble()]


def draw(path):
    """The meshes above, the histograms below."""
    meshes = {constant: bite(constant, ORDERS[0]) for constant in CONSTANTS}
    layout = CreateLayout('Section 6')
    layout.SplitVertical(0, 0.68)
    layout.SplitHorizontal(1, 0.5)
    layout.SplitHorizontal(2, 0.5)
    for cell, constant in zip((3, 4), CONSTANTS):
        AssignViewToLayout(view_of_mesh(meshes[constant]), layout, cell)
    judged = {constant: MeshConformity(Input=mesh, NumberOfBins=BINS)
              for constant, mesh in meshes.items()}
    AssignViewToLayout(chart(judged, 'Angle', 'angles [degrees]', [0, 130]), layout, 5)
    AssignViewToLayout(chart(judged, 'Conformity', 'conformity of vertices', [0, 1]), layout, 6)
    layout.SetSize(1200, 880)
    SaveScreenshot(path, layout, ImageResolution=[1200, 880], CompressionLevel='9')


def view_of_mesh(mesh):
    view = views.plane_view([4.5, 4.5], 9.2, [600, 600])
    views.show_mesh(mesh, view)
    return view


def chart(judged, column, title, extent):
    named = {f'c_b = {constant}': conformity for constant, conformity in judged.items()}
    colors = {f'c_b = {constant}': color for constant, color in COLORS.items()}
    return views.histograms(named, colors, column, title, extent, [600, 280])


if __name__ == '__main__':
    main(*sys.argv[1:3])
