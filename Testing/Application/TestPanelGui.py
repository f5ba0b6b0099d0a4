# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The panel and the view of the real ParaView window: the summary is that of the mesh that is shown,
whatever made it new; fields come in their order, with what they can mean; legends and axes say what
they show.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import os
import re
import sys

import paraview_window as window

FIELDS = (window.PANEL + '/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/'
          'PropertiesFrame/ProxyPanel/')
LINE = '/DoubleLineEdit0'  # a field without a slider
HEADER = '# vtk DataFile Version 3.0\ndrawing\nASCII\nDATASET POLYDATA\n'
SQUARE = HEADER + 'POINTS 4 double\n0 0 0  {0} 0 0  {0} {0} 0  0 {0} 0\nLINES 1 6\n5 0 1 2 3 0\n'
CROSSED = HEADER + '''POINTS 10 double
0 0 0  10 0 0  10 10 0  0 10 0  2 2 0  8 8 0  2 8 0  8 2 0  12 4 0  14 6 0
LINES {0} {1}
5 0 1 2 3 0
2 4 5
2 6 7
'''


def main(plugin_folder, output):
    meshes(plugin_folder, os.path.join(output, 'meshes'))
    time_steps(plugin_folder, os.path.join(output, 'time_steps'))


def meshes(plugin_folder, output):
    session = window.Window('TestPanelGui', plugin_folder, output)
    session.open(os.path.join(window.DATA, 'plate.vtk'))
    session.check(add_a_source)
    session.choose_filter('BitingMesher')
    session.check(the_uniform_spacing_comes_first)
    session.apply()
    session.check(the_summary_is_of_the_mesh)
    session.check(the_legend_has_degrees_and_edges_are_shown)
    for spacing in ('0.1', '0.4'):
        session.event(FIELDS + 'UniformSpacing' + LINE, 'set_string', spacing)
        session.apply()
        session.check(the_summary_is_of_the_mesh)
    session.event(FIELDS + 'UniformSpacing' + LINE, 'set_string', '0.2')
    session.apply()
    session.event(window.MAIN + '/menubar/menu_Edit', 'activate', 'actionEditUndo')
    session.check(the_spacing_is_again, 0.4)
    session.check(the_summary_is_of_the_mesh)
    session.event(window.PANEL + '/SearchBox/AdvancedButton', 'activate')
    session.check(the_corner_angle_counts, 'false')
    session.event(FIELDS + 'BoundaryTolerance' + LINE, 'set_string', '0.2')
    session.check(the_corner_angle_counts, 'true')
    session.event(FIELDS + 'SpacingSource/1QComboBox0', 'set_string', 'Lengths')
    session.check(the_only_array_of_the_source_is_chosen)
    session.apply()
    session.check(the_summary_is_of_the_mesh)
    session.choose_filter('MeshConformity')
    session.apply()
    session.check(the_axes_have_titles)
    session.check(make_many_triangles)
    session.check(edges_of_many_triangles_are_hidden)
    session.run()


def time_steps(plugin_folder, output):
    session = window.Window('TestPanelGui', plugin_folder, output)
    session.check(draw_steps)
    session.choose_filter('BitingMesher')
    session.apply()
    session.check(the_summary_is_of_the_mesh)
    session.check(the_kinds_of_problems_are, ['3', '6'])
    session.check(go_on)
    session.check(the_kinds_of_problems_are, ['3'])
    session.check(the_summary_is_of_the_mesh)
    session.check(the_summary_tells_of_the_crossing)
    session.check(go_on)
    session.check(the_summary_is_of_the_mesh)
    session.run(expected=('Crossing segments', 'Interfaces outside'))


def mesher():
    from paraview import simple
    return simple.FindSource('BitingMesher1')


def add_a_source(_output):
    from paraview import simple
    image = simple.Wavelet(WholeExtent=[0, 12, 0, 6, 0, 0])
    lengths = simple.Calculator(Input=image, ResultArrayName='h', Function='0.2 + coordsX / 50')
    only = simple.PassArrays(registrationName='Lengths', Input=lengths, PointDataArrays=['h'])
    only.UpdatePipeline()
    simple.SetActiveSource(simple.FindSource('plate.vtk'))


def the_uniform_spacing_comes_first(_output):
    def height(name):
        return int(window.widgets(name, 'y')[0])
    assert height('UniformSpacing') < height('BoundarySpacingArray') < height('SpacingSource')
    assert height('SpacingSource') < height('SpacingScale')


def the_summary_is_of_the_mesh(output):
    window.take_screen(os.path.join(output, f'{len(os.listdir(output))}.png'))
    text = window.widgets('SummaryText', 'text')
    found = re.fullmatch('([0-9 ]+) vertices, ([0-9 ]+) triangles', text[0])
    assert found, text
    shown = mesher().GetDataInformation()
    counts = [int(count.replace(' ', '')) for count in found.groups()]
    assert counts == [shown.GetNumberOfPoints(), shown.GetNumberOfCells()], text


def the_spacing_is_again(_output, spacing):
    """After Undo, with no check before it: Python makes ParaView forget what can be undone."""
    assert mesher().UniformSpacing == spacing, mesher().UniformSpacing


def the_summary_tells_of_the_crossing(_output):
    text = window.widgets('SummaryText', 'text')
    assert 'Warning: Crossing segments (1), see Problems' in text, text


def the_legend_has_degrees_and_edges_are_shown(_output):
    from paraview import simple
    view = simple.GetActiveView()
    legend = simple.GetScalarBar(simple.GetColorTransferFunction('MinimumAngle'), view)
    assert legend.Title == 'Smallest angle (degrees)', legend.Title
    assert legend.RangeLabelFormat == '%g', legend.RangeLabelFormat
    shown = simple.GetRepresentation(mesher(), view)
    assert shown.Representation == 'Surface With Edges'
    assert min(shown.EdgeColor) > 0.8, 'edges that are darker than the mesh hide its colours'


def the_corner_angle_counts(_output, expected):
    assert window.widgets('CornerAngle', 'enabled') == [expected]


def the_only_array_of_the_source_is_chosen(_output):
    assert 'h' in window.widgets('ComboBox', 'currentText')
    assert mesher().SourceSpacingArray[1] == 'h'


def the_axes_have_titles(output):
    from paraview import simple
    chart = simple.GetActiveView()
    window.take_screen(os.path.join(output, 'chart.png'))
    assert chart.BottomAxisTitle == 'Angle of triangles (degrees)', chart.BottomAxisTitle
    shown = simple.GetRepresentation(simple.OutputPort(simple.GetActiveSource(), 1), chart)
    shown.XArrayName = 'Conformity'
    simple.Render(chart)
    assert chart.BottomAxisTitle == 'Conformity of vertices (best: 1)', chart.BottomAxisTitle
    assert chart.LeftAxisTitle == 'Share (percent)', chart.LeftAxisTitle


def make_many_triangles(_output):
    from paraview import simple
    view = simple.FindView('RenderView1')
    many = simple.BitingMesher(registrationName='Many', Input=simple.FindSource('plate.vtk'),
                               UniformSpacing=0.045)
    simple.Show(many, view)


def edges_of_many_triangles_are_hidden(output):
    from paraview import simple
    many = simple.FindSource('Many')
    window.take_screen(os.path.join(output, 'many.png'))
    assert many.GetDataInformation().GetNumberOfCells() > 50000
    shown = simple.GetRepresentation(many, simple.FindView('RenderView1'))
    assert shown.Representation == 'Surface', shown.Representation


def draw_steps(output):
    """Of two repairs of two kinds, of one, and of none."""
    from paraview import simple
    paths = [os.path.join(output, f'step{k}.vtk') for k in range(3)]
    texts = (CROSSED.format(4, 15) + '2 8 9\n', CROSSED.format(3, 12), SQUARE.format(5))
    for path, text in zip(paths, texts):
        with open(path, 'w', encoding='ascii') as file:
            file.write(text)
    drawing = simple.LegacyVTKReader(FileNames=paths)
    simple.Show(drawing, simple.GetActiveView())
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.SetActiveSource(drawing)


def go_on(_output):
    from paraview import simple
    simple.GetAnimationScene().GoToNext()


def the_kinds_of_problems_are(output, kinds):
    from paraview import simple
    window.take_screen(os.path.join(output, f'kinds{len(kinds)}.png'))
    colors = simple.GetColorTransferFunction('ProblemKind')
    assert sorted(colors.ActiveAnnotatedValues) == kinds, list(colors.ActiveAnnotatedValues)


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
