"""BehaviorTree.CPP's nodes that choose between children, tick them together, wait for them, or write the blackboard."""

from __future__ import annotations

import math

from coursekit.nav.behavior_tree import FAILURE, RUNNING, SUCCESS, TreeNode
from coursekit.nav.tree_blackboard import SECONDS


class IfThenElse(TreeNode):
    """Ticks the second child if the first succeeds, else the third; without a third it fails."""

    arity = (2, 3)
    at = 0

    def step(self) -> str:
        """Decide, unless a branch is running; then tick the branch."""
        if self.at == 0:
            status = self.children[0].tick()
            if status == RUNNING:
                return status
            self.at = 1 if status == SUCCESS else 2
        status = self.children[self.at].tick() if self.at < len(self.children) else FAILURE
        if status != RUNNING:
            self.stop()
        return status

    def stop(self) -> None:
        """Decide anew at the next tick."""
        self.at = 0
        for child in self.children:
            child.halt()


class Choice(TreeNode):
    """Ticks one child, chosen anew at every tick, and halts the one before."""

    chosen: TreeNode | None = None

    def choose(self) -> TreeNode | None:
        """The child to tick; None while that is not known."""
        raise NotImplementedError(self.name)

    def step(self) -> str:
        """Choose, halt the other, and tick."""
        child = self.choose()
        if child is None:
            return RUNNING
        if self.chosen not in (None, child):
            self.chosen.halt()  # type: ignore[union-attr]
        self.chosen = child
        return child.tick()


class WhileDoElse(Choice):
    """Ticks the second child while the first succeeds, else the third."""

    arity = (3, 3)

    def choose(self) -> TreeNode | None:
        """By what the first child returns."""
        status = self.children[0].tick()
        return None if status == RUNNING else self.children[1 if status == SUCCESS else 2]


class Switch(Choice):
    """Ticks the child whose `case_N` is the `variable`; the last child if there is none."""

    def choose(self) -> TreeNode:
        """By the variable."""
        cases = [str(self.get(f"case_{k + 1}", "")) for k in range(len(self.children) - 1)]
        value = str(self.get("variable", ""))
        return self.children[cases.index(value) if value in cases else -1]


class Parallel(TreeNode):
    """Ticks all children; `success_threshold` successes (all) make it succeed, `failure_threshold` failures (one) fail.

    It also fails when so many successes are out of reach.
    """

    arity = (1, math.inf)

    def prepare(self) -> None:
        """No child has ended."""
        self._ended: dict[TreeNode, str] = {}

    def step(self) -> str:
        """Tick the children that have not ended, and count."""
        for child in self.children:
            status = self._ended.get(child) or child.tick()
            if status != RUNNING:
                self._ended[child] = status
        states = list(self._ended.values())
        wanted, most = (self._threshold(port, default) for port, default in (("success", -1), ("failure", 1)))
        if states.count(SUCCESS) >= wanted:
            return self._end(SUCCESS)
        failed = states.count(FAILURE)
        return self._end(FAILURE) if failed >= most or len(self.children) - failed < wanted else RUNNING

    def _threshold(self, port: str, default: int) -> int:
        number = int(self.number(f"{port}_threshold", default))
        return number if number >= 0 else len(self.children) + 1 + number

    def _end(self, status: str) -> str:
        self.stop()
        for child in self.children:
            child.halt()
        return status

    def stop(self) -> None:
        """Forget who has ended."""
        self._ended.clear()


class _Timed(TreeNode):
    arity = (1, 1)
    begun: float | None = None

    def passed(self, port: str) -> bool:
        """Whether so many milliseconds have passed since the first tick."""
        now: float = self.board[SECONDS]()
        if self.begun is None:
            self.begun = now
        return (now - self.begun) * 1e3 >= self.number(port, 0.0)

    def stop(self) -> None:
        """Begin anew at the next tick."""
        self.begun = None

    def ended(self, status: str) -> str:
        """Return the status; begin anew unless it is running."""
        if status != RUNNING:
            self.stop()
        return status


class Timeout(_Timed):
    """Fails, and halts its child, after `msec` milliseconds."""

    def step(self) -> str:
        """Tick the child unless its time is over."""
        late = self.passed("msec")
        status = self.children[0].tick() if not late or self.children[0].status != RUNNING else RUNNING
        if late and status == RUNNING:
            self.children[0].halt()
            status = FAILURE
        return self.ended(status)


class Delay(_Timed):
    """Ticks its child after `delay_msec` milliseconds."""

    def step(self) -> str:
        """Wait, then tick."""
        return self.ended(self.children[0].tick()) if self.passed("delay_msec") else RUNNING


class SetBlackboard(TreeNode):
    """Writes `value` to the blackboard, under the name `output_key`."""

    def step(self) -> str:
        """Write; a key may stand in braces or without."""
        self.board[self.ports.get("output_key", "").strip("{}")] = self.get("value")
        return SUCCESS


def _switch(cases: int) -> type[Switch]:
    return type(f"Switch{cases}", (Switch,), {"arity": (cases + 1, cases + 1)})


BRANCHES: dict[str, type[TreeNode]] = {
    **{kind.__name__: kind for kind in (IfThenElse, WhileDoElse, Parallel, Timeout, Delay, SetBlackboard)},
    **{f"Switch{cases}": _switch(cases) for cases in range(2, 7)},
}
"""The nodes by their XML names."""
