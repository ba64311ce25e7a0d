"""A program pickles instances of its own classes, as it may on a robot."""

import pickle

from coursekit.processes.current_process import current_process
from coursekit.processes.private_modules import use_private_modules
from coursekit.processes.session import Session

from .programs import run

POSE = """
class Pose:
    def __init__(self, x):
        self.x = x

    def turned(self):
        return -self.x
"""


def test_a_program_pickles_its_own_classes_and_functions(tmp_path):
    (tmp_path / "poses.py").write_text(POSE)

    def main():
        use_private_modules(current_process(), [str(tmp_path)])
        from poses import Pose

        there = tmp_path / "pose.pickle"
        with open(there, "wb") as out:
            pickle.dump([Pose(2.5), Pose.turned], out)
        with open(there, "rb") as file:
            pose, turned = pickle.load(file)
        assert type(pose) is Pose and turned(pose) == -2.5
        print(pickle.loads(pickle.dumps(pose)).x)

    with Session(virtual=True).use() as session:
        code, process = run(session, main)
    assert (code, process.output.strip()) == (0, "2.5"), process.output


def test_two_programs_get_each_its_own_class(tmp_path):
    def main(folder):
        use_private_modules(current_process(), [str(folder)])
        from poses import KIND, Pose

        print(KIND, type(pickle.loads(pickle.dumps(Pose()))) is Pose)

    with Session(virtual=True).use() as session:
        for kind in ("one", "two"):
            (tmp_path / kind).mkdir()
            (tmp_path / kind / "poses.py").write_text(f"KIND = {kind!r}\nclass Pose: pass\n")
            code, process = run(session, lambda kind=kind: main(tmp_path / kind))
            assert (code, process.output.strip()) == (0, f"{kind} True"), process.output


SCRIPT = """import pickle


class Pose:
    x = 2.5


print(type(pickle.loads(pickle.dumps(Pose()))) is Pose)
"""


def test_a_script_pickles_what_it_has_defined_itself(tmp_path):
    (tmp_path / "script.py").write_text(SCRIPT)
    with Session(virtual=True).use() as session:
        process = session.start_executable(tmp_path / "script.py")
        assert process.wait(30) == 0 and process.output == "True\n", process.output
