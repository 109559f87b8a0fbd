# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: other_meshes.py PROGRAM

The program reads glTF, DAE and 3MF by assimp as they are: each face with its corners, placed by the nodes of the file, in
its numbers and axes. A program that was built without assimp says so.
"""

import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
FLOATS = "coordinates are 32-bit floats, to which assimp rounds the numbers of the file"
WITHOUT = "; this program was built without assimp (libassimp-dev), which reads others"


def gltf(corners, numbers, nodes, mode=4):
    """Triangles, or lines, with 32-bit floats and 16-bit numbers in a buffer within the text."""
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    data += struct.pack(f"<{len(numbers)}H", *numbers)
    size = 12 * len(corners)
    lowest, highest = ([pick(column) for column in zip(*corners)] for pick in (min, max))
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": mode}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3", "min": lowest, "max": highest},
                      {"bufferView": 1, "componentType": 5123, "count": len(numbers), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": size},
                        {"buffer": 0, "byteOffset": size, "byteLength": len(data) - size}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]})


def dae(numbers, counts, corners, unit="1", axis="Y_UP", place=""):
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="{unit}" name="unit"/><up_axis>{axis}</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="{len(numbers.split())}">{numbers}</float_array>
<technique_common><accessor source="#a" count="{len(numbers.split()) // 3}" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<polylist count="{len(counts.split())}"><input semantic="VERTEX" source="#v" offset="0"/><vcount>{counts}</vcount><p>{corners}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node>{place}<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>"""


def threemf(file, vertices, triangles, unit="millimeter"):
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("[Content_Types].xml", '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
                         '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
                         '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
        archive.writestr("_rels/.rels", '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
                         '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
                         'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        points = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in vertices)
        faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles)
        archive.writestr("3D/3dmodel.model", f'<?xml version="1.0"?><model unit="{unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
                         f'<resources><object id="1" type="model"><mesh><vertices>{points}</vertices><triangles>{faces}</triangles></mesh></object></resources>'
                         '<build><item objectid="1"/></build></model>')


class OtherMeshes(unittest.TestCase):
    NOISE = ("assimp: Collada: No material", "assimp: Ignored file of un")  # not about the mesh

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def ask(self, name, balls, *options):
        """The faces that each ball touches, if the file is read, and what the program says about the file."""
        run = subprocess.run([PROGRAM, "scenes", name, "--balls", "-", "--quiet", *options], cwd=self.folder, capture_output=True, text=True,
                             input="".join(" ".join(map(repr, ball)) + "\n" for ball in balls))
        said = run.stderr.strip().replace(f"touchstone: warning: {name}: ", "").replace(f"touchstone: {name}: ", "").split("\n")
        if said[0].endswith(WITHOUT):
            self.assertEqual((run.returncode, len(said)), (2, 1))
            self.skipTest("the program was built without assimp (libassimp-dev)")
        self.assertEqual(run.returncode, 0 if run.stdout else 2, run.stderr)
        touched = [[touched["face"] for touched in json.loads(line)["touched"]] for line in run.stdout.splitlines()]
        return touched, [line for line in said if not line.startswith(self.NOISE)]

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def test_a_program_without_assimp_names_the_package(self):
        self.write("part.dae", "")
        run = subprocess.run([PROGRAM, "scenes", "part.dae", "--samples", "1"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"^touchstone: part\.dae: (assimp: |unknown extension '\.dae'.*\(libassimp-dev\))")

    def test_gltf_is_placed_by_its_nodes_in_doubles(self):
        # 16777216 + 1 is no float.
        nodes = [{"mesh": 0, "translation": [16777216, 0, 0]},
                 {"children": [2], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [0, 0, 5]}]
        text = json.loads(gltf([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [0, 1, 2], nodes))
        text["scenes"][0]["nodes"] = [0, 1]
        self.write("part.gltf", json.dumps(text))
        touched, said = self.ask("part.gltf", [(0, 0, 0, 1e9), (16777217, 0, 0, 0), (16777216, 0, 0, 0), (16777218, 0, 0, 0),
                                               (0, 2, 10, 0), (2, 0, 10, 0), (2, 0.001, 10, 0), (0, 0, 0, 9)])
        self.assertEqual(touched, [[0, 1], [0], [0], [], [1], [1], [], []])
        self.assertEqual(said, [FLOATS])

    def test_gltf_keeps_degenerate_faces_and_unshared_vertices(self):
        self.write("part.gltf", gltf([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0)], [0, 1, 2, 0, 3, 1], [{"mesh": 0}]))
        touched, said = self.ask("part.gltf", [(0, 0, 0, 1)])
        self.assertEqual((touched, len(said)), ([], 2))
        self.assertRegex(said[1], "^face 1: repeated-vertex: ")
        touched, said = self.ask("part.gltf", [(0, 0, 0, 1)], "--skip-bad")
        self.assertEqual(touched, [[0]])

    def test_gltf_of_lines_has_no_face(self):
        self.write("part.gltf", gltf([(0, 0, 0), (1, 0, 0)], [0, 1], [{"mesh": 0}], mode=1))
        self.assertEqual(self.ask("part.gltf", [(0, 0, 0, 1)])[1][-1], "the file has no face")

    def test_gltf_with_a_number_out_of_range_is_refused(self):
        self.write("part.gltf", gltf([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [0, 1, 2, 0, 1, 7], [{"mesh": 0}]))
        reason = "assimp: Some faces had out-of-range indices. Those faces were dropped."
        self.assertEqual(self.ask("part.gltf", [(0, 0, 0, 1)]), ([], [reason]))
        self.assertEqual(self.ask("part.gltf", [(0, 0, 0, 1)], "--skip-bad")[0], [[0]])

    def test_dae_keeps_polygons_numbers_unit_and_axes(self):
        self.write("part.dae", dae("0 0 1  4 0 1  1 1 1  0 4 1", "4 3", "0 1 2 3  0 1 2", unit="0.001", axis="Z_UP"))
        touched, said = self.ask("part.dae", [(0, 0, 0, 1e9), (0, 4, 1, 0), (4, 0, 1, 0), (2, 2, 1, 0), (1, 0.5, 1, 0)])
        self.assertEqual(touched, [[0, 1], [0], [0, 1], [], [0, 1]])
        self.assertEqual(said, ["numbers are kept as they are; the file gives their unit as 0.001 m", FLOATS])

    def test_dae_is_rounded_to_floats_and_placed(self):
        self.write("part.DAE", dae("0.1 0 0  1 0 0  0 1 0", "3", "0 1 2", axis="Z_UP", place="<translate>0 0 2</translate>"))
        as_float = struct.unpack("<f", struct.pack("<f", 0.1))[0]
        touched, said = self.ask("part.DAE", [(as_float, 0, 2, 0), (0.1, 0, 2, 0), (0, 0, 0, 1.5)])
        self.assertEqual((touched, said), ([[0], [], []], [FLOATS]))

    def test_3mf_keeps_its_numbers(self):
        threemf(self.folder / "part.3mf", [(0, 0, 0), (4, 0, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 1)], unit="inch")
        touched, said = self.ask("part.3mf", [(0, 0, 0, 1e9), (4, 0, 0, 0), (0, 4, 0, 0), (4.001, 0, 0, 0)])
        self.assertEqual((touched, said), ([[0, 1], [0, 1], [0, 1], []], [FLOATS]))

    def test_what_is_not_of_the_format_is_refused(self):
        for name in ("part.gltf", "part.dae", "part.3mf"):
            self.write(name, "solid")
            self.assertRegex(self.ask(name, [(0, 0, 0, 1)])[1][-1], "^assimp: .")

    def test_a_file_that_is_not_there_is_named(self):
        self.assertEqual(self.ask("none.gltf", [(0, 0, 0, 1)])[1], ["cannot be opened"])


if __name__ == "__main__":
    unittest.main()
