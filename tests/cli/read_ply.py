"""read_ply.py MAP.ply STATS.json: checks a photon map of caustic.pov with a PLY reader that is not cognac's."""
import json
import math
import sys


def read(path):
    """Columns of the vertices and of the lights, by name."""
    try:
        import plyfile
        return [{p.name: element[p.name].tolist() for p in element.properties}
                for element in plyfile.PlyData.read(path)]
    except ImportError:
        import trimesh
        raw = trimesh.load(path).metadata["_ply_raw"]
        return [{name: raw[element]["data"][name].tolist() for name in raw[element]["properties"]}
                for element in ("vertex", "light")]


def check(condition, what):
    if not condition:
        sys.exit(what)


def main():
    photons, lights = read(sys.argv[1])
    stored = json.load(open(sys.argv[2]))["photons"]["stored"]
    check(len(photons["x"]) == stored > 100, f"{len(photons['x'])} photons read, {stored} stored")
    check(len(lights["paths"]) == 1 and lights["paths"][0] >= 4000, f"lights: {lights}")
    for i in range(stored):
        row = {name: column[i] for name, column in photons.items()}
        check(abs(row["y"] + 1.5) < 1e-5 and row["ny"] > 0.999, f"not on the floor: {row}")
        check(all(0 < row[f"flux_{c}"] < 1 for c in ("red", "green", "blue")), f"flux: {row}")
        check(row["path_edges"] == 3 and row["path_length"] > 7, f"path: {row}")
        for vector in ("from_x", "from_y", "from_z"), ("emitter_1", "emitter_2", "emitter_3"):
            check(abs(math.hypot(*(row[name] for name in vector)) - 1) < 1e-3, f"no unit vector: {row}")


main()
