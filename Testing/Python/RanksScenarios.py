# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The filters on pieces that lie on ranks in many ways: for TestRanksProxy.py, by mpiexec pvbatch.

Arguments: names of functions below. With BITING_SERVER_PORT the filters run on that pvserver.
Writes to the file of BITING_ANSWER, as JSON, what each filter gave: a digest of the bytes of all
outputs, another of what numbers the input's points and cells, and the errors said on the first
rank.
"""

import hashlib
import json
import math
import os
import sys
import tempfile

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringArray

# Numbers of the input's, which has others on ranks where nothing says what they were.
INPUT_IDS = ('OriginalPointId', 'OriginalCellId')
# What dealing out adds to the input.
ADDED = ('GlobalCellIds', 'GlobalPointIds', 'vtkOriginalCellIds', 'vtkGhostType')

# What every source begins with: rings of a drawing, a spacing, and who has which of them.
PRELUDE = '''
global math, vtkCellArray, vtkDoubleArray, vtkImageData, vtkIntArray, vtkMultiBlockDataSet
global vtkPoints, vtkPolyData, rank, ranks, rings, Ring, Drawing, Spread, Blocks, F, Field
import math
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId() if controller else 0
ranks = controller.GetNumberOfProcesses() if controller else 1

def Ring(size, radius, x, y):
    angles = [2 * math.pi * k / size for k in range(size)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a), 0.0) for a in angles]

rings = [Ring(60, 10, 0, 0), Ring(30, 3, 2, 1), Ring(25, 2, -5, 0), Ring(12, 1, 2, 1)]

def F(x, y):
    return 0.4 + 0.1 * math.hypot(x - 4, y + 2)

def Drawing(which, form='Polylines', tilt=0.0):
    points, lines, polygons, tags = vtkPoints(), vtkCellArray(), vtkCellArray(), vtkIntArray()
    spacing = vtkDoubleArray()
    points.SetDataTypeToDouble()
    tags.SetName('Tag')
    spacing.SetName('Spacing')
    for ring in which:
        ids = [points.InsertNextPoint(x, y, tilt * (x - 2 * y)) for x, y, z in rings[ring]]
        for x, y, z in rings[ring]:
            spacing.InsertNextValue(F(x, y))
        cells = [ids + ids[:1]]
        if form == 'Segments':
            cells = [[a, b] for a, b in zip(ids, ids[1:] + ids[:1])]
        elif form == 'Polygons':
            cells = [ids]
        for cell in cells:
            target = polygons if form == 'Polygons' else lines
            target.InsertNextCell(len(cell))
            for point in cell:
                target.InsertCellPoint(point)
            tags.InsertNextValue(ring)
    drawing = vtkPolyData()
    drawing.SetPoints(points)
    drawing.SetLines(lines)
    drawing.SetPolys(polygons)
    drawing.GetCellData().AddArray(tags)
    drawing.GetPointData().AddArray(spacing)
    return drawing

def Spread(where):
    if where == 'First':
        return range(4) if rank == 0 else []
    if where == 'Last':
        return range(4) if rank == ranks - 1 else []
    if where == 'Everywhere':
        return range(4)
    if where == 'Dealt':
        return [ring for ring in range(4) if (3 - ring) % ranks == rank]
    if where == 'Around':  # the second rank has nothing
        owners = [0] + list(range(2, ranks))
        return [ring for ring in range(4) if owners[ring % len(owners)] == rank]
    return [ring for ring in range(4) if ring * ranks // 4 == rank]

def Blocks(where):
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(4)
    own = Spread(where)
    for ring in range(4):
        blocks.SetBlock(ring, Drawing([ring], 'Polygons') if ring in own else None)
    return blocks

def Field(extent, power=1.0):
    image = vtkImageData()
    image.SetExtent(*extent)
    image.SetOrigin(-12, -12, 0)
    values, depths = vtkDoubleArray(), vtkDoubleArray()
    values.SetName('Spacing')
    depths.SetName('Depth')  # comes along to the mesh
    for j in range(extent[2], extent[3] + 1):
        for i in range(extent[0], extent[1] + 1):
            values.InsertNextValue(F(i - 12, j - 12) ** power)
            depths.InsertNextValue(3.0 * i - j)
    image.GetPointData().SetScalars(values)
    image.GetPointData().AddArray(depths)
    return image
'''

# With the pieces that the pipeline asks for.
WHOLE_IMAGE = '''
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
executive = self.GetExecutive()
outInfo = executive.GetOutputInformation(0)
outInfo.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), (0, 24, 0, 24, 0, 0), 6)
outInfo.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
'''
PIECE_OF_IMAGE = '''
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
outInfo = self.GetExecutive().GetOutputInformation(0)
self.GetOutput().ShallowCopy(
    Field(outInfo.Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT())%s))
'''


def producer(script, data_type='vtkPolyData', information=''):
    return simple.ProgrammableSource(
        OutputDataSetType=data_type, Script=PRELUDE + script,
        ScriptRequestInformation=PRELUDE + information if information else '')


def drawing(where, form='Polylines', tilt=0.0):
    return producer(
        "self.GetOutput().ShallowCopy(Drawing(Spread('%s'), '%s', %s))" % (where, form, tilt))


def image(power=1.0):
    return producer(PIECE_OF_IMAGE % (', %s' % power), 'vtkImageData', WHOLE_IMAGE)


def bytes_of(array):
    if isinstance(array, vtkStringArray):
        return '\n'.join(array.GetValue(k) for k in range(array.GetNumberOfValues())).encode()
    return vtk_to_numpy(array).tobytes()


def add_array(digest, array):
    if array is not None and array.GetNumberOfTuples() > 0:
        digest.update(array.GetName().encode() if array.GetName() else b'')
        digest.update(bytes_of(array))


def add_arrays(digest, ids, data):
    for name in sorted(data.GetArrayName(k) for k in range(data.GetNumberOfArrays())):
        if name not in ADDED:
            add_array(ids if name in INPUT_IDS else digest, data.GetAbstractArray(name))


def digests_of_problems(problems):
    """They come in the order of the input's ids, and their messages name these."""
    data = problems.GetPointData()
    rows = sorted(problems.GetPoint(k) + (data.GetArray('ProblemKind').GetValue(k),)
                  for k in range(problems.GetNumberOfPoints()))
    ids = hashlib.sha256(bytes_of(problems.GetPoints().GetData()))
    add_arrays(ids, ids, data)
    digest = hashlib.sha256(str(rows).encode())
    return '%d problems, %s' % (len(rows), digest.hexdigest()[:16]), ids.hexdigest()[:16]


def digests_of(data):
    """Of the bytes, and of those that number points and cells of the input."""
    digest, ids = hashlib.sha256(), hashlib.sha256()
    if hasattr(data, 'GetRowData'):
        add_arrays(digest, ids, data.GetRowData())
        return '%d rows, %s' % (data.GetNumberOfRows(), digest.hexdigest()[:16]), ''
    if data.GetNumberOfPoints() > 0 and data.GetPointData().HasArray('ProblemKind'):
        return digests_of_problems(data)
    if data.GetNumberOfPoints() > 0 and hasattr(data, 'GetPoints'):
        add_array(digest, data.GetPoints().GetData())
    for cells in ('GetPolys', 'GetLines', 'GetVerts', 'GetCells'):
        if hasattr(data, cells) and data.GetNumberOfCells() > 0:
            add_array(digest, getattr(data, cells)().GetConnectivityArray())
    add_arrays(digest, ids, data.GetPointData())
    what = '%d points, %d cells, %s, ' % (
        data.GetNumberOfPoints(), data.GetNumberOfCells(), digest.hexdigest()[:16])
    add_arrays(digest, ids, data.GetCellData())
    return what + digest.hexdigest()[:16], ids.hexdigest()[:16]


def run(algorithm, ports=(0,)):
    errors = []
    window = vtkOutputWindow.GetInstance()
    tags = [window.AddObserver(event, lambda *unused: errors.append(1))
            for event in ('ErrorEvent', 'WarningEvent')]
    window.SetDisplayModeToNever()
    try:
        algorithm.UpdatePipeline()
        digests = [digests_of(servermanager.Fetch(algorithm, idx=port)) for port in ports]
    finally:
        window.SetDisplayModeToDefault()
        for tag in tags:
            window.RemoveObserver(tag)
    return {'digests': [both[0] for both in digests], 'ids': [both[1] for both in digests],
            'messages': len(errors)}


def mesh(source, ports=(0, 1, 3), **parameters):
    return run(BitingMesher(Input=source, **dict({'UniformSpacing': 1.0}, **parameters)), ports)


def drawings(answer):
    for where in ('First', 'Last', 'Everywhere', 'Divided', 'Dealt', 'Around'):
        answer['Polylines.' + where] = mesh(drawing(where))
    for form in ('Segments', 'Polygons'):
        for where in ('First', 'Dealt'):
            answer['%s.%s' % (form, where)] = mesh(drawing(where, form))
    for where in ('First', 'Dealt'):
        answer['Tilted.' + where] = mesh(drawing(where, tilt=0.3), BoundarySpacingArray='Spacing')
        answer['Globe.' + where] = mesh(
            drawing(where), Coordinates='Longitude Latitude', UniformSpacing=1e5,
            BoundarySpacingArray=['POINTS', 'None'])  # that is in degrees
    for where in ('First', 'Last', 'Everywhere', 'Divided', 'Dealt', 'Around'):
        blocks = producer(
            "self.GetOutput().ShallowCopy(Blocks('%s'))" % where, 'vtkMultiblockDataSet')
        answer['Composite.' + where] = mesh(blocks)


def rules(answer):
    """Polygons over each other: what they carry is on triangles, beside simplified interfaces, too."""
    for where in ('First', 'Everywhere', 'Divided'):
        for rule in ('Union', 'Outer Minus Others'):
            answer['Rule %s.%s' % (rule, where)] = mesh(
                drawing(where, 'Polygons'), DomainRule=rule, RegionArray='Tag',
                BoundaryTolerance=0.3)


# Every other rank has other types, and only the one with the last ring has the array Last.
MIXED = '''
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkLongLongArray
def As(kind, array, change=lambda value: value):
    new = kind()
    new.SetName(array.GetName())
    for k in range(array.GetNumberOfTuples()):
        new.InsertNextValue(change(array.GetValue(k)))
    return new
drawing = Drawing(Spread('Dealt'))
spacing, tags = drawing.GetPointData().GetArray(0), drawing.GetCellData().GetArray(0)
drawing.GetPointData().AddArray(As(
    vtkFloatArray if rank % 2 else vtkDoubleArray, spacing, lambda value: round(64 * value) / 64))
drawing.GetCellData().AddArray(As(vtkIntArray if rank % 2 else vtkLongLongArray, tags))
if 3 in Spread('Dealt'):
    last = As(vtkDoubleArray, tags, lambda tag: 1.0 if tag == 3 else math.nan)
    last.SetName('Last')
    drawing.GetCellData().AddArray(last)
self.GetOutput().ShallowCopy(drawing)
'''


def mixed(answer):
    answer['Mixed.Dealt'] = mesh(producer(MIXED), BoundarySpacingArray='Spacing')


def redistributed(answer):
    """Cells that other filters have dealt out."""
    for form, name, dealer in (('Segments', 'Redistributed', simple.RedistributeDataSet),
                               ('Polygons', 'Redistributed', simple.RedistributeDataSet),
                               ('Segments', 'D3', simple.D3)):
        answer['%s.%s' % (form, name)] = mesh(dealer(Input=drawing('First', form)))


def redistributed_otherwise(answer):
    """The rest of forms and dealers, on fewer ranks, for time."""
    for form, name, dealer in (('Polylines', 'Redistributed', simple.RedistributeDataSet),
                               ('Polylines', 'D3', simple.D3), ('Polygons', 'D3', simple.D3)):
        answer['%s.%s' % (form, name)] = mesh(dealer(Input=drawing('First', form)))


def contours(answer):
    answer['Contour.Divided'] = mesh(simple.Contour(
        Input=image(), ContourBy=['POINTS', 'Spacing'], Isosurfaces=[0.7, 1.2]), UniformSpacing=0.5)


def image_with_ghosts():
    """Another filter has asked for ghosts of it before: they stay, with an array that tells so."""
    wavelet = simple.Wavelet(WholeExtent=[-12, 12, -12, 12, 0, 0])
    cells = simple.Threshold(Input=wavelet, Scalars=['POINTS', 'RTData'], LowerThreshold=150)
    simple.ExtractSurface(Input=cells).UpdatePipeline()
    return simple.Calculator(
        Input=wavelet, ResultArrayName='Spacing', Function='0.6+0.2*abs(coordsX)')


def sources(answer):
    """A source in pieces: an image, one with ghosts, triangles, triangles dealt out, blocks; also
    on one rank only."""
    parameters = {'UniformSpacing': 0.0, 'SourceSpacingArray': ['POINTS', 'Spacing']}
    triangles = simple.Triangulate(Input=simple.ExtractSurface(Input=image()))
    last = producer('''
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
surface = vtkDataSetSurfaceFilter()
surface.SetInputData(Field((0, 24, 0, 24, 0, 0)))
surface.Update()
if rank == ranks - 1:
    self.GetOutput().ShallowCopy(surface.GetOutput())
''')
    blocks = producer('''
blocks = vtkMultiBlockDataSet()
blocks.SetNumberOfBlocks(2)
if rank == 0:
    blocks.SetBlock(0, Field((0, 24, 0, 24, 0, 0)))
if rank == ranks - 1:
    blocks.SetBlock(1, Field((5, 14, 4, 20, 0, 0), 2.0))
self.GetOutput().ShallowCopy(blocks)
''', 'vtkMultiblockDataSet')
    for name, source in (('Image.Divided', image()), ('Image.Ghosts', image_with_ghosts()),
                         ('Quads.Last', last),
                         ('Triangles.Divided', triangles),
                         ('Triangles.D3', simple.D3(Input=triangles)),
                         ('Triangles.Redistributed', simple.RedistributeDataSet(Input=triangles)),
                         ('Blocks.Divided', blocks)):
        answer['Source.' + name] = mesh(
            drawing('Dealt', 'Segments'), SpacingSource=source, **parameters)


# A lattice, its columns dealt out to ranks. Hidden cells are in the last columns: only the last
# rank has a ghost array.
HIDING = '''
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkStructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

def Lattice():
    first, last = 10 * rank // ranks, 10 * (rank + 1) // ranks
    lattice, points, spacing = vtkStructuredGrid(), vtkPoints(), vtkDoubleArray()
    lattice.SetExtent(first, last, 0, 10, 0, 0)
    spacing.SetName('Spacing')
    for j in range(11):
        for i in range(first, last + 1):
            points.InsertNextPoint(i, j, 0)
            spacing.InsertNextValue(0.2 + 0.1 * i)
    lattice.SetPoints(points)
    lattice.GetPointData().AddArray(spacing)
    return lattice

def Hide(data):
    if rank < ranks - 1:
        return data
    ghosts = data.AllocateCellGhostArray()
    for k in range(data.GetNumberOfCells()):
        bounds = data.GetCell(k).GetBounds()
        if bounds[0] >= 8 and 2 <= bounds[2] < 5:
            ghosts.SetValue(k, vtkDataSetAttributes.HIDDENCELL)
    return data

def Surface(data):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()
'''
WHOLE_LATTICE = WHOLE_IMAGE.replace('24', '10')


def area_of(mesh):
    corners = [[mesh.GetCell(k).GetPoints().GetPoint(c) for c in range(3)]
               for k in range(mesh.GetNumberOfCells())]
    return math.fsum((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
                     for a, b, c in corners) / 2


def hidden_cells(answer):
    """They are no part of the domain, an old mesh or a source, whoever else has no hidden ones."""
    grid = producer(HIDING + 'self.GetOutput().ShallowCopy(Hide(Lattice()))',
                    'vtkStructuredGrid', WHOLE_LATTICE)
    quads = producer(HIDING + 'self.GetOutput().ShallowCopy(Hide(Surface(Lattice())))')
    triangles = producer(HIDING + '''
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
triangles = vtkTriangleFilter()
triangles.SetInputData(Surface(Lattice()))
triangles.Update()
self.GetOutput().ShallowCopy(Hide(triangles.GetOutput()))
''')
    for name, source in (('Grid', grid), ('Quads', quads), ('Triangles', triangles)):
        answer['Hidden.' + name] = mesh(source, BoundarySpacingArray='None')
        spaced = mesh(drawing('First'), SpacingSource=source, UniformSpacing=0.0,
                      SourceSpacingArray=['POINTS', 'Spacing'])
        answer['Hidden.Source' + name] = dict(spaced, messages=0)  # one: the drawing is larger
    remesher = BitingRemesher(Input=triangles, UniformSpacing=0.7)
    answer['Hidden.Remesher'] = run(remesher, ())
    area = '%.9g of area' % area_of(servermanager.Fetch(remesher))
    answer['Hidden.Remesher']['digests'].append(area)


def field_of(algorithm, names):
    """A digest of the values by place, to the last bit."""
    data = servermanager.Fetch(algorithm)
    arrays = [data.GetPointData().GetArray(name) for name in names]
    rows = sorted([value.hex() for value in data.GetPoint(k)] +
                  [array.GetComponent(k, 0).hex() for array in arrays]
                  for k in range(data.GetNumberOfPoints()))
    return '%d points, %s' % (len(rows), hashlib.sha256(str(rows).encode()).hexdigest()[:16])


def other_filters(answer):
    """Of meshes in pieces: points and cells come in another order, values are the serial ones."""
    triangles = simple.Triangulate(Input=simple.ExtractSurface(Input=image()))
    for name, source in (('Divided', triangles), ('D3', simple.D3(Input=triangles))):
        conformity = MeshConformity(Input=source, SpacingArray=['POINTS', 'Spacing'])
        answer['Conformity.' + name] = run(conformity, (1,))
        answer['Conformity.' + name]['digests'].append(field_of(
            conformity, ['Spacing', 'NearestNeighborDistance', 'Conformity']))
    for name, source in (('Triangles', triangles), ('Image', image())):
        hessian = HessianSpacing(Input=source, ScalarArray=['POINTS', 'Spacing'])
        answer['Hessian.' + name] = run(hessian, ())
        answer['Hessian.' + name]['digests'].append(field_of(hessian, ['Spacing', 'HessianNorm']))
    mesher = BitingMesher(Input=drawing('Divided'), UniformSpacing=1.0)
    answer['Remesher.Mesh'] = run(BitingRemesher(
        Input=mesher, TaggedLines=simple.OutputPort(mesher, 1), SpacingScale=0.5), (0, 1, 3))


def writers(answer):
    """Files for solvers: the first rank gathers, and writes the bytes of the serial run."""
    mesher = BitingMesher(Input=drawing('Divided'), UniformSpacing=0.4, VerticesPerBlock=400)
    remesher = BitingRemesher(
        Input=mesher, TaggedLines=simple.OutputPort(mesher, 1), SpacingScale=1.5)
    for name, source in (('Mesher', mesher), ('Remesher', remesher)):
        digests = []
        with tempfile.TemporaryDirectory() as folder:
            for end, settings in (('msh', {}), ('su2', {}), ('14', {'OpenTags': '0 2'})):
                path = os.path.join(folder, 'mesh.' + end)
                simple.SaveData(path, proxy=source, **settings)
                with open(path, 'rb') as file:
                    text = file.read()
                digests.append('%d bytes, %s' % (len(text), hashlib.sha256(text).hexdigest()[:16]))
        answer['Written.' + name] = {'digests': digests, 'ids': [], 'messages': 0}


def separate_blocks(answer):
    """Each rank meshes its own; what they have together is what one rank makes of all."""
    for where in ('First', 'Dealt'):
        blocks = producer(
            "self.GetOutput().ShallowCopy(Blocks('%s'))" % where, 'vtkMultiblockDataSet')
        mesher = BitingMesher(Input=blocks, UniformSpacing=1.0, MeshBlocksSeparately=True)
        mesher.UpdatePipeline()
        information = mesher.GetDataInformation()
        counts = '%d points, %d cells' % (
            information.GetNumberOfPoints(), information.GetNumberOfCells())
        answer['Separately.' + where] = {'digests': [counts], 'ids': [], 'messages': 0}


def errors(answer):
    """Bad input on one rank, on all, and none: messages come once, and nothing waits for ever."""
    nan = 'drawing.GetPoints().SetPoint(0, float("nan"), 0, 0)'
    for name, bad in (('First', 'rank == 0'), ('Last', 'rank == ranks - 1'), ('All', 'True')):
        script = "drawing = Drawing(Spread('Everywhere'))\nif %s:\n    %s\n" % (bad, nan)
        answer['Error.NaN.' + name] = mesh(
            producer(script + 'self.GetOutput().ShallowCopy(drawing)'), (0, 1))
    answer['Error.Array'] = mesh(drawing('Divided'), RegionArray='Missing')
    answer['Error.Parameter'] = mesh(drawing('Divided'), Phi=2.0)
    answer['Error.TooMany'] = mesh(drawing('Divided'), UniformSpacing=1e-6)
    answer['Error.Volume'] = mesh(simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 4]))
    answer['Error.Nothing'] = mesh(producer(''))
    answer['Error.Conformity'] = run(
        MeshConformity(Input=drawing('Divided', 'Polygons'), SpacingArray=['POINTS', 'Spacing']))
    answer['Error.Hessian'] = run(
        HessianSpacing(Input=drawing('Divided', 'Segments'), ScalarArray=['POINTS', 'Spacing']))


def upstream(answer):
    """A script before ours stops with an error on one of two ranks; the other has the drawing."""
    for name, bad in (('First', 0), ('Last', 1)):
        script = "if ranks > 1 and rank == %d:\n    raise ValueError('upstream')\n" % bad
        script += "self.GetOutput().ShallowCopy(Drawing(Spread('Everywhere')))\n"
        result = mesh(producer(script))
        answer['Polylines.Upstream' + name] = dict(result, messages=0)  # those are not ours


def aborts(answer):
    """The first rank, which works, is stopped."""
    mesher = BitingMesher(Input=drawing('Divided'), UniformSpacing=0.1)
    algorithm = mesher.GetClientSideObject()
    tag = algorithm.AddObserver('ProgressEvent', lambda *unused: algorithm.SetAbortExecute(1))
    answer['Abort.Stopped'] = run(mesher, (0, 1, 3))
    algorithm.RemoveObserver(tag)
    mesher.UniformSpacing = 1.0
    answer['Polylines.AfterAbort'] = run(mesher, (0, 1, 3))


def main():
    answer_with(globals())


def answer_with(scenarios):
    """Calls those of the functions that the arguments name, and writes what they say."""
    plugin = os.environ['BITING_PLUGIN']
    port = os.environ.get('BITING_SERVER_PORT')
    simple.LoadPlugin(plugin, ns=globals())
    if port:
        simple.Connect('localhost', int(port))
        simple.LoadPlugin(plugin, remote=True, ns=globals())
    answer = {}
    for name in sys.argv[1:]:
        scenarios[name](answer)
    with open(os.environ['BITING_ANSWER'], 'w', encoding='ascii') as file:
        json.dump(answer, file)


if __name__ == '__main__':
    main()
