#!/usr/bin/env python3
"""How many results of random rotors a change of the engine alters, beside those that its tolerance leaves open.

differential.py OLD NEW COUNT [TOLERANCE] runs COUNT rotors by the programs OLD and NEW at a tolerance of 1e-11, and by
OLD at 1e-12. A row is a rotor whose results differ by more than TOLERANCE (default 1e-6) of their value, or in a count or a
name. Fails if more rows differ between NEW and OLD than between OLD's tolerances. Needs build/random-rotors.
"""
import itertools
import json
import math
import re
import subprocess
import sys


def results(program, options, tolerance):
    """The results of a run, without remarks and costs, by their keys; none where it is refused."""
    stated = re.sub(r'--tolerance \S+', f'--tolerance {tolerance}', options).split()
    run = subprocess.run([program, 'run', *stated, '--json'], capture_output=True, text=True)
    if run.returncode != 0:
        return {}
    return dict(itertools.takewhile(lambda item: item[0] != 'remarks', json.loads(run.stdout).items()))


def is_same(one, other, tolerance):
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=tolerance)
    return one == other


def different(name, old, new, tolerance):
    """The number of rotors with different results, of which it prints the first."""
    rows = []
    for n, (before, after) in enumerate(zip(old, new)):
        changed = [key for key in before.keys() | after.keys()
                   if not is_same(before.get(key), after.get(key), tolerance)]
        if changed:
            key = min(changed)
            rows.append(f'{n + 1}: {key} {before.get(key)} {after.get(key)}')
    first = f', the first: {rows[0]}' if rows else ''
    print(f'{len(old)} rotors, {len(rows)} rows differ {name}{first}', file=sys.stderr)
    return len(rows)


def main(old, new, count, tolerance='1e-6'):
    listed = subprocess.run(['build/random-rotors', count], check=True, capture_output=True, text=True).stdout
    rotors = [line for line in listed.splitlines() if line.startswith('--') and '--method rk4' not in line]
    before = [results(old, options, '1e-11') for options in rotors]
    finer = [results(old, options, '1e-12') for options in rotors]
    after = [results(new, options, '1e-11') for options in rotors]
    of_tolerance = different('between 1e-11 and 1e-12', before, finer, float(tolerance))
    of_program = different('between the programs', before, after, float(tolerance))
    return int(of_program > of_tolerance)


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
