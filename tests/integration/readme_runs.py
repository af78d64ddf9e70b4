"""Runs the commands that the READMEs print: readme_runs.py SOURCE_DIR BUILD_DIR [PART_OF_A_README'S_PATH]

Each README has a copy of the folders that its commands name, with small stand-ins for recordings that are not shipped, and
its commands run there in their order. As printed, but for the length of runs: two trials, ten seconds of a log, live input
at twenty times its pace. A command that is neither run nor named in NOT_RUN, with what stands in for it, is a failure.
"""

import contextlib
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

from readme_commands import APPS, NOT_SHIPPED, code_lines, is_synopsis

COMMANDS = APPS | {"bash", "cmake", "cp", "mkdir", "node", "npm", "pf-localization", "python3", "rawlog-edit", "RawLogViewer",
                   "sbatch", "socat", "study_parallel.sh", "sudo", "sweep.sh"}
# What begins so is not run here, and why.
NOT_RUN = {
    "bash apps/quickstart.sh": "builds; a check of .ci/run",
    "bash tests/run.sh": "runs this test",
    "bash apps/package.sh": "builds; tests/portability/packages.sh uses what it makes",
    "sudo apt install": "tests/portability/packages.sh",
    "cp -r /usr/share/mrpt_ext": "tests/portability/packages.sh",
    "bash datasets/make_results.sh FOLDER": "needs all recordings and hours",
    "cmake --install build": "InstalledLibrary.IsFoundAndLocalizes",
    "cmake -S . -B build -DMRPT_EXT_BUILD_PYTHON": "apps/build.sh --tests configures so",
    "cmake --build build --target mrpt_ext_python": "apps/build.sh --tests builds it",
    "PYTHONPATH=build/python python3 libmrpt-ext/python/examples": "the tests of the Python module",
    "RawLogViewer": "opens a window; StockRawLogViewer of tests/plugin",
    "study_parallel.sh": "Study.InPartsIsTheWholeStudy",
    "SSHLOGIN": "needs other machines",
    "sbatch": "needs Slurm",
    "sweep.sh": "Study.InPartsIsTheWholeStudy",
    "socat": "needs two machines",
    "python3 apps/landmark-localization/live_replay.py my_folder | socat": "needs two machines",
    "python3 conic_mirror_room.py": "renders a shipped data set again, minutes",
    "python3 stereo_goal_field.py": "renders a shipped data set again, minutes",
    "python3 tag_hall.py": "renders a shipped data set again, minutes",
    "python3 variations.py": "renders sixty scenes, half an hour",
    "python3 score_variations.py": "needs those sixty scenes",
    "python3 localize_variations.py": "needs those sixty scenes",
    "python3 apps/images2rawlog/tag_dictionary.py": "needs python3-opencv",
    "mkdir bags": "makes test data from packages of npm",
    "npm": "makes test data",
    "NODE_PATH": "makes test data",
    "set [": "output of a command",
}
# What a README takes for granted.
BEFORE = {
    "apps/localization-report/README.md": [
        "landmark-localization ini/landmark-localization/room.ini -o out/room",
        "landmark-localization ini/landmark-localization/half-field.ini -o out/half-field",
        "landmark-localization ini/landmark-localization/quickstart.ini -o out/part_0 --trials 0:1",
        "landmark-localization ini/landmark-localization/quickstart.ini -o out/part_1 --trials 1:2",
    ]
}
# Of a log [s]. Under the sanitizers, which take many times as long: enough for a frame of every sensor.
SHORT = "LANDMARK_SHORT_TESTS" in os.environ
SECONDS = 2 if SHORT else 10
UWB_DEMO = pathlib.Path("/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog")


def write_drive(folder):
    """Three CSV files of a robot that drives a circle and sees bearing and range of two landmarks at a time."""
    folder.mkdir()
    noise = random.Random(7)
    landmarks = [(0, 0), (6, 0.5), (5.5, 5), (0.5, 4), (3, 5.5)]
    odometry, detections = ["t,v,omega_deg_s"], ["t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m"]
    for k in range(201 if SHORT else 601):
        heading = 0.2 + math.radians(12) * 0.1 * k
        radius = 0.4 / math.radians(12)
        x = 3 + radius * (math.sin(heading) - math.sin(0.2))
        y = 1 - radius * (math.cos(heading) - math.cos(0.2))
        odometry.append(f"{0.1 * k:.1f},{0.4 + noise.gauss(0, 0.01):.4f},{12 + noise.gauss(0, 0.5):.3f}")
        for i in (k // 5 % 5, (k // 5 + 2) % 5) if k % 5 == 0 else ():
            dx, dy = landmarks[i][0] - x, landmarks[i][1] - y
            bearing = math.degrees(math.atan2(dy, dx) - heading) + noise.gauss(0, 1)
            detections.append(f"{0.1 * k:.1f},camera,{i + 1},,{(bearing + 180) % 360 - 180:.2f},"
                              f"{math.hypot(dx, dy) + noise.gauss(0, 0.05):.3f},1,0.05")
    rows = ["id,x,y,z,category"] + [f"{i + 1},{x},{y},0,pole" for i, (x, y) in enumerate(landmarks)]
    for name, lines in (("landmarks", rows), ("odometry", odometry), ("detections", detections)):
        (folder / f"{name}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


@contextlib.contextmanager
def workplace(source, build):
    """A folder that looks like the project's to whoever follows a README; results stay out of the sources."""
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        for folder in ("ini", "datasets"):
            shutil.copytree(source / folder, place / folder)
        (place / "apps").symlink_to(source / "apps")
        (place / "build").mkdir()
        for folder in ("bin", "lib"):
            (place / "build" / folder).symlink_to(build / folder)
        samples = source / "tests" / "data"
        for stand_in, sample in (("plaza", "plaza"), ("labyrinth_uwb", "labyrinth"), ("cuhksz_uwb_planar", "cuhksz"),
                                 ("MRCLAM_Dataset6", "mrclam")):
            (place / stand_in).symlink_to(samples / "importers" / sample)
        (place / "my_bag").symlink_to(samples / "rosbag2" / "two_files")
        shutil.copy(samples / "rosbag2" / "landmarks.csv", place)
        write_drive(place / "my_folder")
        for kind in (".rawlog", "_map.csv", "_ground_truth.tum"):
            shutil.copy(source / "datasets" / ("room" + kind), place / ("my" + kind))
        (place / "my.ini").write_text("[LocalizationExperiment]\nparticles_count = 500\n", encoding="utf-8")
        yield place


def commands_of(readme):
    """(number, command) of the code blocks, in order; what prepares a command, as `robot=1`, is one as well."""
    lines = list(code_lines(readme))
    while lines:
        number, text = lines.pop(0)
        while text.endswith("|"):
            text += " " + lines.pop(0)[1]
        text = re.sub(r"^[A-Z] {2,}", "", text).split("  #")[0].strip()
        first = next(iter(re.sub(r"^(\w+=\S* +)+", "", text).split()), "")
        if re.fullmatch(r"\w+=\w+", text) or pathlib.PurePath(first).name in COMMANDS:
            yield number, text


def shortened(command):
    command = re.sub(r"--repeat \d+", "--repeat 2", command)
    command = re.sub(r"(live_replay\.py my_folder)(?= \|)", r"\1 20", command)
    if "landmark-localization" in command and "--live" not in command and (SHORT or "--repeat" not in command):
        command += f" --duration {SECONDS}" if "--diagnose" not in command else ""
    return command


def needs_what_is_absent(command):
    for program in ("rawlog-edit", "pf-localization"):
        if program in command and not shutil.which(program):
            return True
    if SHORT and "LD_PRELOAD" in command:  # the sanitizers' own library would have to come first: StockPfLocalization
        return True
    return "mrpt-uwb-demo" in command and not UWB_DEMO.exists()


def is_run(command):
    """Neither left to another test nor a synopsis."""
    if any(command.startswith(beginning) for beginning in NOT_RUN):
        return False
    words = [word for word in command.split() if word != "|"]
    return not is_synopsis(words) and not any(re.match(r"[A-Z]{3,}\.\w+$", word) for word in words)


def run(readme, source, build):
    """What went wrong, and how many commands were run."""
    name = str(readme.relative_to(source))
    commands = [(0, command) for command in BEFORE.get(name, [])]
    commands += [(number, command) for number, command in commands_of(readme) if is_run(command)]
    environment = {**os.environ, "PATH": f"{build / 'bin'}:{os.environ['PATH']}"}
    wrong, done, assigned = [], 0, ""
    with workplace(source, build) as place:
        for number, command in commands:
            if re.fullmatch(r"\w+=\w+", command):
                assigned = command + "; "
                continue
            if needs_what_is_absent(command):
                continue
            result = subprocess.run(["bash", "-c", "set -o pipefail; " + assigned + shortened(command)], cwd=place,
                                    env=environment, capture_output=True, text=True, timeout=600)
            done += 1
            # A few rows of a recording, or ten seconds, need not be enough to find the robot. MRPT's tool also returns 0
            # when it found no file.
            failed = result.returncode not in (0, 3)
            if failed or ("pf-localization" in command and not list(place.glob("pf-localization*/*"))):
                last = (result.stderr.strip() or result.stdout.strip()).splitlines()[-1:]
                wrong.append(f"{name}:{number}: {command}: exit code {result.returncode}: {last}")
    return wrong, done


def main():
    source, build = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    part = sys.argv[3] if len(sys.argv) > 3 else ""
    wrong, done = [], 0
    for folder, folders, files in os.walk(source):
        folders[:] = sorted(f for f in folders if not f.startswith((".", "build")) and f not in NOT_SHIPPED)
        readme = pathlib.Path(folder) / "README.md"
        if "README.md" not in files or part not in str(readme.relative_to(source)):
            continue
        failed, count = run(readme, source, build)
        wrong, done = wrong + failed, done + count
        if count:
            print(f"{readme.relative_to(source)}: {count} commands run", flush=True)
    print("\n".join(wrong) or f"{done} commands run")
    sys.exit(1 if wrong or not done else 0)


main()
