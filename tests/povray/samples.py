#!/usr/bin/env python3
"""Renders POV-Ray's sample scenes with POV-Ray and with cognac and says how far cognac is.

Installs nothing: takes the samples from where Debian's povray-examples puts them, unpacks them into
a scratch folder, renders each at 160x120 without antialiasing and with the same number of threads
by both programs, and compares by SSIM after halving the size. POV-Ray's renders are kept in a
cache, by content. Prints how many scenes are read, rendered and matched, the ratio of processor
time over the matching ones, and which errors stop the rest, by how many scenes.
"""

import argparse
import collections
import concurrent.futures
import fnmatch
import gzip
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SIZE = ["+W160", "+H120", "-A"]
MATCH = 0.95
# Scenes whose own .ini stands for them: without a frame number they stop with an error.
FRAMES = "portfolio"
# An error, the line it is about and the caret under it.
SCENE_ERROR = re.compile(r"^.*?:\d+:\d+: error: (.*)$(?:\n *\d+ \| (.*)\n *\| ( *)\^)?", re.M)
ANY_ERROR = re.compile(r"^(?:.*?: )?error: (.*)$", re.M)


def unpack(examples, target):
    """Copies the samples, gunzipping those that Debian has compressed."""
    for source in sorted(examples.rglob("*")):
        place = target / source.relative_to(examples)
        if source.is_dir():
            place.mkdir(parents=True, exist_ok=True)
        elif source.suffix == ".gz":
            place.parent.mkdir(parents=True, exist_ok=True)
            place.with_suffix("").write_bytes(gzip.decompress(source.read_bytes()))
        elif source.suffix not in (".jpg", ".htm", ".html") or "portfolio" not in source.parts:
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, place)


def scene_words(scene):
    """What stands on the command line for a scene, run from its own folder."""
    ini = scene.with_suffix(".ini")
    if scene.parent.name == FRAMES and ini.exists():
        return [ini.name, "+SF1", "+EF1"]
    return ["+I" + scene.name]


def run(command, folder, limit):
    """Runs one program; its status (or "timeout"), messages, processor and elapsed seconds."""
    start = time.monotonic()
    with tempfile.TemporaryFile() as messages:
        process = subprocess.Popen(
            command,
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=messages,
            start_new_session=True,
        )
        timer = threading.Timer(limit, lambda: os.killpg(process.pid, signal.SIGKILL))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        late = not timer.is_alive()
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        messages.seek(0)
        text = messages.read(1 << 20).decode("utf-8", "replace")
    return {
        "status": "timeout" if late else process.returncode,
        "messages": text,
        "cpu": usage.ru_utime + usage.ru_stime,
        "wall": time.monotonic() - start,
    }


def picture_of(folder):
    """The one picture a run left, whatever name an animation gave it."""
    found = sorted(pathlib.Path(folder).glob("*.png"))
    return found[0] if found else None


class Yardstick:
    def __init__(self, options):
        self.options = options
        self.work = pathlib.Path(tempfile.mkdtemp(prefix="cognac-samples-"))
        self.samples = self.work / "samples"
        unpack(options.examples, self.samples)
        options.cache.mkdir(parents=True, exist_ok=True)
        self.local = threading.local()
        self.folders = iter(range(1 << 30))

    def folder_of(self, scene):
        """The scene's folder in this worker's own copy of links: scenes write files beside
        themselves.
        """
        if not hasattr(self.local, "tree"):
            self.local.tree = self.work / f"worker{next(self.folders)}"
            shutil.copytree(self.samples, self.local.tree, copy_function=os.symlink)
        return self.local.tree / scene.relative_to(self.samples).parent

    def reference(self, scene):
        """POV-Ray's render: from the cache, or made now."""
        words = scene_words(scene) + SIZE + [f"+WT{self.options.threads}"]
        content = hashlib.sha256("\0".join(words).encode())
        for part in (scene, *sorted(scene.parent.glob("*.inc"))):
            content.update(part.read_bytes())
        picture = self.options.cache / (content.hexdigest()[:24] + ".png")
        record = picture.with_suffix(".json")
        if record.exists():
            return json.loads(record.read_text()), picture
        result, left = self.render([self.options.povray, "-D", "-V"], scene, words)
        if left:
            shutil.copyfile(left, picture)
        del result["messages"]
        record.write_text(json.dumps(result))
        return result, picture

    def render(self, program, scene, words):
        out = pathlib.Path(tempfile.mkdtemp(dir=self.work))
        name = "frame.png" if words[0].endswith(".ini") else "picture.png"
        result = run(
            program + words + ["+FN8", f"+O{out}/{name}"],
            self.folder_of(scene),
            self.options.timeout,
        )
        return result, picture_of(out)

    def similarity(self, left, picture):
        answer = subprocess.run(
            [self.options.compare, "--halve", "--json", str(left), str(picture)],
            capture_output=True,
            text=True,
        )
        return json.loads(answer.stdout)["SSIM"] if answer.returncode == 0 else 0.0

    def judge(self, scene):
        name = str(scene.relative_to(self.samples).with_suffix(""))
        pov, picture = self.reference(scene)
        row = {"scene": name, "povray": pov, "renderable": pov["status"] == 0}
        if not row["renderable"] or self.options.prepare:
            return row
        words = scene_words(scene) + SIZE + [f"+WT{self.options.threads}"]
        ours, left = self.render([self.options.cognac], scene, words)
        row["reads"] = (
            ours["status"] == 0
            or (ours["status"] == "timeout" or not ANY_ERROR.search(ours["messages"]))
            and ours["status"] != 1
        )
        row["renders"] = ours["status"] == 0 and left is not None
        row["ssim"] = self.similarity(left, picture) if row["renders"] else None
        row["cognac"] = {k: ours[k] for k in ("status", "cpu", "wall")}
        row["errors"] = self.errors(ours)
        if self.options.keep and left:
            kept = self.options.keep / (name.replace("/", "_") + ".png")
            shutil.copyfile(left, kept)
            shutil.copyfile(picture, kept.with_suffix(".povray.png"))
        if left:
            shutil.rmtree(left.parent)
        return row

    @staticmethod
    def errors(result):
        found = [words_of(*error) for error in SCENE_ERROR.findall(result["messages"])]
        found = found or ANY_ERROR.findall(result["messages"])
        if not found and result["status"] != 0:
            found = [
                (
                    "no end in time"
                    if result["status"] == "timeout"
                    else f"ended with status {result['status']}"
                )
            ]
        return list(dict.fromkeys(found))


def words_of(message, line, indent):
    """A message with the word of the scene that the caret stands under."""
    word = re.match(r"[#\w]+|.?", line.expandtabs(8)[len(indent.expandtabs(8)) :]).group()
    return f"{message} [{word}]" if word and word not in message else message


def geometric_mean(values):
    values = [v for v in values if v > 0]
    return math.exp(sum(map(math.log, values)) / len(values)) if values else float("nan")


def print_row(row):
    if not row["renderable"]:
        print(f"{row['scene']:44} POV-Ray itself stops ({row['povray']['status']})")
        return
    ratio = row["cognac"]["cpu"] / max(row["povray"]["cpu"], 1e-3)
    if row["renders"]:
        verdict = "matches" if row["matches"] else "differs"
        print(
            f"{row['scene']:44} {verdict} {row['ssim']:7.4f}  "
            f"{row['cognac']['cpu']:7.2f} s  x{ratio:.2f}"
        )
    else:
        print(f"{row['scene']:44} stops   {row['errors'][0][:80] if row['errors'] else ''}")


def summary(rows):
    rows = [row for row in rows if row["renderable"]]
    matches = [row for row in rows if row["matches"]]
    ratio = {
        kind: geometric_mean([r["cognac"][kind] / max(r["povray"][kind], 1e-3) for r in matches])
        for kind in ("cpu", "wall")
    }
    return {
        "scenes": len(rows),
        "reads": sum(r["reads"] for r in rows),
        "renders": sum(r["renders"] for r in rows),
        "matches": len(matches),
        "cpu_ratio": ratio["cpu"],
        "wall_ratio": ratio["wall"],
    }


def print_stoppers(rows, shown):
    first, any_place = collections.Counter(), collections.Counter()
    for row in rows:
        if row["renderable"] and not row["renders"]:
            first.update(row["errors"][:1])
            any_place.update(row["errors"])
    if not any_place:
        return
    print("\nwhat stops the rest (scenes with it first, with it anywhere):")
    for words, count in any_place.most_common(shown):
        print(f"  {first[words]:4} {count:4}  {words[:110]}")


def arguments():
    here = pathlib.Path.cwd()
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cognac", default=str(here / "cognac"))
    parser.add_argument("--compare", default=str(here / "cognac-compare"))
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--examples", type=pathlib.Path, default=EXAMPLES)
    parser.add_argument(
        "--cache",
        type=pathlib.Path,
        help="where POV-Ray's renders are kept",
        default=pathlib.Path(os.environ.get("XDG_CACHE_HOME", "~/.cache")).expanduser()
        / "cognac"
        / "povray",
    )
    parser.add_argument("--threads", type=int, default=1, help="of each renderer")
    parser.add_argument("--jobs", type=int, default=1, help="scenes at once")
    parser.add_argument(
        "--timeout", type=float, default=60, help="seconds a program may take for a scene"
    )
    parser.add_argument(
        "--only",
        action="append",
        metavar="PATTERN",
        help="scenes by name, as objects/*; repeatable",
    )
    parser.add_argument(
        "--list", type=pathlib.Path, metavar="FILE", help="only the scenes that the file names"
    )
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="every scene's result")
    parser.add_argument(
        "--keep", type=pathlib.Path, metavar="DIR", help="keep both pictures of each scene"
    )
    parser.add_argument(
        "--match", type=float, default=MATCH, help="least SSIM of pictures that match"
    )
    parser.add_argument("--prepare", action="store_true", help="only fill the cache")
    parser.add_argument(
        "--expect", type=int, metavar="N", help="fail when fewer than N scenes match"
    )
    return parser.parse_args()


def chosen(options, samples):
    names = options.only
    if options.list:
        lines = (line.split("#")[0].strip() for line in options.list.read_text().splitlines())
        names = (names or []) + [line for line in lines if line]
    for scene in sorted(samples.rglob("*.pov")):
        name = str(scene.relative_to(samples).with_suffix(""))
        if names is None or any(fnmatch.fnmatch(name, pattern) for pattern in names):
            yield scene


def measure(options, yardstick):
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(yardstick.judge, chosen(options, yardstick.samples)):
            row["matches"] = (row.get("ssim") or 0) >= options.match
            rows.append(row)
            if not options.prepare:
                print_row(row)
                sys.stdout.flush()
    return rows


def main():
    options = arguments()
    options.cognac, options.compare = os.path.abspath(options.cognac), os.path.abspath(
        options.compare
    )
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    if not options.examples.is_dir() or not shutil.which(options.povray):
        print("POV-Ray or its samples are not here: nothing compared")
        return 77
    yardstick = Yardstick(options)
    try:
        rows = measure(options, yardstick)
    finally:
        shutil.rmtree(yardstick.work, ignore_errors=True)
    if options.prepare:
        return 0
    total = summary(rows)
    if options.json:
        options.json.write_text(json.dumps({"summary": total, "scenes": rows}, indent=1))
    print_stoppers(rows, 40)
    print(
        "\nscenes {scenes}  reads {reads}  renders {renders}  matches {matches}  "
        "time x{cpu_ratio:.2f} of POV-Ray's (processor), x{wall_ratio:.2f} (elapsed)".format(
            **total
        )
    )
    return 1 if options.expect is not None and total["matches"] < options.expect else 0


if __name__ == "__main__":
    sys.exit(main())
