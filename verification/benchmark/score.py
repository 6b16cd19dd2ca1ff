#!/usr/bin/env python3
"""Right digits of entries to reference-data/problems: score.py [--csv] ENTRY.csv...

An entry has the columns problem, quantity, value and perhaps seconds (of processor time, of the whole problem). One entry
is printed quantity by quantity; several are compared in one table, or with --csv in rows for a picture. Unknown names are
errors.
"""
import csv
import math
import pathlib
import sys

ANSWERS = pathlib.Path(__file__).parents[2] / 'reference-data/problems/answers.csv'


class Refused(Exception):
    """What is wrong with an entry: file, row and cure."""


def rows_of(file):
    """Yields a place for messages and a row as a dictionary. Lines that start with # are comments."""
    try:
        lines = pathlib.Path(file).read_text(encoding='utf-8').splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise Refused(f'{file}: cannot be read: {error}') from error
    table = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and line[0] != '#']
    reader = csv.DictReader(line for _, line in table)
    lacking = {'problem', 'quantity', 'value'} - set(reader.fieldnames or [])
    if lacking:
        raise Refused(f"{file}: must have a first row with the columns {', '.join(sorted(lacking))}")
    for (number, _), row in zip(table[1:], reader):
        yield f'{file}, line {number}', row


def number(row, column, place):
    try:
        value = float(row[column])
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise Refused(f'{place}: {column} must be a number, not {row[column]!r}')
    return value


def right_digits(value, answer):
    """Significant digits that agree, at most those of the answer; of a count all or none."""
    exact = float(answer['value'])
    if answer['digits'] == 'exact':
        return math.inf if value == exact else 0.0
    most, off = int(answer['digits']), abs(value - exact) / abs(exact)
    return float(most) if off <= 10**-most else min(float(most), max(0.0, -math.log10(off)))


def score(file, answers):
    """Right digits by problem and quantity, and seconds by problem."""
    digits, seconds = {problem: {} for problem in answers}, {}
    for place, row in rows_of(file):
        problem, quantity = row['problem'], row['quantity']
        if problem not in answers:
            raise Refused(f"{place}: unknown problem {problem!r}; must be one of: {', '.join(answers)}")
        if quantity not in answers[problem]:
            raise Refused(
                f"{place}: unknown quantity {quantity!r} of {problem}; must be one of: {', '.join(answers[problem])}"
            )
        if quantity in digits[problem]:
            raise Refused(f'{place}: {quantity} of {problem} is stated twice; remove one row')
        digits[problem][quantity] = right_digits(number(row, 'value', place), answers[problem][quantity])
        if row.get('seconds'):
            seconds[problem] = max(seconds.get(problem, 0.0), number(row, 'seconds', place))
    return digits, seconds


def words(digits):
    return 'right' if digits == math.inf else f'{digits:.1f}' if digits else '0'


def missing(found, answers):
    return [quantity for quantity in answers if quantity not in found]


def worst(found, answers):
    """Least digits of a problem; `-` for one that is not entered, and a mark where rows are missing."""
    if not found:
        return '-'
    return words(min(found.values())) + (' *' if missing(found, answers) else '')


def print_quantities(digits, answers):
    for problem, found in digits.items():
        if not found:
            continue
        print(problem)
        for quantity in answers[problem]:
            print(f"  {quantity:<24}{words(found[quantity]) if quantity in found else 'missing'}")
    print()


def print_table(scores, answers):
    titles = ['problem']
    for file, _, _ in scores:
        titles += [pathlib.Path(file).stem, 's']
    print('| ' + ' | '.join(titles) + ' |')
    print('|' + '---|' * len(titles))
    for problem in answers:
        cells = [problem]
        for _, digits, seconds in scores:
            time = f'{seconds[problem]:.2g}' if problem in seconds else '-'
            cells += [worst(digits[problem], answers[problem]), time]
        print('| ' + ' | '.join(cells) + ' |')
    for file, digits, _ in scores:
        for problem, found in digits.items():
            if found and missing(found, answers[problem]):
                print(f"* {file}: {problem} lacks {', '.join(missing(found, answers[problem]))}")
        absent = [problem for problem, found in digits.items() if not found]
        if absent:
            print(f"- {file}: not entered: {', '.join(absent)}")


def print_csv(scores, answers):
    """The least digits of each entry in each problem, and how many quantities it lacks."""
    table = csv.writer(sys.stdout, lineterminator='\n')
    table.writerow(['entry', 'problem', 'digits', 'lacks', 'seconds'])
    for file, digits, seconds in scores:
        for problem, found in digits.items():
            if found:
                least, lacks = f'{min(found.values()):.2f}', len(missing(found, answers[problem]))
                table.writerow([pathlib.Path(file).stem, problem, least, lacks, seconds.get(problem, '')])


def main(files):
    is_csv = files[:1] == ['--csv']
    files = files[is_csv:]
    if not files:
        raise Refused('needs: ENTRY.csv..., with the columns problem, quantity, value and perhaps seconds')
    answers = {}
    for _, row in rows_of(ANSWERS):
        answers.setdefault(row['problem'], {})[row['quantity']] = row
    scores = [(file, *score(file, answers)) for file in files]
    if is_csv:
        return print_csv(scores, answers)
    if len(scores) == 1:
        print_quantities(scores[0][1], answers)
    print_table(scores, answers)


if __name__ == '__main__':
    try:
        main(sys.argv[1:])
    except Refused as error:
        sys.exit(f'score.py: {error}')
