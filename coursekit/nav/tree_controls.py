"""The control and decorator nodes of behaviour trees, with BehaviorTree.CPP's and nav2's names."""

from __future__ import annotations

import math

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeNode


class _Control(TreeNode):
    arity = (1, math.inf)
    at = 0

    def stop(self) -> None:
        self.at = 0

    def _end(self, status: str) -> str:
        self.at = 0
        for child in self.children:
            child.halt()
        return status


class Sequence(_Control):
    """Ticks one child after the other; ends with the first failure.

    >>> good, bad = AlwaysSuccess("a", {}, [], {}), AlwaysFailure("b", {}, [], {})
    >>> Sequence("both", {}, [good, bad], {}).tick() == FAILURE, Fallback("either", {}, [bad, good], {}).tick() == SUCCESS
    (True, True)
    """

    ends_with = FAILURE

    def step(self) -> str:
        while self.at < len(self.children):
            status = self.children[self.at].tick()
            if status == RUNNING:
                return status
            if status == self.ends_with:
                return self._end(status)
            self.at += 1
        return self._end(SUCCESS if self.ends_with == FAILURE else FAILURE)


class Fallback(Sequence):
    """Ticks one child after the other; ends with the first success."""

    ends_with = SUCCESS


class SequenceStar(Sequence):
    """A Sequence that resumes at the child that failed."""

    def _end(self, status: str) -> str:
        at = self.at if status == FAILURE else 0
        super()._end(status)
        self.at = at
        return status


class ReactiveSequence(_Control):
    """Ticks all children from the first one at every tick; while one is running, the others begin anew each time."""

    ends_with = FAILURE

    def step(self) -> str:
        for child in self.children:
            status = child.tick()
            if status == RUNNING:
                for other in self.children:
                    if other is not child:
                        other.halt()
                return status
            if status == self.ends_with:
                return self._end(status)
        return self._end(SUCCESS if self.ends_with == FAILURE else FAILURE)


class ReactiveFallback(ReactiveSequence):
    """Ticks all children from the first one at every tick, until one succeeds."""

    ends_with = SUCCESS


class PipelineSequence(_Control):
    """A sequence that also ticks the children before the running one again."""

    def step(self) -> str:
        for k, child in enumerate(self.children):
            status = child.tick()
            if status == FAILURE:
                return self._end(status)
            if status == RUNNING and k >= self.at:
                self.at = k
                return status
        return self._end(SUCCESS)


class RoundRobin(_Control):
    """Ticks the next child each time, until one succeeds; fails when all have failed.

    >>> class Say(TreeNode):
    ...     def step(self):
    ...         print(self.name)
    ...         return SUCCESS
    >>> turns = RoundRobin("turns", {}, [Say("spin", {}, [], {}), Say("wait", {}, [], {})], {})
    >>> for _ in range(3):
    ...     status = turns.tick()
    spin
    wait
    spin
    """

    def step(self) -> str:
        for _ in self.children:
            status = self.children[self.at].tick()
            if status == RUNNING:
                return status
            at, self.at = self.at, (self.at + 1) % len(self.children)
            self.children[at].halt()
            if status == SUCCESS:
                return status
        return self._end(FAILURE)


class RecoveryNode(_Control):
    """Ticks the first child; on failure the second, then the first again, `number_of_retries` times.

    >>> class Say(TreeNode):
    ...     def step(self):
    ...         print(self.name)
    ...         return SUCCESS if self.name == "clear the map" else FAILURE
    >>> children = [Say("plan", {}, [], {}), Say("clear the map", {}, [], {})]
    >>> RecoveryNode("retry", {"number_of_retries": "1"}, children, {}).tick() == FAILURE
    plan
    clear the map
    plan
    True
    """

    arity = (2, 2)
    tries = 0

    def step(self) -> str:
        while True:
            status = self.children[self.at].tick()
            if status == RUNNING:
                return status
            self.children[self.at].halt()
            if self.at == 0:
                if status == SUCCESS or self.tries >= self.number("number_of_retries", 1):
                    self.tries = 0
                    return self._end(status)
                self.at = 1
            elif status == FAILURE:
                self.tries = 0
                return self._end(status)
            else:
                self.tries, self.at = self.tries + 1, 0

    def stop(self) -> None:
        self.tries = self.at = 0


class _Decorator(TreeNode):
    arity = (1, 1)

    @property
    def child(self) -> TreeNode:
        return self.children[0]


class Inverter(_Decorator):
    """Inverts the child's result.

    >>> Inverter("not", {}, [AlwaysFailure("a", {}, [], {})], {}).tick() == SUCCESS
    True
    """

    def step(self) -> str:
        return {SUCCESS: FAILURE, FAILURE: SUCCESS}.get(self.child.tick(), RUNNING)


class ForceSuccess(_Decorator):
    """Turns every result into success."""

    def step(self) -> str:
        return RUNNING if self.child.tick() == RUNNING else SUCCESS


class ForceFailure(_Decorator):
    """Turns every result into failure."""

    def step(self) -> str:
        return RUNNING if self.child.tick() == RUNNING else FAILURE


class KeepRunningUntilFailure(_Decorator):
    """Repeats the child until it fails."""

    def step(self) -> str:
        return FAILURE if self.child.tick() == FAILURE else RUNNING


class Repeat(_Decorator):
    """Repeats the child `num_cycles` times while it succeeds; -1 means forever.

    >>> thrice = Repeat("thrice", {"num_cycles": "3"}, [AlwaysSuccess("a", {}, [], {})], {})
    >>> [thrice.tick() == RUNNING for _ in range(3)]
    [True, True, False]
    """

    counted, port = SUCCESS, "num_cycles"
    count = 0

    def step(self) -> str:
        status = self.child.tick()
        if status == RUNNING:
            return status
        self.count += 1
        most = self.number(self.port, 1)
        if status == self.counted and (most < 0 or self.count < most):
            return RUNNING
        self.count = 0
        return status

    def stop(self) -> None:
        self.count = 0


class RetryUntilSuccessful(Repeat):
    """Repeats the child while it fails, at most `num_attempts` times."""

    counted, port = FAILURE, "num_attempts"


class SingleTrigger(_Decorator):
    """Runs the child once; fails from then on, until it is halted.

    >>> once = SingleTrigger("once", {}, [AlwaysSuccess("a", {}, [], {})], {})
    >>> once.tick() == SUCCESS, once.tick() == FAILURE
    (True, True)
    """

    done = False

    def step(self) -> str:
        if self.status == IDLE:
            self.done = False
        if self.done:
            return FAILURE
        status = self.child.tick()
        self.done = status != RUNNING
        return status


class AlwaysSuccess(TreeNode):
    """Always succeeds."""

    def step(self) -> str:
        return SUCCESS


class AlwaysFailure(TreeNode):
    """Always fails."""

    def step(self) -> str:
        return FAILURE


CONTROLS: dict[str, type[TreeNode]] = {
    kind.__name__: kind
    for kind in (
        Sequence, Fallback, SequenceStar, ReactiveSequence, ReactiveFallback, PipelineSequence, RoundRobin, RecoveryNode,
        Inverter, ForceSuccess, ForceFailure, KeepRunningUntilFailure, Repeat, RetryUntilSuccessful, SingleTrigger,
        AlwaysSuccess, AlwaysFailure,
    )
}  # fmt: skip
"""The nodes by their XML names."""
CONTROLS["RetryUntilSuccesful"] = RetryUntilSuccessful  # as BehaviorTree.CPP spelled it first
