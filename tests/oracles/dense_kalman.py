"""The same filter, written with 15 x 15 matrices and rotation matrices of SciPy.

Sections 5.4 and 6.1 of Solà (arXiv 1711.02508) as full matrices F, H, P, corrections in Joseph's form.
It knows of no exposures: it keeps every sample since the start, corrects them all, and goes on from
the last one before a pose's own time by the rates of the sample after it.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

P, V, T, A, W = (slice(3 * k, 3 * k + 3) for k in range(5))


def cross_matrix(a):
    return np.cross(np.eye(3), a)


class DenseKalman:
    def __init__(self, settings, estimate, deviations):
        self.s = settings
        self.r = np.array(settings.offset)
        self.R = Rotation.from_quat(estimate.attitude, scalar_first=True)
        self.p = np.array(estimate.position) + self.R.apply(self.r)
        self.v = np.array(estimate.velocity) + self.R.apply(
            np.cross(estimate.angular_velocity, self.r)
        )
        self.b = np.zeros(3)
        self.c = np.zeros(3)
        self.cov = np.diag(np.repeat(np.array(deviations) ** 2, 3))
        self.k, self.past = 0, []
        for k in range(
            -20, 1
        ):  # stood for a while: time, place, velocity, attitude, and rates since
            there = self.p + k * settings.interval * self.v
            self.past.append([k, there, self.v, self.R, np.zeros(3), np.zeros(3)])
        self.begin()

    def begin(self):
        self.samples, self.before, self.gained, self.clipped, self.spun = 0, self.R, 0.0, 0.0, 0.0

    def sample(self, force, spin):
        s, dt = self.s, self.s.interval
        self.clipped += dt * (np.abs(force).max() > 0.9 * s.accelerometer_range)
        self.spun += dt * (np.abs(spin).max() > 0.9 * s.gyroscope_range)
        self.omega = spin - self.c
        half = Rotation.from_rotvec(0.5 * dt * self.omega)
        f = (self.R * half).apply(force - self.b)
        a = f - np.array([0.0, 0.0, s.gravity])
        self.a = a
        self.p = self.p + dt * self.v + 0.5 * dt**2 * a
        self.v = self.v + dt * a
        self.R = self.R * half * half
        self.gained = self.gained + dt * f
        self.samples += 1
        self.k += 1
        self.past.append([self.k, self.p, self.v, self.R, a, self.omega])

    def propagate(self):
        s, duration = self.s, self.samples * self.s.interval
        f = np.eye(15)
        f[P, V] = duration * np.eye(3)
        f[V, T] = -cross_matrix(self.gained) @ self.before.as_matrix()
        f[V, A] = -0.5 * duration * (self.before.as_matrix() + self.R.as_matrix())
        f[T, T] = self.R.as_matrix().T @ self.before.as_matrix()
        f[T, W] = -duration * np.eye(3)
        q = np.zeros((15, 15))
        q[V, V] = 0.5 * s.accelerometer_noise**2 * duration * np.eye(3)
        q[V, V] += s.accelerometer_range**2 * s.distrust * self.clipped * np.eye(3)
        q[T, T] = 0.5 * s.gyroscope_noise**2 * duration * np.eye(3)
        q[T, T] += s.gyroscope_range**2 * s.distrust * self.spun * np.eye(3)
        q[A, A] = s.accelerometer_walk**2 * duration * np.eye(3)
        q[W, W] = s.gyroscope_walk**2 * duration * np.eye(3)
        self.cov = f @ self.cov @ f.T + q
        self.begin()

    def recalled(self, lag):
        k = math.floor(-lag / self.s.interval + 1e-9)
        on = -lag - k * self.s.interval
        _, p, v, r, _, _ = self.past[k - 1]
        if on < 1e-12:
            return p, r
        _, _, _, _, a, omega = self.past[k]
        return p + on * v + 0.5 * on**2 * a, r * Rotation.from_rotvec(on * omega)

    def update(self, h, z, sigma):
        s = h @ self.cov @ h.T + sigma**2 * np.eye(3)
        k = self.cov @ h.T @ np.linalg.inv(s)
        left = np.eye(15) - k @ h
        self.cov = left @ self.cov @ left.T + sigma**2 * k @ k.T  # Joseph's form
        d = k @ z
        before_p, before_v, before_r = self.p, self.v, self.R
        self.p, self.v, self.b, self.c = (
            self.p + d[P],
            self.v + d[V],
            self.b + d[A],
            self.c + d[W],
        )
        self.R = self.R * Rotation.from_rotvec(d[T])
        turn = self.R * before_r.inv()
        for past in self.past:
            t = (self.k - past[0]) * self.s.interval
            past[1] = past[1] + (self.p - before_p) - t * (self.v - before_v)
            past[2] = past[2] + (self.v - before_v)
            past[3] = turn * past[3]
        self.omega = self.omega - d[W]
        return float(z @ np.linalg.solve(s, z))

    def pose(self, position, attitude, age):
        lag = age - self.s.inertial_lag
        p, r = self.recalled(lag)
        h = np.zeros((3, 15))
        h[:, P] = np.eye(3)
        h[:, V] = -lag * np.eye(3)
        h[:, T] = r.as_matrix() @ cross_matrix(self.r) @ (r.inv() * self.R).as_matrix()
        first = self.update(h, position - (p - r.apply(self.r)), self.s.position_noise)
        _, r = self.recalled(lag)
        h = np.zeros((3, 15))
        h[:, T] = np.eye(3)
        h[:, W] = lag * np.eye(3)
        z = (self.R.inv() * r).apply((r.inv() * attitude).as_rotvec())
        second = self.update(h, z, self.s.attitude_noise)
        self.begin()
        return first, second

    def spoken(self):
        ahead = self.s.inertial_lag
        q = self.R * Rotation.from_rotvec(ahead * self.omega)
        return (
            self.p + ahead * self.v + 0.5 * ahead**2 * self.a - q.apply(self.r),
            q,
            self.v + ahead * self.a - q.apply(np.cross(self.omega, self.r)),
            self.omega,
        )

    def tick(self, force, spin, fresh, position, attitude, age):
        self.sample(force, spin)
        surprise = None
        if self.samples >= self.s.every or fresh:
            self.propagate()
        if fresh:
            surprise = self.pose(position, attitude, age)
        return surprise
