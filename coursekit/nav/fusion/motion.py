"""The motion model of a body with six degrees of freedom: constant acceleration, integrated to velocity and pose."""

from __future__ import annotations

import math

import numpy as np

from coursekit.nav.fusion.state import ACCELERATION, ANGLES, ANGULAR, LINEAR, PITCH, POSITION, ROLL, SIZE, YAW, Array


def rotation(roll: float, pitch: float, yaw: float) -> Array:
    """Return the matrix from the body's frame to the world's: roll first, then pitch, then yaw [rad].

    >>> (rotation(0.0, 0.0, math.pi / 2) @ [1.0, 0.0, 0.0]).round(3).tolist()
    [0.0, 1.0, 0.0]
    """
    return _about_z(yaw)[0] @ _about_y(pitch)[0] @ _about_x(roll)[0]


def _about_x(angle: float) -> tuple[Array, Array]:
    """Return the matrix and its derivative with respect to the angle."""
    s, c = math.sin(angle), math.cos(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), np.array([[0.0, 0, 0], [0, -s, -c], [0, c, -s]])


def _about_y(angle: float) -> tuple[Array, Array]:
    s, c = math.sin(angle), math.cos(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]), np.array([[-s, 0, c], [0.0, 0, 0], [-c, 0, -s]])


def _about_z(angle: float) -> tuple[Array, Array]:
    s, c = math.sin(angle), math.cos(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.array([[-s, -c, 0], [c, -s, 0], [0.0, 0, 0]])


def _rates(roll: float, pitch: float) -> tuple[Array, Array, Array]:
    """Return the matrix from body rates to the rates of roll, pitch and yaw; and its derivatives by roll and pitch."""
    sr, cr, cp = math.sin(roll), math.cos(roll), math.cos(pitch)
    tp = math.sin(pitch) / cp
    by_cp, by_cp2, tp_by_cp = 1 / cp, 1 / (cp * cp), tp / cp
    value = np.array([[1, sr * tp, cr * tp], [0, cr, -sr], [0, sr * by_cp, cr * by_cp]])
    with_roll = np.array([[0, cr * tp, -sr * tp], [0, -sr, -cr], [0, cr * by_cp, -sr * by_cp]])
    with_pitch = np.array([[0, sr * by_cp2, cr * by_cp2], [0.0, 0, 0], [0, sr * tp_by_cp, cr * tp_by_cp]])
    return value, with_roll, with_pitch


def step(state: Array, seconds: float) -> Array:
    """Return the state after `seconds`; its angles are not wrapped.

    >>> state = np.zeros(SIZE)
    >>> state[6] = 2.0  # forward
    >>> step(state, 0.5)[:2].tolist()
    [1.0, 0.0]
    """
    moved = state.copy()
    roll, pitch, yaw = state[ANGLES]
    way = state[LINEAR] * seconds + state[ACCELERATION] * (seconds * seconds / 2)
    moved[POSITION] += rotation(roll, pitch, yaw) @ way
    moved[ANGLES] += _rates(roll, pitch)[0] @ state[ANGULAR] * seconds
    moved[LINEAR] += state[ACCELERATION] * seconds
    return moved


def jacobian(state: Array, seconds: float) -> Array:
    """Return the Jacobian of `step`, (15, 15)."""
    roll, pitch, yaw = state[ANGLES]
    (about_x, d_roll), (about_y, d_pitch), (about_z, d_yaw) = _about_x(roll), _about_y(pitch), _about_z(yaw)
    turned = about_z @ about_y @ about_x
    way = state[LINEAR] * seconds + state[ACCELERATION] * (seconds * seconds / 2)
    jacobian = np.eye(SIZE)
    jacobian[POSITION, LINEAR] = turned * seconds
    jacobian[POSITION, ACCELERATION] = turned * (seconds * seconds / 2)
    jacobian[POSITION, ROLL] = about_z @ about_y @ d_roll @ way
    jacobian[POSITION, PITCH] = about_z @ d_pitch @ about_x @ way
    jacobian[POSITION, YAW] = d_yaw @ about_y @ about_x @ way
    rates, with_roll, with_pitch = _rates(roll, pitch)
    jacobian[ANGLES, ANGULAR] = rates * seconds
    jacobian[ANGLES, ROLL] += with_roll @ state[ANGULAR] * seconds
    jacobian[ANGLES, PITCH] += with_pitch @ state[ANGULAR] * seconds
    jacobian[LINEAR, ACCELERATION] = np.eye(3) * seconds
    return jacobian
