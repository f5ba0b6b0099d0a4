# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Everyday tasks, one function each, to copy from: pvpython examples.py BitingMesh.so OUTPUT_FOLDER

Prints the summary of each mesh; all files that are written are in the output folder.
"""

import os
import sys

from paraview.simple import *

here = os.path.dirname(os.path.abspath(__file__))


def contour_to_mesh(folder):
    """The part of a slice where a field is above a value: what a contour encloses, with its border.

    The outline of such a surface has an edge or two a pixel. BoundaryTolerance lets it follow the
    spacing; without it, every point of the outline becomes a vertex.
    """
    field = Wavelet(WholeExtent=[-100, 100, -100, 100, 0, 0])
    bright = IsoVolume(Input=field, InputScalars=['POINTS', 'RTData'], ThresholdRange=[150, 300])
    return BitingMesher(Input=bright, UniformSpacing=10, BoundaryTolerance=0.2)


def coast_with_spacing_by_depth(folder):
    """A sea in which edges are a share of the length of the tide's waves, period * sqrt(9.81 depth).

    Grid and coast must be in the same coordinates, here metres.
    """
    coast = LegacyVTKReader(FileNames=[os.path.join(here, 'coast.vtk')])
    depth = made_up_depth(coast)
    period, edges_a_wave = 44714, 100
    spacing = Calculator(Input=depth, ResultArrayName='Spacing',
        Function=f'{period} * sqrt(9.81 * Depth) / {edges_a_wave}')
    return BitingMesher(Input=coast, SpacingSource=spacing, BoundarySpacingArray=['POINTS', 'None'],
        SourceSpacingArray=['POINTS', 'Spacing'], MaximumSpacing=30000, Gradation=0.2,
        BoundaryTolerance=0.2)


def courant_number_of_a_coast(folder):
    """A sea for a time step, and the Courant number sqrt(9.81 depth) * step / edge at its vertices.

    The spacing keeps the number at `most`. It is above that where edges are shorter: along the
    shore, whose narrow places ask for fine triangles. NearestNeighborDistance is the
    shortest edge at a vertex; the depth comes along from the spacing source.
    """
    coast = LegacyVTKReader(FileNames=[os.path.join(here, 'coast.vtk')])
    depth = made_up_depth(coast)
    step, most = 300, 0.8
    spacing = Calculator(Input=depth, ResultArrayName='Spacing',
        Function=f'{step} * sqrt(9.81 * Depth) / {most}')
    mesh = BitingMesher(Input=coast, SpacingSource=spacing, BoundarySpacingArray=['POINTS', 'None'],
        SourceSpacingArray=['POINTS', 'Spacing'], BoundaryTolerance=0.2)
    courant = Calculator(Input=OutputPort(mesh, 0), ResultArrayName='CourantNumber',
        Function=f'{step} * sqrt(9.81 * Depth) / NearestNeighborDistance')
    SaveData(os.path.join(folder, 'courant_number.vtp'), proxy=courant)
    return mesh


def adcirc_grid_with_depths(folder):
    """A grid for ADCIRC (.14; .gr3 is SCHISM's, .2dm that of SMS) whose depths are those of a chart.

    All arrays of the spacing source come along to the mesh, so that three gestures do: a spacing of
    the chart, the mesh, the file. A chart alone is no spacing: then SourceSpacingArray is None.
    """
    coast = LegacyVTKReader(FileNames=[os.path.join(here, 'coast.vtk')])
    spacing = Calculator(Input=made_up_depth(coast), ResultArrayName='Spacing',
        Function='5000 + 20 * Depth')
    mesh = BitingMesher(Input=coast, SpacingSource=spacing, BoundarySpacingArray=['POINTS', 'None'],
        BoundaryTolerance=0.2)
    SaveData(os.path.join(folder, 'coast.14'), proxy=OutputPort(mesh, 0))
    return mesh


def made_up_depth(coast):
    """On a grid, as from a chart, in metres: it grows with the distance from a line."""
    x0, x1, y0, y1 = coast_box(coast)
    grid = FastUniformGrid(WholeExtent=[0, 100, 0, 100, 0, 0])
    grid = Transform(Input=grid, TransformAllInputVectors=0)
    grid.Transform.Scale = [(x1 - x0) / 100, (y1 - y0) / 100, 1]
    grid.Transform.Translate = [x0, y0, 0]
    return Calculator(Input=grid, ResultArrayName='Depth',
        Function=f'max(5, 0.004 * abs(coordsX - {x1}))')


def coast_box(coast):
    coast.UpdatePipeline()
    return coast.GetDataInformation().GetBounds()[:4]


def airfoil(folder):
    """The air around an airfoil: the array Spacing of its points says how long edges are there."""
    outline = LegacyVTKReader(FileNames=[os.path.join(here, 'naca_airfoil.vtk')])
    mesh = BitingMesher(Input=outline, Gradation=0.2)
    SaveData(os.path.join(folder, 'airfoil.su2'), proxy=OutputPort(mesh, 0))
    return mesh


def plate_with_regions(folder):
    """A plate that a weld divides: an open chain becomes mesh edges, its sides differ in RegionId.

    One region alone, as a filter behind would take it: Threshold.
    """
    plate = LegacyVTKReader(FileNames=[os.path.join(here, 'plate.vtk')])
    mesh = BitingMesher(Input=plate, UniformSpacing=0.4)
    left = Threshold(Input=OutputPort(mesh, 0), Scalars=['CELLS', 'RegionId'],
        LowerThreshold=0, UpperThreshold=0)
    SaveData(os.path.join(folder, 'left_of_the_weld.vtk'), proxy=left)
    return mesh


def export_with_tags(folder):
    """A mesh for a solver: lines keep the array Tag of the drawing, triangles their RegionId.

    .msh is Gmsh's format (physical groups), .su2 that of SU2 (markers), .14 that of ADCIRC.
    """
    plate = LegacyVTKReader(FileNames=[os.path.join(here, 'plate.vtk')])
    mesh = BitingMesher(Input=plate, UniformSpacing=0.4)
    for ending in ['msh', 'su2']:
        SaveData(os.path.join(folder, 'plate.' + ending), proxy=OutputPort(mesh, 0))
    return mesh


def size_by_tag(folder):
    """Short edges along the lines of one tag: a cell array of sizes, 0 where nothing is asked for."""
    plate = LegacyVTKReader(FileNames=[os.path.join(here, 'plate.vtk')])
    sizes = Calculator(Input=plate, AttributeType='Cell Data', ResultArrayName='Size',
        Function='if (Tag == 2, 0.05, 0)')
    return BitingMesher(Input=sizes, UniformSpacing=0.4, BoundarySpacingArray=['CELLS', 'Size'])


def judge_a_mesh(folder):
    """How good the mesh of another program is: angles, and how it follows the spacing it was made for."""
    points = PointSource(NumberOfPoints=500, Radius=1)
    flat = Calculator(Input=points, CoordinateResults=1, ResultArrayName='Places',
        Function='coordsX*iHat+coordsY*jHat')
    mesh = Delaunay2D(Input=flat)
    wanted = Calculator(Input=mesh, ResultArrayName='Spacing', Function='0.09')
    return MeshConformity(Input=wanted)


def mesh_for_a_solution(folder):
    """A mesh whose edges are short where a solution bends: HessianSpacing makes the spacing of it."""
    square = LegacyVTKReader(FileNames=[os.path.join(here, 'square_9x9.vtk')])
    coarse = BitingMesher(Input=square, UniformSpacing=0.3)
    solution = Calculator(Input=OutputPort(coarse, 0), ResultArrayName='u',
        Function='exp(-4*((coordsX-4)^2+(coordsY-5)^2-6)^2)')
    spacing = HessianSpacing(Input=solution, ScalarArray=['POINTS', 'u'], ErrorTolerance=0.01,
        MinimumSpacing=0.03, MaximumSpacing=0.6)
    return BitingMesher(Input=square, SpacingSource=spacing, SourceSpacingArray=['POINTS', 'Spacing'])


def nested_refinement_regions(folder):
    """Six squares within each other and a domain, each with half the edges: regions with exact areas."""
    sizes = {64: 6.4, 32: 3.2, 16: 1.6, 8: 0.8, 4: 0.4, 2: 0.2, 1: 0.1}
    boxes = [Calculator(Input=Plane(Origin=[-half, -half, 0], Point1=[half, -half, 0],
        Point2=[-half, half, 0], XResolution=1, YResolution=1), AttributeType='Cell Data',
        ResultArrayName='Size', Function=str(size)) for half, size in sizes.items()]
    return BitingMesher(Input=AppendGeometry(Input=boxes), DomainRule='Union',
        BoundarySpacingArray=['CELLS', 'Size'])


def a_town_of_houses(folder):
    """60 houses in a plain that water flows around: what is drawn upon the first polygon is no domain."""
    plain = Plane(Origin=[0, 0, 0], Point1=[240, 0, 0], Point2=[0, 160, 0])
    houses = [Plane(Origin=[x, y, 0], Point1=[x + 9, y + 3, 0], Point2=[x - 4, y + 12, 0])
        for x in range(25, 225, 20) for y in range(15, 140, 23)]
    return BitingMesher(Input=AppendGeometry(Input=[plain, *houses]), UniformSpacing=4,
        DomainRule='Outer Minus Others')


def periodic_cell(folder):
    """A cell that repeats along x and y: PeriodicPartner tells the point on the other side."""
    cell = Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0])
    return BitingMesher(Input=cell, UniformSpacing=0.05, PeriodicTranslation=[1, 0, 0],
        PeriodicTranslation2=[0, 1, 0])


def fine_mesh_in_a_coarse_one(folder):
    """Triangles of another program stay as they are, and a coarse mesh grows around them."""
    fine = Triangulate(Input=Plane(XResolution=30, YResolution=30))
    coarse = Plane(Origin=[-3, -2, 0], Point1=[3, -2, 0], Point2=[-3, 2, 0])
    return BitingMesher(Input=AppendGeometry(Input=[coarse, fine]), UniformSpacing=0.3,
        DomainRule='Union', KeepCellEdges=1)


def stl_to_tetrahedra(folder):
    """A body with holes, from an STL file to tetrahedra; a Clip with Crinkleclip looks inside."""
    path = os.path.join(folder, 'bracket.stl')
    SaveData(path, proxy=LegacyVTKReader(FileNames=[os.path.join(here, 'bracket.vtk')]))
    mesh = BitingTetrahedralizer(Input=STLReader(FileNames=[path]), UniformSpacing=4)
    SaveData(os.path.join(folder, 'bracket.vtu'), proxy=OutputPort(mesh, 0))
    return mesh


def body_with_tags_for_a_solver(folder):
    """Tetrahedra, and the triangles of the boundary with the array Tag of the surface: SU2, Gmsh.

    The triangles of one tag alone, as a filter behind would take them: Threshold.
    """
    surface = LegacyVTKReader(FileNames=[os.path.join(here, 'bracket.vtk')])
    mesh = BitingTetrahedralizer(Input=surface, UniformSpacing=4)
    for ending in ['msh', 'su2']:
        SaveData(os.path.join(folder, 'bracket.' + ending), proxy=OutputPort(mesh, 0))
    bolts = Threshold(Input=OutputPort(mesh, 1), Scalars=['CELLS', 'Tag'], LowerThreshold=2,
        UpperThreshold=2)
    SaveData(os.path.join(folder, 'bolts.vtk'), proxy=bolts)
    return mesh


def shell_of_two_materials(folder):
    """Three spheres in each other: a cavity, a material around it, and another one around that.

    A closed surface encloses the material of its value; the innermost has that of the one around it,
    so what it encloses is a cavity.
    """
    balls = [(1.0, 5), (0.75, 8), (0.45, 8)]
    spheres = [Calculator(Input=Sphere(Radius=radius, ThetaResolution=48, PhiResolution=48),
        AttributeType='Cell Data', ResultArrayName='Material', Function=str(material))
        for radius, material in balls]
    return BitingTetrahedralizer(Input=AppendGeometry(Input=spheres), RegionArray='Material',
        UniformSpacing=0.12)


def ball_with_a_spacing_field(folder):
    """Edges as long as a field says, here on an image: short near a place on the surface."""
    image = Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    unit = Transform(Input=image)
    unit.Transform.Scale = [0.11, 0.11, 0.11]
    field = Calculator(Input=unit, ResultArrayName='Spacing',
        Function='0.04+0.12*sqrt((coordsX+0.7)^2+coordsY^2+(coordsZ-0.7)^2)')
    ball = Sphere(Radius=1, ThetaResolution=64, PhiResolution=64)
    return BitingTetrahedralizer(Input=ball, SpacingSource=field,
        SourceSpacingArray=['POINTS', 'Spacing'])


tasks = [contour_to_mesh, coast_with_spacing_by_depth, courant_number_of_a_coast,
    adcirc_grid_with_depths, airfoil, plate_with_regions, export_with_tags, size_by_tag, judge_a_mesh,
    mesh_for_a_solution, nested_refinement_regions, a_town_of_houses, periodic_cell,
    fine_mesh_in_a_coarse_one, stl_to_tetrahedra, body_with_tags_for_a_solver,
    shell_of_two_materials, ball_with_a_spacing_field]


def main(plugin, folder):
    os.makedirs(folder, exist_ok=True)
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    for task in tasks:
        mesh = task(folder)
        mesh.UpdatePipeline()
        mesh.UpdatePropertyInformation()
        print(task.__name__.replace('_', ' '))
        print('   ', mesh.Summary.replace('\n', '\n    '))


if __name__ == '__main__':
    main(*sys.argv[1:3])
