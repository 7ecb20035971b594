"""read_ply.py READER STATS.json LANDED.ply [RELAXED.ply]: checks photon maps of caustic.pov, before
and after relaxation under constraints. READER is plyfile or trimesh, or `header`, which knows
nothing of photons and goes by what the file's header says.
"""

import json
import math
import struct
import sys

CODES = {
    "char": "b",
    "uchar": "B",
    "short": "h",
    "ushort": "H",
    "int": "i",
    "uint": "I",
    "float": "f",
    "double": "d",
}


def read_by_header(path):
    """Elements of a binary little-endian PLY file (Turk 1994) without lists, as {element:
    {property: values}}.
    """
    with open(path, "rb") as file:
        check(file.readline() == b"ply\n", "no PLY file")
        elements = []
        while (words := file.readline().decode("ascii").split()) != ["end_header"]:
            check(words != [], "the header has no end")
            if words[0] == "format":
                check(words[1:] == ["binary_little_endian", "1.0"], f"format {words}")
            elif words[0] == "element":
                elements.append((words[1], int(words[2]), []))
            elif words[0] == "property":
                elements[-1][2].append((words[2], CODES[words[1]]))
        found = {}
        for name, count, properties in elements:
            row = struct.Struct("<" + "".join(code for _, code in properties))
            rows = list(row.iter_unpack(file.read(row.size * count)))
            check(len(rows) == count, f"{len(rows)} rows of {name}, not {count}")
            columns = zip(*rows) if rows else [()] * len(properties)
            found[name] = {p: list(c) for (p, _), c in zip(properties, columns)}
        check(file.read() == b"", "more than the header says")
        return found


def read(reader, path):
    """The vertices' and the lights' columns by name."""
    if reader == "plyfile":
        import plyfile

        return [
            {p.name: element[p.name].tolist() for p in element.properties}
            for element in plyfile.PlyData.read(path)
        ]
    if reader == "trimesh":
        import trimesh

        raw = trimesh.load(path).metadata["_ply_raw"]
        return [
            {name: raw[element]["data"][name].tolist() for name in raw[element]["properties"]}
            for element in ("vertex", "light")
        ]
    found = read_by_header(path)
    return found["vertex"], found["light"]


def check(condition, what):
    if not condition:
        sys.exit(what)


def rows_of(columns):
    return [dict(zip(columns, values)) for values in zip(*columns.values())]


def vector(row, prefix, endings="xyz"):
    return [row[prefix + ending] for ending in endings]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def check_photon(row, most):
    """most: of the flux, at the distance 1; the light does not fade."""
    check(abs(row["y"] + 1.5) < 1e-5 and row["ny"] > 0.999, f"not on the floor: {row}")
    share = [row[f"flux_{c}"] / (most * row["path_length"] ** 2) for c in ("red", "green", "blue")]
    check(all(0.1 < s < 1.001 for s in share), f"flux: {row}, {share}")
    check(row["path_edges"] == 3 and row["path_length"] > 7, f"path: {row}")
    for unit in vector(row, "from_"), vector(row, "emitter_", "123"):
        check(abs(math.hypot(*unit) - 1) < 1e-3, f"no unit vector: {row}")


def check_constraint(row):
    along, across, normal = vector(row, "along_"), vector(row, "across_"), vector(row, "n")
    check(abs(math.hypot(*along) - 1) < 1e-3 and math.hypot(*across) < 1.0001, f"lengths: {row}")
    for a, b in (along, across), (along, normal), (across, normal):
        check(abs(dot(a, b)) < 0.02, f"not across each other: {row}")


def check_moved(landed, relaxed, statistics):
    """Only places change, by as much as the statistics say."""
    changed = {"x", "y", "z", "nx", "ny", "nz"}
    check(
        all(
            a[name] == b[name] for a, b in zip(landed, relaxed) for name in a if name not in changed
        ),
        "more than places",
    )
    distances = [math.dist(vector(a, ""), vector(b, "")) for a, b in zip(landed, relaxed)]
    mean, told = sum(distances) / len(distances), statistics["relaxation"]["mean_movement"]
    check(abs(mean - told) < 1e-3 * told and mean > 0, f"moved by {mean}, not {told}")
    free = sum(math.hypot(*vector(row, "across_")) for row in relaxed) / len(relaxed)
    check(abs(free - statistics["relaxation"]["mean_freedom"]) < 1e-3, f"freedom {free}")


def main():
    reader, statistics = sys.argv[1], json.load(open(sys.argv[2]))["photons"]
    maps = []
    for path in sys.argv[3:]:
        photons, lights = read(reader, path)
        check(
            len(photons["x"]) == statistics["stored"] > 100,
            f"{len(photons['x'])} photons of {statistics['stored']}",
        )
        check(len(lights["paths"]) == 1 and lights["paths"][0] >= 4000, f"lights: {lights}")
        maps.append(rows_of(photons))
        for row in maps[-1]:
            check_photon(row, lights["parameter_area"][0] / lights["paths"][0])
    if len(maps) == 2:
        for row in maps[1]:
            check_constraint(row)
        check_moved(*maps, statistics)


main()
