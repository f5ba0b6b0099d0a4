# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads shorelines from GSHHG files in the form that GMT uses ("binned", netCDF).

The globe is cut into square bins, counted eastward from Greenwich and southward from the pole. The
shorelines end at the borders of bins; points are 16-bit offsets from the south-west corner of their
bin, so that two pieces of one shoreline meet in exactly the same point.
"""

import ctypes

STEPS = 65535  # of the offsets across a bin
LAND = 1  # level of shorelines between sea and land


def shoreline_rings(path):
    """All closed shorelines, land on their left, as lists of (longitude, latitude) in degrees."""
    file = BinnedFile(path)
    return [[file.degrees(point) for point in ring] for ring in _join(file.segments(LAND))]


class BinnedFile:
    def __init__(self, path):
        self.Library = ctypes.CDLL("libnetcdf.so.19")  # comes with Debian's ParaView
        self.Handle = ctypes.c_int()
        self._call("nc_open", path.encode(), 0, ctypes.byref(self.Handle))
        self.Columns = self._read("N_bins_in_360_longitude_range")[0]
        self.Rows = self._read("N_bins_in_180_degree_latitude_range")[0]
        self.Longitudes = self._read("Relative_longitude_from_SW_corner_of_bin")
        self.Latitudes = self._read("Relative_latitude_from_SW_corner_of_bin")

    def segments(self, level):
        """Points are in steps, east of Greenwich and north of the south pole."""
        packed = self._read("Embedded_npts_levels_exit_entry_for_a_segment")
        first_points = self._read("Id_of_first_point_in_a_segment")
        for corner, segments in self._bins():
            for segment in segments:
                if packed[segment] >> 6 & 7 == level:
                    first, count = first_points[segment], packed[segment] >> 9
                    yield [self._point(corner, point) for point in range(first, first + count)]

    def degrees(self, point):
        return 360 / (self.Columns * STEPS) * point[0], 180 / (self.Rows * STEPS) * point[1] - 90

    def _bins(self):
        """The south-west corner of every bin and the range of its segments."""
        firsts = self._read("Id_of_first_segment_in_a_bin")
        counts = self._read("N_segments_in_a_bin")
        for bin_id, (first, count) in enumerate(zip(firsts, counts)):
            row, column = divmod(bin_id, self.Columns)
            yield (column * STEPS, (self.Rows - 1 - row) * STEPS), range(first, first + count)

    def _point(self, corner, point):
        east = corner[0] + (self.Longitudes[point] & STEPS)
        return east % (self.Columns * STEPS), corner[1] + (self.Latitudes[point] & STEPS)

    def _read(self, name):
        variable, dimension, length = ctypes.c_int(), ctypes.c_int(), ctypes.c_size_t()
        self._call("nc_inq_varid", self.Handle, name.encode(), ctypes.byref(variable))
        self._call("nc_inq_vardimid", self.Handle, variable, ctypes.byref(dimension))
        self._call("nc_inq_dimlen", self.Handle, dimension, ctypes.byref(length))
        values = (ctypes.c_int * length.value)()
        self._call("nc_get_var_int", self.Handle, variable, values)
        return list(values)

    def _call(self, function, *arguments):
        if getattr(self.Library, function)(*arguments) != 0:
            raise OSError(f"{function} failed")


def _join(segments):
    """Rings, without repeating their first point, of segments that continue where others end."""
    open_segments = {}
    for segment in segments:
        if segment[0] == segment[-1]:
            yield segment[:-1]
        else:
            open_segments[segment[0]] = segment
    while open_segments:
        _, ring = open_segments.popitem()
        while ring[-1] != ring[0]:
            ring = ring + open_segments.pop(ring[-1])[1:]
        yield ring[:-1]
