# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Blocks whose arrays differ in type give what one dataset of the same content gives.

Run with a number to try so many random composites in place of a few."""

import math
import random
import struct
import sys
import unittest

from vtkmodules.vtkCommonCore import (
    VTK_CHAR, VTK_DOUBLE, VTK_FLOAT, VTK_ID_TYPE, VTK_INT, VTK_LONG, VTK_LONG_LONG, VTK_SHORT,
    VTK_SIGNED_CHAR, VTK_STRING, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_INT, VTK_UNSIGNED_LONG,
    VTK_UNSIGNED_LONG_LONG, VTK_UNSIGNED_SHORT, vtkAbstractArray, vtkPoints)
from vtkmodules.vtkCommonDataModel import (
    VTK_LINE, VTK_POLY_LINE, VTK_POLYGON, VTK_QUAD, VTK_TRIANGLE, VTK_VERTEX, vtkCompositeDataSet,
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
    vtkPolyData, vtkRectilinearGrid, vtkUnstructuredGrid)
from biting.vtkBitingFilters import vtkBitingMesher, vtkBitingRemesher, vtkMeshConformity

SIGNED = {VTK_SIGNED_CHAR: 8, VTK_CHAR: 8, VTK_SHORT: 16, VTK_INT: 32, VTK_LONG: 64,
          VTK_LONG_LONG: 64, VTK_ID_TYPE: 64}
UNSIGNED = {VTK_UNSIGNED_CHAR: 8, VTK_UNSIGNED_SHORT: 16, VTK_UNSIGNED_INT: 32,
            VTK_UNSIGNED_LONG: 64, VTK_UNSIGNED_LONG_LONG: 64}
REAL = (VTK_FLOAT, VTK_DOUBLE)
# Whether a char has a sign depends on the machine: it comes in masks and fixed tests only.
TYPES = [kind for kind in (*SIGNED, *UNSIGNED, *REAL, VTK_STRING) if kind != VTK_CHAR]
MASK = 'vtkValidPointMask'


class Column:
    """The values of an array: a type and one tuple of each element."""

    def __init__(self, kind, rows):
        self.kind, self.rows = kind, rows
        self.width = len(rows[0]) if rows else 1

    def array(self, name):
        array = vtkAbstractArray.CreateArray(self.kind)
        array.SetName(name)
        array.SetNumberOfComponents(self.width)
        array.SetNumberOfTuples(len(self.rows))
        for place, value in enumerate(value for row in self.rows for value in row):
            # Python's char is a text of one letter.
            array.SetValue(place, chr(value) if self.kind == VTK_CHAR else value)
        return array


def text_of(value, kind):
    if kind == VTK_STRING:
        return value
    if math.isnan(value):
        return 'nan'
    if kind in REAL:
        return next(text for digits in range(1, 18) for text in ['%.*g' % (digits, value)]
                    if float(text) == value or
                    (kind == VTK_FLOAT and as_float(float(text)) == value))
    return str(value)


def as_float(value):
    return struct.unpack('f', struct.pack('f', value))[0]


def kind_for(columns):
    """The type of all values."""
    kinds = {column.kind for column in columns}
    if len(kinds) == 1:
        return kinds.pop()
    if VTK_STRING in kinds:
        return VTK_STRING
    return VTK_DOUBLE if kinds & set(REAL) else VTK_LONG_LONG


def joined(columns, sizes):
    """One column of those of all blocks; None where a block has none."""
    given = [column for column in columns if column and column.rows]
    kind = kind_for(given)
    width = max(column.width for column in given)
    lacked = '' if kind == VTK_STRING else math.nan if kind in REAL else 0
    rows = []
    for column, size in zip(columns, sizes):
        for k in range(size):
            row = list(column.rows[k]) if column else []
            if kind == VTK_STRING:
                row = [text_of(value, column.kind) for value in row]
            rows.append(tuple(row + [lacked] * (width - len(row))))
    return Column(kind, rows)


class Block:
    """Points, cells and arrays, from which a dataset of any class is made."""

    def __init__(self, points=(), cells=(), name='', are_floats=False):
        self.points, self.cells, self.name = list(points), list(cells), name
        self.are_floats = are_floats
        self.of_points, self.of_cells = {}, {}

    def dataset(self, kind=vtkUnstructuredGrid):
        data, points = kind(), vtkPoints()
        points.SetDataType(VTK_FLOAT if self.are_floats else VTK_DOUBLE)
        for point in self.points:
            points.InsertNextPoint(*point, 0.0)
        data.SetPoints(points)
        data.Allocate(max(1, len(self.cells)))
        for shape, corners in self.cells:
            data.InsertNextCell(shape, len(corners), corners)
        for columns, arrays in ((self.of_points, data.GetPointData()),
                                (self.of_cells, data.GetCellData())):
            for name, column in columns.items():
                arrays.AddArray(column.array(name))
        return data


def united(blocks, are_named=True):
    """All blocks as one."""
    whole = Block(are_floats=any(block.are_floats for block in blocks))
    for block in blocks:
        first = len(whole.points)
        whole.points += block.points
        whole.cells += [(shape, [first + k for k in corners]) for shape, corners in block.cells]
    for association, items in (('of_points', 'points'), ('of_cells', 'cells')):
        sizes = [len(getattr(block, items)) for block in blocks]
        given = [getattr(block, association) for block in blocks]
        names = [name for columns in given for name in columns if columns[name].rows]
        for name in dict.fromkeys(names):
            getattr(whole, association)[name] = joined(
                [columns.get(name) for columns in given], sizes)
    if are_named:
        whole.of_cells['BlockName'] = Column(
            VTK_STRING, [(block.name,) for block in blocks for _ in block.cells])
    return whole


def tree_of(datasets, names, choice):
    """A composite with empty and missing blocks between, or a dataset."""
    def set_block(tree, number, data, name):
        tree.SetBlock(number, data)
        if name:
            tree.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    if choice.random() < 0.3:
        collection = vtkPartitionedDataSetCollection()
        for number, (data, name) in enumerate(zip(datasets, names)):
            parts = vtkPartitionedDataSet()
            parts.SetPartition(choice.randrange(2), data)
            collection.SetPartitionedDataSet(number, parts)
            if name:
                collection.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
        return collection
    tree, number = vtkMultiBlockDataSet(), 0
    for data, name in zip(datasets, names):
        number += choice.randrange(2)  # a block that is not there
        if choice.random() < 0.2:
            strange = vtkPolyData()
            strange.GetCellData().AddArray(
                vtkAbstractArray.CreateArray(choice.choice(TYPES)))
            strange.GetCellData().GetAbstractArray(0).SetName('Tag')
            set_block(tree, number, strange, 'nothing')
            number += 1
        if choice.random() < 0.3:
            inner = vtkMultiBlockDataSet()
            set_block(inner, choice.randrange(2), data, name)
            set_block(tree, number, inner, '')
        else:
            set_block(tree, number, data, name)
        number += 1
    return tree


def bytes_of(data):
    """All of a dataset, so that equal ones are equal."""
    content = {}
    for kind, arrays in (('point', data.GetPointData()), ('cell', data.GetCellData())):
        for k in range(arrays.GetNumberOfArrays()):
            array = arrays.GetAbstractArray(k)
            values = ([array.GetValue(i) for i in range(array.GetNumberOfValues())]
                      if array.GetDataType() in (VTK_STRING, VTK_CHAR)
                      else bytes(memoryview(array)))
            content[kind, array.GetName()] = (
                array.GetDataType(), array.GetNumberOfComponents(), values)
    points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
    cells = [[data.GetCell(k).GetPointId(i) for i in range(data.GetCell(k).GetNumberOfPoints())]
             for k in range(data.GetNumberOfCells())]
    return content, points, cells


def outcome(algorithm):
    """Messages and outputs."""
    said = []
    def listen(_, event, text):
        said.append((event, text[text.find('): ') + 3:]))
    listen.CallDataType = 'string0'
    algorithm.AddObserver('ErrorEvent', listen)
    algorithm.AddObserver('WarningEvent', listen)
    algorithm.Update()
    outputs = [algorithm.GetOutputDataObject(port)
               for port in range(algorithm.GetNumberOfOutputPorts())]
    return said, [bytes_of(data) for data in outputs if data.IsA('vtkDataSet')]


def random_column(choice, size, kind=None):
    kind = choice.choice(TYPES) if kind is None else kind
    width = choice.choice((1, 1, 1, 2, 3))
    def value():
        if kind == VTK_STRING:
            return choice.choice(('wall', '1', '', '2.5'))
        if kind in REAL:
            real = choice.choice((0.0, 1.0, 2.0, 1.5, -3.0, 0.1, 1e20, math.nan))
            return as_float(real) if kind == VTK_FLOAT else real
        bits = min(UNSIGNED.get(kind) or SIGNED[kind] - 1, 63)
        least = 0 if kind in UNSIGNED else -2**bits
        wide = [2**32 + 1, 2**53, 2**53 + 1, 2**bits - 1, least]
        small = [0, 1, 1, 2, 3, max(least, -1)]
        return choice.choice([v for v in small + wide * (choice.random() < 0.2)
                              if least <= v < 2**bits])
    return Column(kind, [tuple(value() for _ in range(width)) for _ in range(size)])


def square_ring(low, high):
    return [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]


def random_drawing(choice, kinds):
    """A square with others in it as outlines, or squares in a row as cells."""
    blocks, are_faces = [], choice.random() < 0.5
    for k in range(choice.randint(1, 4)):
        block = Block(name=choice.choice(('', 'a', 'b')), are_floats=choice.random() < 0.2)
        if are_faces:
            block.points = square_ring((4.0 * k, 0.0), (4.0 * k + 4.0, 8.0))
            block.cells = [(choice.choice((VTK_POLYGON, VTK_QUAD)), [0, 1, 2, 3])]
            if choice.random() < 0.5:
                block.points += [(4.0 * k, 12.0), (4.0 * k + 4.0, 12.0)]
                block.cells.append((VTK_QUAD, [3, 2, 5, 4]))
        else:
            low, high = (0.0, 16.0) if k == 0 else (4.0 * k, 4.0 * k + 2.0)
            block.points = square_ring((low, low), (high, high))
            block.cells = [(VTK_LINE, [0, 1]), (VTK_POLY_LINE, [1, 2, 3, 0])]
            if choice.random() < 0.3:
                block.points.append((2.0, 12.0 - k))
                block.cells.append((VTK_VERTEX, [4]))
        blocks.append(block)
    for name in ('Tag', 'Other', 'Third')[:choice.randint(1, 3)]:
        for block in blocks:
            # One block has tags, so that types of empty blocks do not count.
            if choice.random() < 0.85 or block is blocks[0] and name == 'Tag':
                kind = kinds[blocks.index(block)] if name == 'Tag' else None
                block.of_cells[name] = random_column(choice, len(block.cells), kind)
    return blocks


def add_spacing_of_points(choice, blocks):
    """In all blocks: a point of a block without it asks for nothing, in one dataset it must."""
    for block in blocks:
        kind = choice.choice((VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE))
        values = (1, 2) if kind not in REAL else (1.0, 1.5, 2.25)
        block.of_points['Spacing'] = Column(
            kind, [(choice.choice(values),) for _ in block.points])


def tile(choice, column, whole_values):
    """A tile of an image of 17 nodes, with its part of the values where they are whole."""
    first, last = column * 4, column * 4 + 4
    image = vtkImageData()
    image.SetExtent(first, last, 0, 8, 0, 0)
    image.SetOrigin(-1.0, -1.0, 0.0)
    image.SetSpacing(1.5, 2.25, 1.0)
    kind = choice.choice((VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_SIGNED_CHAR, VTK_ID_TYPE))
    rows = []
    for j in range(9):
        for i in range(first, last + 1):
            is_shared = i in (first, last)
            if not is_shared and kind in REAL:
                whole_values[j][i] += 0.25
            rows.append((whole_values[j][i] if kind in REAL else int(whole_values[j][i]),))
    image.GetPointData().AddArray(Column(kind, rows).array('Spacing'))
    return image


def tiled_source(choice):
    count = choice.randint(1, 4)
    values = [[float(choice.choice((1, 2))) for _ in range(4 * count + 1)] for _ in range(9)]
    tiles = [tile(choice, k, values) for k in range(count)]
    whole = vtkImageData()
    whole.SetExtent(0, 4 * count, 0, 8, 0, 0)
    whole.SetOrigin(-1.0, -1.0, 0.0)
    whole.SetSpacing(1.5, 2.25, 1.0)
    whole.GetPointData().AddArray(
        Column(VTK_DOUBLE, [(v,) for row in values for v in row]).array('Spacing'))
    return tiles, whole


def celled_source(choice):
    """Triangles and quads; some values are masked, zero or texts."""
    blocks = []
    for k in range(choice.randint(1, 4)):
        block = Block(are_floats=choice.random() < 0.3)
        block.points = square_ring((6.0 * k - 1.0, -1.0), (6.0 * k + 5.0, 18.0))
        block.cells = choice.choice(([(VTK_QUAD, [0, 1, 2, 3])],
                                     [(VTK_TRIANGLE, [0, 1, 2]), (VTK_TRIANGLE, [0, 2, 3])]))
        kind = choice.choice([t for t in TYPES if t != VTK_STRING])
        values = (1, 2, 3) if kind not in REAL else (1.0, 1.5, 2.25, 3.0)
        if choice.random() < 0.1:
            values += (0,)
        rows = [(choice.choice(values),) for _ in range(4)]
        if choice.random() < 0.05:
            rows = [row * 3 for row in rows]
        block.of_points['Spacing'] = Column(kind, rows)
        if choice.random() < 0.05:
            block.of_points['Spacing'] = Column(VTK_STRING, [('1',)] * 4)
        elif choice.random() < 0.3 and len(rows[0]) == 1:
            block.of_points[MASK] = Column(VTK_CHAR, [(choice.choice((0, 1)),) for _ in range(4)])
        blocks.append(block)
    whole = united(blocks, False)
    if MASK in whole.of_points:
        masks = [block.of_points.get(MASK, Column(VTK_CHAR, [(1,)] * 4)) for block in blocks]
        whole.of_points[MASK] = joined(masks, [4] * len(blocks))
    kinds = (vtkUnstructuredGrid, vtkPolyData)
    return [block.dataset(choice.choice(kinds)) for block in blocks], whole.dataset()


def mesh_of(choice):
    mesher = vtkBitingMesher()
    mesher.SetInputData(Block(square_ring((0.0, 0.0), (9.0, 9.0)),
                              [(VTK_POLYGON, [0, 1, 2, 3])]).dataset())
    mesher.SetUniformSpacing(choice.choice((1.0, 2.0)))
    mesher.Update()
    return mesher.GetOutput()


def outcomes(seed):
    """What a composite gives, and what one dataset gives."""
    choice = random.Random(seed)
    pair = TYPES[seed % len(TYPES)], TYPES[seed // len(TYPES) % len(TYPES)]
    drawing, source = random_drawing(choice, [*pair, None, None]), None
    if choice.random() < 0.3:
        add_spacing_of_points(choice, drawing)
    whole = united(drawing)
    data = [block.dataset(vtkUnstructuredGrid if any(c[0] == VTK_VERTEX for c in block.cells)
                          else choice.choice((vtkUnstructuredGrid, vtkPolyData)))
            for block in drawing]
    inputs = [tree_of(data, [block.name for block in drawing], choice), whole.dataset()]
    if choice.random() < 0.6:
        datasets, one = choice.choice((tiled_source, celled_source))(choice)
        source = [tree_of(datasets, [''] * len(datasets), choice), one]
    region = 'Tag' if 'Tag' in whole.of_cells and choice.random() < 0.7 else ''
    tolerance = choice.choice((0.0, 0.0, 0.3))
    other = choice.choice((vtkBitingRemesher, vtkMeshConformity, None, None))
    mesh = mesh_of(choice) if other and source else None
    results = []
    for k in range(2):
        filter_ = other() if mesh else vtkBitingMesher()
        filter_.SetInputDataObject(mesh or inputs[k])
        if source:
            filter_.SetSpacingSourceData(source[k])
        if not mesh:
            filter_.SetUniformSpacing(3.0)
            filter_.SetRegionArray(region)
            filter_.SetBoundaryTolerance(tolerance)
        results.append(outcome(filter_))
    return results


def tags_of(*columns):
    """The type and the values of the array `Tag` on the edges of squares with these columns."""
    blocks = vtkMultiBlockDataSet()
    for k, column in enumerate(columns):
        block = Block(square_ring((2.0 * k, 0.0), (2.0 * k + 1.0, 1.0)),
                      [(VTK_POLYGON, [0, 1, 2, 3])])
        block.of_cells['Tag'] = Column(column[0], [column[1:]])
        blocks.SetBlock(k, block.dataset())
    mesher = vtkBitingMesher()
    mesher.SetInputDataObject(blocks)
    mesher.SetUniformSpacing(1.0)
    mesher.SetRegionArray('Tag')
    mesher.Update()
    tags = mesher.GetOutputDataObject(1).GetCellData().GetAbstractArray('Tag')
    width = tags.GetNumberOfComponents()
    values = [tags.GetValue(k) for k in range(tags.GetNumberOfValues())]
    rows = [tuple(values[k:k + width]) for k in range(0, len(values), width)]
    return tags.GetDataType(), list(dict.fromkeys(map(str, rows)))


def vertices_with(*sources):
    """The number of vertices on a square that these halves cover, and the messages."""
    blocks = vtkMultiBlockDataSet()
    for k, columns in enumerate(sources):
        block = Block(square_ring((k, 0.0), (k + 1.0, 2.0)), [(VTK_QUAD, [0, 1, 2, 3])])
        block.of_points = columns
        blocks.SetBlock(k, block.dataset())
    mesher = vtkBitingMesher()
    mesher.SetInputData(
        Block(square_ring((0.0, 0.0), (2.0, 2.0)), [(VTK_POLYGON, [0, 1, 2, 3])]).dataset())
    mesher.SetSpacingSourceData(blocks)
    said, outputs = outcome(mesher)
    return len(outputs[0][1]), [text for _, text in said]


def spacing(kind, value, name='Spacing'):
    return {name: Column(kind, [(value,)] * 4)}


class TestCompositeTypes(unittest.TestCase):
    cases = 60

    def test_random_blocks_give_what_one_dataset_gives(self):
        for seed in range(self.cases):
            blocks, one = outcomes(seed)
            self.assertEqual(blocks, one, 'seed %d' % seed)

    def test_tags_of_several_types_are_of_one(self):
        expected = (
            (VTK_DOUBLE, ['(1.0,)', '(1.5,)'], (VTK_INT, 1), (VTK_DOUBLE, 1.5)),
            (VTK_DOUBLE, ['(0.5,)', '(7.0,)'], (VTK_FLOAT, 0.5), (VTK_UNSIGNED_CHAR, 7)),
            (VTK_LONG_LONG, ['(1,)', '(4294967297,)'], (VTK_INT, 1), (VTK_LONG_LONG, 2**32 + 1)),
            (VTK_LONG_LONG, ['(-1,)', '(255,)'], (VTK_SIGNED_CHAR, -1), (VTK_UNSIGNED_CHAR, 255)),
            (VTK_STRING, ["('1.5',)", "('wall',)"], (VTK_DOUBLE, 1.5), (VTK_STRING, 'wall')),
            (VTK_STRING, ["('wall',)", "('-7',)"], (VTK_STRING, 'wall'), (VTK_SIGNED_CHAR, -7)),
            (VTK_STRING, ["('0.1',)", "('a',)"], (VTK_FLOAT, 0.1), (VTK_STRING, 'a')),
            (VTK_INT, ['(1, 0, 0)', '(4, 5, 6)'], (VTK_INT, 1), (VTK_INT, 4, 5, 6)),
            (VTK_DOUBLE, ['(1.5, nan)', '(4.0, 5.0)'], (VTK_DOUBLE, 1.5), (VTK_CHAR, 4, 5)))
        for kind, values, *columns in expected:
            self.assertEqual(tags_of(*columns), (kind, values))

    def test_sources_of_several_types_are_one(self):
        alike, said = vertices_with(spacing(VTK_DOUBLE, 0.25), spacing(VTK_DOUBLE, 1.0))
        self.assertEqual(said, [])
        for first, second in ((VTK_FLOAT, VTK_DOUBLE), (VTK_DOUBLE, VTK_UNSIGNED_CHAR),
                              (VTK_DOUBLE, VTK_ID_TYPE), (VTK_FLOAT, VTK_INT)):
            self.assertEqual(
                vertices_with(spacing(first, 0.25), spacing(second, 1)), (alike, []))
        masked = dict(spacing(VTK_FLOAT, 0.25), **spacing(VTK_CHAR, 1, MASK))
        self.assertEqual(vertices_with(masked, spacing(VTK_INT, 1)), (alike, []))

    def test_a_source_with_texts_or_several_arrays_is_told_of(self):
        said = vertices_with(spacing(VTK_DOUBLE, 0.5), spacing(VTK_STRING, '1'))[1]
        self.assertEqual(len(said), 1)
        self.assertIn('is not numeric', said[0])
        said = vertices_with(spacing(VTK_DOUBLE, 0.5, 'f'), spacing(VTK_DOUBLE, 0.5, 'g'))[1]
        self.assertEqual(len(said), 1)
        self.assertIn('The spacing source is not used', said[0])
        self.assertEqual(
            vertices_with(spacing(VTK_DOUBLE, 0.5, 'f'), spacing(VTK_FLOAT, 0.5, 'f'))[1], [])

    def test_coordinates_of_grids_are_not_rounded_to_the_type_of_the_first_block(self):
        def grid(kind, first, *nodes):
            grid = vtkRectilinearGrid()
            grid.SetExtent(first, first + len(nodes) - 1, 0, 1, 0, 0)
            grid.SetXCoordinates(Column(kind, [(x,) for x in nodes]).array('x'))
            grid.SetYCoordinates(Column(kind, [(0.0,), (2.0,)]).array('y'))
            grid.SetZCoordinates(Column(VTK_DOUBLE, [(0.0,)]).array('z'))
            values = [(0.25 + 0.1 * x,) for x in nodes] * 2
            grid.GetPointData().AddArray(Column(VTK_DOUBLE, values).array('Spacing'))
            return grid
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, grid(VTK_FLOAT, 0, 0.0, 1.0))
        blocks.SetBlock(1, grid(VTK_DOUBLE, 1, 1.0, 1.7, 2.0))
        square = Block(square_ring((0.0, 0.0), (2.0, 2.0)), [(VTK_POLYGON, [0, 1, 2, 3])])
        results = []
        for source in (blocks, grid(VTK_DOUBLE, 0, 0.0, 1.0, 1.7, 2.0)):
            mesher = vtkBitingMesher()
            mesher.SetInputData(square.dataset())
            mesher.SetSpacingSourceData(source)
            results.append(outcome(mesher))
        self.assertEqual(*results)

    def test_arrays_with_too_few_values_are_refused(self):
        said = vertices_with(spacing(VTK_INT, 1), {'Spacing': Column(VTK_FLOAT, [(1.0,)] * 2)})[1]
        self.assertEqual(said, ['The spacing array Spacing has 2 values for 4 points.\n\n'])
        blocks = vtkMultiBlockDataSet()
        for k, count in enumerate((4, 3)):
            block = Block(square_ring((2.0 * k, 0.0), (2.0 * k + 1.0, 1.0)),
                          [(VTK_LINE, [i, (i + 1) % 4]) for i in range(4)])
            kind, tag = ((VTK_INT, 1), (VTK_STRING, '1'))[k]
            block.of_cells['Tag'] = Column(kind, [(tag,)] * count)
            blocks.SetBlock(k, block.dataset())
        mesher = vtkBitingMesher()
        mesher.SetInputDataObject(blocks)
        mesher.SetRegionArray('Tag')
        said, _ = outcome(mesher)
        self.assertEqual([text for _, text in said],
                         ['The cell array Tag has 7 values for 8 cells.\n\n'])

    def test_a_spacing_behind_a_block_of_whole_numbers_keeps_its_value(self):
        sizes = []
        for kind in (VTK_DOUBLE, VTK_INT):
            blocks = vtkMultiBlockDataSet()
            for k, column in enumerate((spacing(kind, 1), spacing(VTK_DOUBLE, 0.05))):
                block = Block(square_ring((2.0 * k, 0.0), (2.0 * k + 1.0, 1.0)),
                              [(VTK_POLYGON, [0, 1, 2, 3])])
                block.of_points = column
                blocks.SetBlock(k, block.dataset())
            mesher = vtkBitingMesher()
            mesher.SetInputDataObject(blocks)
            said, outputs = outcome(mesher)
            self.assertEqual(said, [])
            sizes.append(len(outputs[0][1]))
        self.assertEqual(sizes[0], sizes[1])
        self.assertGreater(sizes[0], 200)


if __name__ == '__main__':
    if len(sys.argv) > 1 and sys.argv[1].isdigit():
        TestCompositeTypes.cases = int(sys.argv.pop(1))
    unittest.main()
