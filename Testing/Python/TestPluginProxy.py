# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The ways in which ParaView comes to the plugin at its start, and the version that its plugin manager
shows. Each is tried in a ParaView of its own: this one may have loaded the plugin before."""

import os
import subprocess
import tempfile
import unittest

SAY = '''
from paraview import servermanager, simple
plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
for k in range(plugins.GetNumberOfPlugins()):
    if plugins.GetPluginName(k) == 'BitingMesh':
        print('version', plugins.GetPluginVersion(k), plugins.GetAutoLoad(k))
mesh = simple.BitingMesher(Input=simple.Disk(), UniformSpacing=0.2)
mesh.UpdatePipeline()
print('triangles', mesh.GetDataInformation().GetNumberOfCells() > 0)
'''
# What ParaView writes when a user ticks Auto Load.
AUTO_LOAD = '<Plugins><Plugin name="BitingMesh" filename="%s" auto_load="1"/></Plugins>'


def said_by(**environment):
    """What a new ParaView, with the plugin in its surroundings only, says of it."""
    with tempfile.TemporaryDirectory() as folder:
        script = os.path.join(folder, 'say.py')
        with open(script, 'w', encoding='ascii') as file:
            file.write(SAY)
        process = subprocess.run(['pvpython', script], env=dict(os.environ, **environment),
                                 check=True, capture_output=True, text=True)
    return process.stdout.split('\n')[:-1]


class TestPluginProxy(unittest.TestCase):
    plugin = os.environ['BITING_PLUGIN']
    version = os.environ['BITING_VERSION']

    def test_a_folder_in_the_search_path_is_loaded_at_the_start(self):
        said = said_by(PV_PLUGIN_PATH=os.path.dirname(self.plugin))
        self.assertEqual(said, ['version %s False' % self.version, 'triangles True'])

    def test_auto_load_is_loaded_at_the_start(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'plugins.xml')
            with open(path, 'w', encoding='ascii') as file:
                file.write(AUTO_LOAD % self.plugin)
            said = said_by(PV_PLUGIN_CONFIG_FILE=path)
        self.assertEqual(said, ['version %s True' % self.version, 'triangles True'])


if __name__ == '__main__':
    unittest.main()
