#!/usr/bin/env python3
"""An entry to reference-data/problems by this suite: rotor_entry.py PROGRAM OPTION..., the options being those of `rotor run`."""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from entry import print_entry


def solve(file):
    program, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        events = pathlib.Path(folder, 'events.csv')
        if 'rk4' not in options:  # fixed steps locate no events
            options += ['--events', events]
        run = subprocess.run([program, 'run', file, '--json', *options], check=True, stdout=subprocess.PIPE)
        lines = events.read_text(encoding='utf-8').splitlines() if events.exists() else []
    found = {key: value for key, value in json.loads(run.stdout).items() if isinstance(value, (int, float))}
    rows = csv.DictReader(line for line in lines if line[0] != '#')
    times = [float(row['time_s']) for row in rows if row['event'] == 'touch_down'] or [found.get('first_contact_s')]
    found.update((f'touch_down_{n}_s', time) for n, time in enumerate(times, 1) if time)
    found['final_displacement_m'] = math.hypot(found['final_q1_m'], found['final_q2_m'])
    return found


if __name__ == '__main__':
    print_entry(solve)
