"""SciPy as a peer: solve_ivp with events on the paper's equations, written anew in Python.

scipy_peer.py SCENES.json ROWS.csv reads the scenes that the benchmark writes and adds a row for
each method and tolerance, in the columns of work-precision.csv.
"""

import json
import sys
import time
from math import cos, hypot, pi, sin, sqrt

import numpy as np
from scipy.integrate import solve_ivp

FREE, SLIDING, ROLLING, INDENTED = range(4)


class Rotor:
    """The phases of the motion in the rotating axes O_a xy, Eqs. (3), (4) and (15)-(25)."""

    def __init__(self, scene):
        p = scene["parameters"]
        self.m, self.I, self.e = scene["mass"], scene["inertia"], scene["eccentricity"]
        self.k, self.d, self.g = p["support_stiffness"], p["support_damping"], p["gravity"]
        self.torque = p["torque"] if scene["motor_on"] else 0.0
        self.k_t, self.d_t, self.mu = p["contact_stiffness"], p["contact_damping"], p["friction"]
        self.r, self.clearance = p["rotor_radius"], p["stator_radius"] - p["rotor_radius"]
        self.contact = ROLLING if scene["rolling"] else FREE
        self.direction = 0
        self.evaluations = 0

    def supports(self, q):
        """Forces along x and y, moment about O_a, velocity of O."""
        x, y, angle, vx, vy, w = q
        ux, uy = vx - w * y, vy + w * x
        fx, fy = -self.d * ux - self.k * x, -self.d * uy - self.k * y
        # gravity as printed, with the whole weight
        gravity = self.m * self.g * (-(x + self.e) * sin(angle) - y * cos(angle))
        return fx, fy, gravity - self.d * (x * uy - y * ux) + self.torque, ux, uy

    def accelerate(self, q, fx, fy, moment):
        """Relative to O_a xy, and angular."""
        x, y, _, vx, vy, w = q
        cx = x + self.e
        angular = (moment - (cx * fy - y * fx)) / self.I
        return (
            fx / self.m + angular * y + 2 * w * vy + w * w * cx,
            fy / self.m - angular * cx - 2 * w * vx + w * w * y,
            angular,
        )

    def rim(self, q):
        """rho, normal, rate of rho, slip velocity, F_n."""
        x, y, _, vx, vy, w = q
        rho = hypot(x, y)
        nx, ny = x / rho, y / rho
        rate = nx * vx + ny * vy
        slip = nx * (vy + w * x) - ny * (vx - w * y) + self.r * w
        return rho, nx, ny, rate, slip, -self.k_t * (rho - self.clearance) - self.d_t * rate

    def slip_rate(self, q, nx, ny, rho, rate, slip, acceleration):
        """Of v_Ktau = (rho + r) w + rho alpha', alpha in the rotating axes."""
        w = q[5]
        ax, ay, angular = acceleration
        relative = slip - self.r * w - rho * w  # rho alpha'
        return (rho + self.r) * angular + rate * w + nx * ay - ny * ax - relative * rate / rho

    def friction(self, q, rim, loads):
        rho, nx, ny, rate, slip, normal = rim
        if self.contact == SLIDING:
            return self.direction * self.mu * normal
        fx, fy, moment = loads[0] + normal * nx, loads[1] + normal * ny, loads[2]
        rates = [
            self.slip_rate(
                q, nx, ny, rho, rate, slip,
                self.accelerate(q, fx - f * ny, fy + f * nx, moment + f * (rho + self.r)),
            )
            for f in (0.0, 1.0)
        ]  # fmt: skip
        return rates[0] / (rates[0] - rates[1])

    def __call__(self, _, q):
        self.evaluations += 1
        loads = self.supports(q)
        fx, fy, moment = loads[:3]
        if self.contact in (SLIDING, ROLLING):
            rim = self.rim(q)
            rho, nx, ny, _, _, normal = rim
            f = self.friction(q, rim, loads)
            fx, fy, moment = (
                fx + normal * nx - f * ny,
                fy + normal * ny + f * nx,
                moment + f * (rho + self.r),
            )
        return (q[3], q[4], q[5], *self.accelerate(q, fx, fy, moment))

    def grip(self, q):
        """(mu F_n)^2 - F_tau^2 if the rim rolled, and F_tau."""
        contact, self.contact = self.contact, ROLLING
        rim = self.rim(q)
        f = self.friction(q, rim, self.supports(q))
        self.contact = contact
        return (self.mu * rim[5]) ** 2 - f * f, f

    def events(self):
        """Guards of the phase and what follows each."""

        def guard(value, follow):
            def event(_, q):
                return value(q)

            event.terminal, event.direction, event.follow = True, -1, follow
            return event

        if self.contact == FREE:
            clearance = self.clearance**2
            return [guard(lambda q: clearance - q[0] * q[0] - q[1] * q[1], self.touch)]
        if self.contact == INDENTED:
            return [
                guard(lambda q: self.rim(q)[0] - self.clearance, self.clear),
                guard(lambda q: self.rim(q)[5], self.touch),
            ]
        release = guard(lambda q: -self.rim(q)[5], self.release)
        if self.contact == SLIDING:
            return [release, guard(lambda q: self.direction * self.rim(q)[4], self.stick)]
        return [release, guard(lambda q: self.grip(q)[0], self.slide)]

    def touch(self, q):
        self.contact, self.direction = SLIDING, 1 if self.rim(q)[4] > 0 else -1

    def clear(self, _):
        self.contact = FREE

    def release(self, _):
        self.contact = INDENTED

    def stick(self, q):
        if self.grip(q)[0] >= 0:
            self.contact = ROLLING
        else:
            self.slide(q)

    def slide(self, q):
        self.contact, self.direction = SLIDING, -1 if self.grip(q)[1] > 0 else 1

    def scale(self, w):
        length = self.clearance / (1 if self.contact == ROLLING else 100)
        fastest = max(abs(w), sqrt(self.k / self.m))
        if self.contact in (SLIDING, ROLLING):
            fastest = max(fastest, sqrt(self.k_t / self.m))
        return np.array([length, length, 1, length * fastest, length * fastest, fastest / 10])


def solve(scene, method, tolerance):
    rotor = Rotor(scene)
    t, q = scene["from_s"], np.array(scene["state"])
    touch_downs, steps, events = [], 0, 0
    while True:
        guards = rotor.events()
        solution = solve_ivp(
            rotor, (t, scene["until_s"]), q, method=method, events=guards,
            rtol=max(1e-3 * tolerance, 3e-14), atol=tolerance * rotor.scale(q[5]),
        )  # fmt: skip
        if solution.status < 0 or events > 10000:
            raise RuntimeError("SciPy gave up")
        steps += len(solution.t) - 1
        t, q = solution.t[-1], solution.y[:, -1]
        if solution.status == 0:
            return q, touch_downs, rotor.evaluations, steps, events
        events += 1
        fired = next(g for g, times in zip(guards, solution.t_events) if len(times))
        if rotor.contact == FREE:
            touch_downs.append(t)
        fired.follow(q)


def state_error(scene, q):
    """As in benchmark/problem.cpp."""
    exact = np.array(scene["exact_state"])
    p = scene["parameters"]
    length = p["stator_radius"] - p["rotor_radius"]
    speed, w = hypot(exact[3], exact[4]), abs(exact[5])
    return max(
        hypot(*(q[:2] - exact[:2])) / length,
        hypot(*(q[3:5] - exact[3:5])) / (speed + length * w),
        abs(q[5] - exact[5]) / w,
    )


HEADINGS = (
    "problem,method,setting,error_state,error_event_s,error_peak,time_s,time_median_s,"
    "right_hand_sides,steps,events\n"
)


def main(scenes_file, rows_file):
    with open(scenes_file) as file:
        scenes = json.load(file)
    with open(rows_file, "w") as rows:
        rows.write(HEADINGS)
        for scene in scenes:
            if scene["name"] == "run-up":
                continue  # minutes in Python
            for method in ("DOP853", "LSODA"):
                for digits in (5, 7, 9, 11):
                    begin = time.perf_counter()
                    try:
                        q, touch_downs, evaluations, steps, events = solve(scene, method, 10.0**-digits)
                    except (RuntimeError, ValueError):
                        continue
                    elapsed = time.perf_counter() - begin
                    exact = scene["exact_touch_downs"]
                    event_error = (
                        max((abs(a - b) for a, b in zip(touch_downs, exact)), default=0.0)
                        if len(touch_downs) == len(exact)
                        else float("nan")
                    )
                    rows.write(
                        f"{scene['name']},SciPy {method},1e-{digits},{state_error(scene, q):.3e},"
                        f"{event_error:.3e},nan,{elapsed:.4e},{elapsed:.4e},{evaluations},{steps},"
                        f"{events}\n"
                    )


if __name__ == "__main__":
    main(*sys.argv[1:])
