"""The graph comes back to the truth, whatever the drift, and leaves false loops aside."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Array, Pose2D, between, compose
from coursekit.slam.graph import PoseGraph
from coursekit.slam.solver import Problem, chordal, jacobians, residuals

CHAIN = np.diag([1 / 0.03**2, 1 / 0.03**2, 1 / 0.005**2])
LOOP = np.diag([1 / 0.03**2, 1 / 0.03**2, 1 / 0.01**2])


def rounds(count: int, turns: float) -> Array:
    """(count, 3) true poses on a circle, driven round `turns` times."""
    angle = np.linspace(0, 2 * math.pi * turns, count)
    return np.stack(
        [10 * np.sin(angle), 10 - 10 * np.cos(angle), (angle + math.pi) % (2 * math.pi) - math.pi], axis=1
    )


def drifting(truth: Array, seed: int, bias: float = 0.0) -> PoseGraph:
    """A chain of noisy motions, nodes placed by them."""
    rng, graph = np.random.default_rng(seed), PoseGraph()
    graph.add_node(Pose2D.of(truth[0]))
    for k in range(1, len(truth)):
        motion = between(truth[k - 1], truth[k]) + rng.normal(0, [0.03, 0.03, 0.002]) + [0, 0, bias]
        graph.add_node(graph.pose(k - 1) @ Pose2D.of(motion))
        graph.add_edge(k - 1, k, Pose2D.of(motion), CHAIN)
    return graph


def close(graph: PoseGraph, truth: Array, pairs: list[tuple[int, int]], seed: int = 1) -> None:
    """True loops."""
    rng = np.random.default_rng(seed)
    for i, j in pairs:
        motion = Pose2D.of(between(truth[i], truth[j]) + rng.normal(0, [0.02, 0.02, 0.005]))
        graph.add_edge(i, j, motion, LOOP, robust=True)


def mean_error(graph: PoseGraph, truth: Array) -> float:
    """Metres."""
    return float(np.hypot(*(graph.poses - truth)[:, :2].T).mean())


def worst_slack(graph: PoseGraph) -> float:
    """The largest error of a loop."""
    return max(graph.error_of(k) for k in range(len(graph.edges.i)))


LOOPS = [(k, k + 100) for k in range(0, 100, 5)]


@pytest.mark.parametrize("seed", range(3))
def test_loops_take_the_drift_away(seed: int) -> None:
    truth = rounds(200, 2)
    graph = drifting(truth, seed, bias=0.004)
    before = mean_error(graph, truth)
    close(graph, truth, LOOPS)
    graph.optimize(slack=worst_slack(graph))
    assert before > 3.0 and mean_error(graph, truth) < before / 4


@pytest.mark.parametrize("seed", range(3))
def test_false_loops_are_left_aside(seed: int) -> None:
    truth = rounds(200, 2)
    graph = drifting(truth, seed, bias=0.002)
    close(graph, truth, LOOPS)
    rng = np.random.default_rng(seed)
    for _ in range(6):
        i, j = sorted(rng.choice(200, 2, replace=False).tolist())
        graph.add_edge(i, j, Pose2D.of(rng.uniform(-5, 5, 3)), LOOP, robust=True)
    trust = graph.optimize(slack=worst_slack(graph))
    assert mean_error(graph, truth) < 0.3
    assert (trust[-6:] < 0.05).all()
    assert (trust[199:-6] > 0.3).mean() > 0.9


def test_edges_without_noise_give_the_truth_exactly() -> None:
    truth = rounds(50, 1)
    graph = PoseGraph()
    rng = np.random.default_rng(0)
    for k, pose in enumerate(truth):
        graph.add_node(Pose2D.of(pose + (rng.normal(0, 0.3, 3) if k else 0)))
    for k in range(1, 50):
        graph.add_edge(k - 1, k, Pose2D.of(between(truth[k - 1], truth[k])), CHAIN)
    graph.add_edge(0, 49, Pose2D.of(between(truth[0], truth[49])), LOOP)
    graph.optimize(rounds=50)
    assert mean_error(graph, truth) < 1e-6


def test_the_chordal_guess_needs_no_start() -> None:
    truth = rounds(200, 2)
    graph = drifting(truth, 0)
    close(graph, truth, LOOPS)
    nowhere = np.tile(truth[0], (200, 1))
    guess = chordal(graph.edges, nowhere)
    assert np.hypot(*(guess - truth)[:, :2].T).max() < 1.5


def test_restart_escapes_from_a_twisted_start() -> None:
    truth = rounds(120, 2)
    graph = drifting(truth, 0)
    close(graph, truth, [(k, k + 60) for k in range(0, 60, 5)])
    rng = np.random.default_rng(0)
    graph.poses[1:] = compose(np.array([0.0, 0.0, 2.5]), graph.poses[1:]) + rng.normal(0, 2.0, (119, 3))
    graph.restart()
    assert mean_error(graph, truth) < 0.4


def test_derivatives_are_those_of_the_residuals() -> None:
    rng = np.random.default_rng(0)
    poses, motions = rng.uniform(-2, 2, (4, 3)), rng.uniform(-1, 1, (3, 3))
    problem = Problem(
        np.array([0, 1, 2]), np.array([1, 2, 3]), motions, np.tile(np.eye(3), (3, 1, 1)), np.zeros(3, bool)
    )
    for part, nodes in zip(jacobians(problem, poses), (problem.i, problem.j), strict=True):
        for axis in range(3):
            for m, node in enumerate(nodes):
                more, less = poses.copy(), poses.copy()
                more[node, axis] += 1e-6
                less[node, axis] -= 1e-6
                slope = (residuals(problem, more)[m] - residuals(problem, less)[m]) / 2e-6
                assert np.allclose(part[m, :, axis], slope, atol=1e-6)


def test_the_first_pose_stays() -> None:
    truth = rounds(60, 1)
    graph = drifting(truth, 1)
    close(graph, truth, [(0, 59)])
    graph.optimize()
    assert np.allclose(graph.poses[0], truth[0], atol=1e-9)


def test_an_edge_to_a_missing_node_says_how_many_there_are() -> None:
    graph = PoseGraph()
    graph.add_node(Pose2D())
    with pytest.raises(IndexError, match="no node 3: the graph has 1"):
        graph.add_edge(0, 3, Pose2D(), np.eye(3))


def test_empty_graphs_need_no_work() -> None:
    graph = PoseGraph()
    assert len(graph.optimize()) == len(graph.restart()) == 0
    graph.add_node(Pose2D(1.0, 2.0, 0.5))
    graph.restart()
    assert graph.pose(0) == Pose2D(1.0, 2.0, 0.5)
