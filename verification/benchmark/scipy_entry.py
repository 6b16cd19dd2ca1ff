#!/usr/bin/env python3
"""An entry to reference-data/problems by SciPy's solve_ivp with events, written from their page alone.

scipy_entry.py prints the entry, which score.py reads. Names of variables are those of the page.
"""
import csv
import math
import pathlib
import sys
import time
import tomllib

from scipy.integrate import solve_ivp
from scipy.optimize import brentq

PROBLEMS = pathlib.Path(__file__).parents[2] / 'reference-data/problems'
RTOL, ATOL = 2.3e-14, 2.3e-16  # the first is the least that SciPy takes
FREE, SLIDING, ROLLING, INDENTED = range(4)


def falling(guard):
    guard.terminal, guard.direction = True, -1
    return guard


def maximum(rate):
    rate.direction = -1
    return rate


class Problem:
    """State vectors are x, y, phi and their rates."""

    def __init__(self, file):
        p = tomllib.loads(file.read_text(encoding='utf-8'))['parameters']
        self.p = p
        self.m, self.e, self.k, self.d = (
            p[key] for key in ('mass', 'eccentricity', 'support_stiffness', 'support_damping')
        )
        self.mu, self.R, self.c = p['friction'], p['rotor_radius'], p['clearance']
        self.k_t, self.d_t, self.power = (p[key] for key in ('contact_stiffness', 'contact_damping', 'contact_exponent'))
        self.b = [p.get('ring_offset_' + axis, 0) for axis in 'xy']
        self.D_0 = p.get('reference_indentation', 1)
        self.held = p['drive'] == 'constant_speed'
        self.I = math.inf if self.held else p['inertia']
        self.M = 0 if self.held else p['torque']
        self.state, self.sign = FREE, 1
        self.t, self.y = 0.0, self.start()
        self.touch_downs, self.contact_time, self.right_hand_sides = [], 0.0, 0
        self.onset, self.largest_N, self.largest_rho = None, (0.0, 0.0), 0.0

    def start(self):
        w = 2 * math.pi * self.p['start_speed_Hz']
        if 'start_x' in self.p:
            at = [self.p['start_' + key] for key in ('x', 'y', 'velocity_x', 'velocity_y')]
            return [at[0], at[1], 0, at[2], at[3], w]
        O = self.e * self.m * w**2 / complex(self.k - self.m * w**2, self.d * w)
        rate = 1j * w * O
        return [O.real, O.imag, 0, rate.real, rate.imag, w]

    def lose_mass(self):
        e_1 = self.p['unbalance_factor'] * self.e
        m_u = self.m * (e_1 - self.e) / (self.R + e_1)
        m_1 = self.m - m_u
        self.I -= m_u * (self.R + self.e) ** 2 + m_1 * (e_1 - self.e) ** 2
        self.m, self.e = m_1, e_1

    def rim(self, y):
        """rho, n, D' and the velocity of O along t."""
        rho = math.hypot(y[0], y[1])
        n = (y[0] / rho, y[1] / rho) if rho > 0 else (1.0, 0.0)
        return rho, n, n[0] * y[3] + n[1] * y[4], n[0] * y[4] - n[1] * y[3]

    def pressure(self, y):
        """N where the ring presses, and negative where it would have to pull."""
        rho, _, D_rate, _ = self.rim(y)
        D = rho - self.c
        spring = D if self.power == 1 else self.D_0 * math.copysign((abs(D) / self.D_0) ** self.power, D)
        return self.k_t * spring + self.d_t * D_rate

    def slip(self, y):
        return self.rim(y)[3] + self.R * y[5]

    def rates(self, y, N=0.0, H=0.0):
        sx, sy, w = self.e * math.cos(y[2]), self.e * math.sin(y[2]), y[5]
        Fx, Fy = (-self.k * (y[n] + self.b[n]) - self.d * y[3 + n] for n in (0, 1))
        if N or H:
            (nx, ny) = self.rim(y)[1]
            Fx, Fy = Fx - N * nx - H * ny, Fy - N * ny + H * nx
        moment = self.M - self.m * self.p['gravity'] * sy - (sx * Fy - sy * Fx) + self.R * H
        w_rate = moment / self.I
        return [
            y[3],
            y[4],
            w,
            Fx / self.m + w_rate * sy + w**2 * sx,
            Fy / self.m - w_rate * sx + w**2 * sy,
            w_rate,
        ]

    def holding(self, y):
        """H_0."""
        N = max(0.0, self.pressure(y))
        rate = self.rates(y, N)
        rho, n, D_rate, along = self.rim(y)
        a = n[0] * rate[4] - n[1] * rate[3] - along * D_rate / rho + self.R * rate[5]
        arm = self.R - self.e * (math.cos(y[2]) * n[0] + math.sin(y[2]) * n[1])
        return -a / (1 / self.m + arm**2 / self.I)

    def flow(self, _, y):
        if self.state in (FREE, INDENTED):
            return self.rates(y)
        N = self.pressure(y)
        return self.rates(y, N, self.holding(y) if self.state == ROLLING else -self.mu * N * self.sign)

    def pressure_rate(self, t, y):
        rho, n, D_rate, along = self.rim(y)
        rate = self.flow(t, y)
        second = n[0] * rate[3] + n[1] * rate[4] + along**2 / rho
        D = max(0.0, rho - self.c)
        slope = self.k_t if self.power == 1 else self.k_t * self.power * (D / self.D_0) ** (self.power - 1)
        return slope * D_rate + self.d_t * second

    def guards(self):
        """What ends the state, by what follows."""
        release = falling(lambda t, y: self.pressure(y))
        if self.d_t == 0:
            release = falling(lambda t, y: self.rim(y)[0] - self.c)
        clear = falling(lambda t, y: self.rim(y)[0] - self.c)
        if self.state == FREE:
            return [(self.touch_down, falling(lambda t, y: self.c - self.rim(y)[0]))]
        if self.state == INDENTED:
            return [(self.free, clear), (self.begin_contact, falling(lambda t, y: -self.pressure(y)))]
        if self.state == SLIDING and self.mu == 0:
            return [(self.release, release)]
        if self.state == SLIDING:
            return [(self.release, release), (self.zero_slip, falling(lambda t, y: self.sign * self.slip(y)))]
        grip = falling(lambda t, y: self.mu * self.pressure(y) - abs(self.holding(y)))
        return [(self.release, release), (self.slide, grip)]

    def touch_down(self):
        self.touch_downs.append(self.t)
        self.begin_contact()

    def begin_contact(self):
        self.state = SLIDING
        self.sign = math.copysign(1, self.slip(self.y))
        self.note_pressure(self.t, self.y)
        if self.mu > 0 and self.slip(self.y) == 0:
            self.zero_slip()

    def free(self):
        self.state = FREE

    def release(self):
        self.state = INDENTED if self.d_t > 0 else FREE

    def slide(self):
        self.state = SLIDING
        self.sign = -math.copysign(1, self.holding(self.y))

    def zero_slip(self):
        if abs(self.holding(self.y)) > self.mu * self.pressure(self.y):
            return self.slide()
        self.state = ROLLING
        self.onset = self.onset or (self.t, self.y[5] / (2 * math.pi), self.pressure(self.y))

    def note_pressure(self, t, y):
        self.largest_N = max(self.largest_N, (self.pressure(y), t))

    def advance(self, end):
        """One state of contact: until it ends, or the run does."""
        guards = self.guards()
        touches = self.state in (SLIDING, ROLLING)
        rates = [maximum(lambda t, y: self.rim(y)[2])]
        if touches:
            rates.append(maximum(lambda t, y: self.pressure_rate(t, y)))
        scale = max(abs(self.y[5]), math.sqrt(self.k / self.m), 1)
        atol = [ATOL * unit for unit in (self.c, self.c, 1, self.c * scale, self.c * scale, scale)]
        run = solve_ivp(
            self.flow,
            (self.t, end),
            self.y,
            method='DOP853',
            rtol=RTOL,
            atol=atol,
            # The first step leaves the zero of the guard that has just been passed.
            first_step=min(1e-3 * math.sqrt(self.m / self.k_t), end - self.t),
            events=rates + [guard for _, guard in guards],
            dense_output=self.state == FREE,
        )
        after, self.y, until = None, list(run.y[:, -1]), run.t[-1]
        self.right_hand_sides += run.nfev
        for (follow, _), times in zip(guards, run.t_events[len(rates) :]):
            if len(times):
                after = follow
        # A step may pass over a short graze, whose largest rho is an event.
        for t, y in zip(run.t_events[0], run.y_events[0]):
            if self.state == FREE and self.rim(y)[0] > self.c:
                before = max(time for time in run.t if time < t)
                until = brentq(lambda time: self.rim(run.sol(time))[0] - self.c, before, t, xtol=1e-300, rtol=1e-15)
                after, self.y = self.touch_down, list(run.sol(until))
                break
        for t, y in zip(run.t_events[0], run.y_events[0]):
            if t <= until:
                self.largest_rho = max(self.largest_rho, self.rim(y)[0])
        if touches:
            for t, y in zip(run.t_events[1], run.y_events[1]):
                self.note_pressure(t, y)
            self.contact_time += until - self.t
        self.t = until
        self.largest_rho = max(self.largest_rho, self.rim(self.y)[0])
        if after:
            after()

    def solve(self):
        self.largest_rho = self.rim(self.y)[0]
        if self.largest_rho > self.c:
            self.begin_contact()
        end = self.p['until']
        if not self.p.get('no_mass_loss', False):
            assert self.p['mass_loss_time'] == 0, 'the problems lose mass at the start'
            self.lose_mass()
        while self.t < end:
            self.advance(end)
        return self.quantities()

    def quantities(self):
        x, y, phi, _, _, w = self.y
        found = {f'touch_down_{n}_s': t for n, t in enumerate(self.touch_downs, 1)}
        if self.onset:
            found.update(zip(('rolling_onset_s', 'rolling_onset_speed_Hz', 'rolling_onset_force_N'), self.onset))
        found |= {
            'touch_downs': len(self.touch_downs),
            'peak_normal_force_N': self.largest_N[0],
            'peak_time_s': self.largest_N[1],
            'peak_displacement_m': self.largest_rho,
            'contact_time_s': self.contact_time,
            'final_speed_Hz': w / (2 * math.pi),
            'final_q1_m': x * math.cos(phi) + y * math.sin(phi),
            'final_q2_m': y * math.cos(phi) - x * math.sin(phi),
            'final_displacement_m': math.hypot(x, y),
        }
        return {name: value if isinstance(value, int) else float(value) for name, value in found.items()}


def main():
    with open(PROBLEMS / 'answers.csv', encoding='utf-8') as answers:
        rows = csv.DictReader(line for line in answers if line[0] != '#')
        asked = [(row['problem'], row['quantity']) for row in rows]
    table = csv.writer(sys.stdout, lineterminator='\n')
    table.writerow(['problem', 'quantity', 'value', 'seconds', 'right_hand_sides'])
    for problem in dict.fromkeys(problem for problem, _ in asked):
        begin = time.process_time()
        run = Problem(PROBLEMS / f'{problem}.toml')
        found = run.solve()
        costs = f'{time.process_time() - begin:.2g}', run.right_hand_sides
        for name, quantity in asked:
            if name == problem and quantity in found:
                table.writerow([problem, quantity, repr(found[quantity]), *costs])


if __name__ == '__main__':
    main()
