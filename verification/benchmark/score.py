#!/usr/bin/env python3
"""Right digits of entries to reference-data/problems: score.py [--csv] ENTRY.csv...

An entry has the columns problem, quantity and value, and perhaps seconds (of processor time) and right_hand_sides (how
often the equations of motion were evaluated), both of the whole problem. One entry is printed quantity by quantity;
several are compared, or with --csv written in rows for a picture. Unknown names are errors.
"""
import collections
import csv
import math
import pathlib
import sys

ANSWERS = pathlib.Path(__file__).parents[2] / 'reference-data/problems/answers.csv'
NEEDED, COSTS = ['problem', 'quantity', 'value'], ['seconds', 'right_hand_sides']
Score = collections.namedtuple('Score', ['file', 'digits', *COSTS])  # each but the first by problem


class Refused(Exception):
    """What is wrong with an entry: file, row and cure."""


def rows_of(file, names):
    """Yields a place for messages and a row as a dictionary. Lines that start with # are comments."""
    try:
        lines = pathlib.Path(file).read_text(encoding='utf-8-sig').splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise Refused(f'{file}: cannot be read: {error}') from error
    numbers = [number for number, line in enumerate(lines, 1) if line.strip() and line[0] != '#']
    reader = csv.DictReader((lines[number - 1] for number in numbers), strict=True)
    place = f'{file}, line {numbers[0]}' if numbers else file
    try:
        titles = reader.fieldnames or []
        if len(set(titles)) < len(titles) or not set(names[:3]) <= set(titles) <= set(names):
            raise Refused(
                f"{place}: the first row must be {','.join(names[:3])}, perhaps with {' and '.join(names[3:])}, "
                f"not {','.join(titles)!r}"
            )
        for row in reader:
            place = f'{file}, line {numbers[reader.line_num - 1]}'
            cells = len(titles) + len(row.get(None, [])) - list(row.values()).count(None)
            if cells != len(titles):
                raise Refused(f'{place}: {cells} cells; must be {len(titles)}, as in the first row')
            yield place, row
    except csv.Error as error:
        raise Refused(f'{file}, line {numbers[reader.reader.line_num - 1]}: {error}') from error


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


def cost(row, column, place):
    value, is_count = number(row, column, place), column == 'right_hand_sides'
    if value < 0 or (is_count and value % 1 > 0):
        raise Refused(f"{place}: {column} must be {'a whole' if is_count else 'a positive'} number, not {row[column]!r}")
    return int(value) if is_count else value


def score(file, answers):
    found = Score(file, {problem: {} for problem in answers}, {}, {})
    for place, row in rows_of(file, NEEDED + COSTS):
        problem, quantity = row['problem'], row['quantity']
        if problem not in answers:
            raise Refused(f"{place}: unknown problem {problem!r}; must be one of: {', '.join(answers)}")
        if quantity not in answers[problem]:
            raise Refused(
                f"{place}: unknown quantity {quantity!r} of {problem}; must be one of: {', '.join(answers[problem])}"
            )
        digits = found.digits[problem]
        if quantity in digits:
            raise Refused(f'{place}: {quantity} of {problem} is stated twice; remove one row')
        digits[quantity] = right_digits(number(row, 'value', place), answers[problem][quantity])
        for column in COSTS:
            if row.get(column):
                value, known = cost(row, column, place), getattr(found, column)
                if known.setdefault(problem, value) != value:
                    raise Refused(f'{place}: {column} of {problem} was {known[problem]:g} above; state one of them')
    return found


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


def print_table(titles, rows):
    for cells in (titles, ['---'] * len(titles), *rows):
        print('| ' + ' | '.join(cells) + ' |')
    print()


def print_tables(scores, answers):
    """Right digits; and what they cost."""

    def digits(of, problem):
        return worst(of.digits[problem], answers[problem])

    def costs(of, problem):
        seconds, count = (getattr(of, column).get(problem) for column in COSTS)
        if not of.digits[problem]:
            return '-'
        time = '-' if seconds is None else f'{seconds:.2g}'
        return time + (' / not counted' if count is None else f' / {count:,}')

    names = [pathlib.Path(of.file).stem for of in scores]
    for title, cell in (('right digits', digits), ('seconds / right-hand sides', costs)):
        print_table([title, *names], [[problem, *(cell(of, problem) for of in scores)] for problem in answers])
    for of in scores:
        for problem, found in of.digits.items():
            if found and missing(found, answers[problem]):
                print(f"* {of.file}: {problem} lacks {', '.join(missing(found, answers[problem]))}")
        absent = [problem for problem, found in of.digits.items() if not found]
        if absent:
            print(f"- {of.file}: not entered: {', '.join(absent)}")


def print_csv(scores, answers):
    """The least digits of each entry in each problem, how many quantities it lacks, and what it costs."""
    table = csv.writer(sys.stdout, lineterminator='\n')
    table.writerow(['entry', 'problem', 'digits', 'lacks', *COSTS])
    for of in scores:
        for problem, found in of.digits.items():
            if found:
                least, lacks = f'{min(found.values()):.2f}', len(missing(found, answers[problem]))
                costs = [getattr(of, column).get(problem, '') for column in COSTS]
                table.writerow([pathlib.Path(of.file).stem, problem, least, lacks, *costs])


def main(files):
    is_csv = files[:1] == ['--csv']
    files = files[is_csv:]
    if not files:
        raise Refused(f"needs: ENTRY.csv..., with the columns {', '.join(NEEDED)}, and perhaps {' and '.join(COSTS)}")
    answers = {}
    for _, row in rows_of(ANSWERS, NEEDED + ['digits', 'known']):
        answers.setdefault(row['problem'], {})[row['quantity']] = row
    scores = [score(file, answers) for file in files]
    if is_csv:
        return print_csv(scores, answers)
    if len(scores) == 1:
        print_quantities(scores[0].digits, answers)
    print_tables(scores, answers)


if __name__ == '__main__':
    try:
        main(sys.argv[1:])
    except Refused as error:
        sys.exit(f'score.py: {error}')
