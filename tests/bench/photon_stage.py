"""The photon stage beside POV-Ray's: processor time per stored photon, on the same scenes and
counts, in one run.

Both stages are measured as what a program takes more with photons than without, all of it: aiming,
tracing, sorting into the search tree. One thread; medians of `--runs` runs, the programs taking
turns.
"""

import argparse
import json
import math
import os
import re
import shutil
import statistics
import subprocess
import tempfile

HEAD = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level %d %s }
camera { orthographic location <0, 9, 0> direction <0, -1, 0> right x*8 up z*8 }
"""
GLASS = """pigment { rgbt <0.9, 1, 0.95, 0.95> }
finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy }
interior { ior 1.5 fade_distance 4 fade_power 1001 fade_color <0.5, 0.8, 0.6> }
%s"""
TARGET = "photons { target refraction on reflection on collect off }"
LAMP = """light_source { <-12, 16, 4> rgb 1 }
plane { y, 0 pigment { checker rgb 1, rgb <0.8, 0.7, 0.5> } }
"""
CUP = """lathe { cubic_spline 13, <-1, 0.01>, <0, 0.01>, <1, 0.01>, <1.3, 0.1>, <1.1, 0.6>,
<1.5, 2>, <1.4, 3>, <1.35, 3.05>, <1.3, 3>, <1.4, 2>, <1, 0.7>, <0, 0.5>, <-1, 0.7> """


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def knot_point(t):
    r = 1.1 + 0.4 * math.cos(3 * t)
    return [r * math.cos(2 * t), 1.4 + 0.5 * math.sin(3 * t), r * math.sin(2 * t)]


def knot(along=700, around=60):
    """A trefoil's tube of 2 * along * around triangles, with normals, as the inside of a mesh2."""
    points, normals, faces = [], [], []
    for i in range(along):
        t = 2 * math.pi * i / along
        middle, ahead = knot_point(t), unit(subtract(knot_point(t + 1e-4), knot_point(t - 1e-4)))
        side = unit(cross(ahead, [0, 1, 0]))
        up = cross(side, ahead)
        for j in range(around):
            w = 2 * math.pi * j / around
            n = [math.cos(w) * a + math.sin(w) * b for a, b in zip(side, up)]
            normals.append(n)
            points.append([m + 0.22 * x for m, x in zip(middle, n)])
            here, left = i * around + j, i * around + (j + 1) % around
            ahead_here, ahead_left = [(k + around) % (along * around) for k in (here, left)]
            faces += [(here, left, ahead_here), (left, ahead_left, ahead_here)]

    def block(word, rows, form):
        return "%s { %d,\n%s }\n" % (word, len(rows), ",\n".join(form % tuple(row) for row in rows))

    vector = "<%.6f,%.6f,%.6f>"
    return (
        block("vertex_vectors", points, vector)
        + block("normal_vectors", normals, vector)
        + block("face_indices", faces, "<%d,%d,%d>")
        + "inside_vector y\n"
    )


def scenes():
    """Name, text with photons, text without."""

    def both(name, level, photons, body):
        return name, HEAD % (level, photons) + body(TARGET), HEAD % (level, "") + body("")

    count = "photons { count 300000 autostop 0 }"
    yield both(
        "slab",
        5,
        "photons { spacing 0.005 }",
        lambda target: "light_source { <0, 1000, 0> rgb 1 parallel point_at 0 }\n"
        "plane { y, 0 pigment { rgb 1 } }\n"
        "box { <-2, 2, -2>, <2, 2.1, 2> pigment { rgbt 1 } interior { ior 1.5 } %s }\n"
        % target.replace("reflection on ", ""),
    )
    yield both(
        "ball", 8, count, lambda target: LAMP + "sphere { <0, 1.2, 0>, 1 " + GLASS % target + "}\n"
    )
    yield both("glass", 12, count, lambda target: LAMP + CUP + GLASS % target + "}\n")
    mesh = knot()
    yield both("mesh", 12, count, lambda target: LAMP + "mesh2 { " + mesh + GLASS % target + "}\n")


def run(command, folder):
    """Processor seconds of a program, and what it wrote."""
    with open(os.path.join(folder, "log"), "w+", encoding="utf-8", errors="replace") as log:
        process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read()
    if process.returncode:
        raise SystemExit("%s failed:\n%s" % (command[0], text[-2000:]))
    return usage.ru_utime + usage.ru_stime, text


def run_cognac(program, folder, scene, threads):
    statistics_file = os.path.join(folder, "statistics.json")
    seconds, _ = run(
        [
            program,
            "+I" + scene,
            "+Oours.png",
            "+W4",
            "+H4",
            "-A",
            "-D",
            "--threads",
            str(threads),
            "--stats",
            statistics_file,
        ],
        folder,
    )
    with open(statistics_file, encoding="utf-8") as file:
        return seconds, json.load(file).get("photons", {})


def run_povray(folder, scene):
    seconds, text = run(
        ["povray", "+I" + scene, "+Otheirs.png", "+W4", "+H4", "-A", "-D", "+WT1"], folder
    )
    stored = re.search(r"Surface photons stored:\s*(\d+)", text)
    return seconds, int(stored.group(1)) if stored else 0


def measure(program, folder, runs):
    """Rows of microseconds per stored photon and of paths per second, each a list of runs."""
    own, theirs, one, two, count = [], [], [], [], {}
    for _ in range(runs):
        with_photons, photons = run_cognac(program, folder, "photons.pov", 1)
        own.append(
            1e6
            * (with_photons - run_cognac(program, folder, "plain.pov", 1)[0])
            / photons["stored"]
        )
        one.append(photons["paths"] / photons["processor"])
        pair = run_cognac(program, folder, "photons.pov", 2)[1]
        two.append((pair["paths"] / pair["seconds"], photons["seconds"] / pair["seconds"]))
        count["ours"] = photons["stored"]
        if shutil.which("povray"):
            seconds, count["theirs"] = run_povray(folder, "photons.pov")
            theirs.append(1e6 * (seconds - run_povray(folder, "plain.pov")[0]) / count["theirs"])
    return own, theirs, one, two, count


def print_rays(program, runs):
    """The mesh scene's rays beside the same ones through bare rtcIntersect1."""
    text = next(photons for name, photons, _ in scenes() if name == "mesh")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.pov")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        print(
            "mesh:", run([os.path.abspath(program), path, str(runs)], folder)[1].strip(), flush=True
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cognac", required=True)
    parser.add_argument(
        "--rays", help="the program that asks rtcIntersect1 for the paths' rays again"
    )
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    print(
        "processor time of the photon stage per stored photon, aiming, tracing and sorting; "
        "medians of %d runs"
        % options.runs
    )
    print(
        "%-6s %9s %9s %9s %9s %6s %6s %12s %12s %8s"
        % (
            "scene",
            "stored",
            "POV-Ray's",
            "us",
            "POV-Ray's",
            "ratio",
            "asked",
            "paths/s",
            "2 threads",
            "speed-up",
        )
    )
    for name, photons, plain in scenes():
        with tempfile.TemporaryDirectory() as folder:
            for file_name, text in (("photons.pov", photons), ("plain.pov", plain)):
                with open(os.path.join(folder, file_name), "w", encoding="utf-8") as file:
                    file.write(text)
            own, theirs, one, two, count = measure(
                os.path.abspath(options.cognac), folder, options.runs
            )
        mine, other = statistics.median(own), statistics.median(theirs) if theirs else math.nan
        print(
            "%-6s %9d %9d %9.2f %9.2f %6.2f %6s %12.0f %12.0f %8.2f"
            % (
                name,
                count["ours"],
                count.get("theirs", 0),
                mine,
                other,
                other / mine,
                ">= 3",
                statistics.median(one),
                statistics.median(row[0] for row in two),
                statistics.median(row[1] for row in two),
            ),
            flush=True,
        )
    if options.rays:
        print_rays(options.rays, options.runs)


if __name__ == "__main__":
    main()
