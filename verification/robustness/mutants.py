#!/usr/bin/env python3
"""Breaks the program on purpose in many ways, one at a time: the tests must notice each.

The changes are a seeded sample of those in mutants.txt, and a sample of mechanical changes. All are
compiled at once into a copy of the sources, each with a switch in the environment (ROTOR_MUTANT=17), so
that programs started by tests have it too; those that do not compile are left out.
No C++ parser is needed, because the sources are formatted: each change inserts text on its line.

First each test runs without any change and reports which switches it passes. Then, for each change, the
tests that reach it run, short ones first, until one notices. Results are in build/mutants/mutants.csv. The status
is 1 if a change by hand survives; what survives of the others, some of which change nothing, is listed.
"""

import argparse
import concurrent.futures
import csv
import dataclasses
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / 'build' / 'mutants'
TREE, BUILD = WORK / 'tree', WORK / 'build'
WORKERS = os.cpu_count() or 1
NOT_MET = {'verification/report/engine/main.cpp'}  # runs only in a browser
RANDOM_ROTORS = 'RandomRotors.MoveByNewtonsLaws'  # make verify runs it in addition to the tests
MORE = 1.5  # times as many mechanical changes are tried as are asked for: some do not compile

SWITCHES = '''#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <unistd.h>
#include <utility>
namespace rotor {
namespace switches {
inline constinit int active = -1;  // until the environment has been looked at
inline constinit char reached[COUNT + 1] = {};
inline void tell_reached() {
  const std::string name = std::string(std::getenv("ROTOR_REACHED")) + '/' + std::to_string(::getpid());
  if (std::FILE* file = std::fopen(name.c_str(), "a")) {
    for (int n = 1; n <= COUNT; ++n)
      if (reached[n]) std::fprintf(file, "%d\\n", n);
    std::fclose(file);
  }
}
inline void look() {
  const char* const number = std::getenv("ROTOR_MUTANT");
  active = number ? std::atoi(number) : 0;
  if (std::getenv("ROTOR_REACHED")) std::atexit(tell_reached);
}
}  // namespace switches
/// Whether a wrong change is to be made.
[[gnu::always_inline]] inline bool mutant(int number) {
  if (switches::active < 0) switches::look();
  switches::reached[number] = 1;
  return switches::active == number;
}
/// A value, so that right and wrong have one type: what Eigen would defer is evaluated.
template <class T>
auto plain(T&& value) {
  if constexpr (requires { typename std::decay_t<T>::PlainObject; value.eval(); })
    return typename std::decay_t<T>::PlainObject(value);
  else
    return std::decay_t<T>(std::forward<T>(value));
}
template <int N, class T>
T instead(T right, T wrong) {
  return mutant(N) ? wrong : right;
}
/// a + Switch<17>() + b, in which the operator is the opposite one if the switch is on.
template <int N>
struct Switch {};
template <int N, class A>
struct Left {
  A&& a;
};
#define ROTOR_SWITCHED(op, opposite)                                        \\
  template <int N, class A>                                                 \\
  Left<N, A> operator op(A&& a, Switch<N>) {                                \\
    return {std::forward<A>(a)};                                            \\
  }                                                                         \\
  template <int N, class A, class B>                                        \\
    requires requires(A a, B b) { a op b, a opposite b; }                   \\
  auto operator op(Left<N, A> left, B&& b) {                                \\
    using T = decltype(plain(left.a op b));                                 \\
    return mutant(N) ? T(plain(left.a opposite b)) : plain(left.a op b);    \\
  }
ROTOR_SWITCHED(+, -) ROTOR_SWITCHED(-, +) ROTOR_SWITCHED(*, /) ROTOR_SWITCHED(/, *)
ROTOR_SWITCHED(<, >=) ROTOR_SWITCHED(>, <=) ROTOR_SWITCHED(<=, >) ROTOR_SWITCHED(>=, <)
ROTOR_SWITCHED(==, !=) ROTOR_SWITCHED(!=, ==)
}  // namespace rotor
'''
OPPOSITE = {'+': '-', '-': '+', '*': '/', '/': '*', '<': '>=', '>': '<=', '<=': '>', '>=': '<',
            '==': '!=', '!=': '=='}


@dataclasses.dataclass
class Change:
    """A wrong change: inserts (place, length of what is replaced, text), in whose texts # is its number."""
    file: str
    line: int
    kind: str
    what: str  # the line, and how it is changed
    edits: list
    number: int = 0


# ---- changes

def masked(text):
    """The text with blanks for comments, texts, the preprocessor's lines and concepts."""
    return re.sub(r'\bconcept\b[^;{]*(?:;|\{.*?^\};)|//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*',
                  lambda m: re.sub(r'[^\n]', ' ', m[0]), text, flags=re.DOTALL | re.MULTILINE)


def mechanical(file):
    """All changes of a file that can be made without thinking."""
    text = (ROOT / file).read_text()
    code = masked(text)

    def change(kind, at, end, wrong, *edits):
        line = text.count('\n', 0, at) + 1
        begin = text.rfind('\n', 0, at) + 1
        stop = text.find('\n', end)
        original, changed = text[begin:stop], text[begin:at] + wrong + text[end:stop]
        return Change(file, line, kind, f'{" ".join(original.split())}  ->  {" ".join(changed.split())}', list(edits))

    for m in re.finditer(r'(?<=[\w)\]}] )([-+*/]|[<>]=?|[=!]=)(?=[ \n])', code):
        yield change('operator', m.start(), m.end(), OPPOSITE[m[0]],
                     (m.end(), 0, f' ::rotor::Switch<#>() {m[0]}'))
    for m in re.finditer(r' (&&|\|\|)(?=[ \n])', code):  # the right operand is never, or always true
        wrong = ' && !::rotor::mutant(#)' if m[1] == '&&' else ' || ::rotor::mutant(#)'
        yield change('logic', m.start(), m.start(), ' && false' if m[1] == '&&' else ' || true', (m.start(), 0, wrong))
    for m in re.finditer(r"(?<![\w.'])\d[\d.']*(e[-+]?\d+)?(?![\w.'])", code):
        number = m[0]
        if '.' in number or m[1]:
            wrong = f'(1.5 * {number})'
        else:
            value = int(number.replace("'", ''))
            wrong = str(1 if value == 0 else value - 1 if value < 10 else value // 2)
        yield change('constant', m.start(), m.end(), wrong,
                     (m.start(), len(number), f'::rotor::instead<#>({number}, {wrong})'))
    for m in re.finditer(r'(?<=[;{}]\n)( +)(?!return|throw|delete)[\w:.>\[\]-]+(\(.*\)| [-+*/]?= .*);$', code, re.MULTILINE):
        yield change('statement', m.end(1), m.end(), '', (m.end(1), 0, 'if (!::rotor::mutant(#)) '))
    for m in re.finditer(r'\b(?:if|while) \((.*)$', code, re.MULTILINE):
        depth, end = 1, m.start(1)
        while depth and end < m.end():
            depth += {'(': 1, ')': -1}.get(code[end], 0)
            end += 1
        if not depth:
            yield change('condition', m.start(1), end - 1, f'!({text[m.start(1):end - 1]})',
                         (m.start(1), 0, '::rotor::mutant(#) != static_cast<bool>('), (end - 1, 0, ')'))
    for m in re.finditer(r'(?<![\w>]) ([\w:.]+)\((\w[\w.]*), (\w[\w.]*)\)', code):
        if m[2] != m[3] and m[1].split('::')[-1] not in {'min', 'max', 'hypot'}:
            yield change('arguments', m.start(1), m.end(), f'{m[1]}({m[3]}, {m[2]})',
                         (m.start(1), 0, f'(::rotor::mutant(#) ? {m[1]}({m[3]}, {m[2]}) : '), (m.end(), 0, ')'))


def by_hand():
    """The changes of mutants.txt: each replaces a whole expression, or a whole statement."""
    for row in (HERE / 'mutants.txt').read_text().splitlines():
        if not row or row.startswith('#'):
            continue
        file, old, new, what = (cell.strip() for cell in row.split(' @ '))
        text = (ROOT / file).read_text()
        at = text.find(old)
        if at < 0:
            sys.exit(f'{file}: there is no "{old}"; mutants.txt is out of date')
        behind = ('if (::rotor::mutant(#)) {' + new + '} else ', '') if old.endswith(';') else \
            (f'(::rotor::mutant(#) ? ::rotor::plain({new}) : ::rotor::plain(', '))')
        yield Change(file, text.count('\n', 0, at) + 1, 'by hand', f'{what}: {old}  ->  {new or "(nothing)"}',
                     [(at, 0, behind[0]), (at + len(old), 0, behind[1])])


def sample(seed, count, folders):
    """Mechanical changes, of each file as many as its share of all."""
    paths = sorted({path for folder in folders for path in (ROOT / folder).rglob('*.?pp')})
    files = [str(path.relative_to(ROOT)) for path in paths]
    changes = [change for file in files if file not in NOT_MET for change in mechanical(file)]
    random.Random(seed).shuffle(changes)
    return changes[:count]


# ---- the build

def copy(changes):
    """A copy of the sources, into which the changes can be put."""
    for number, change in enumerate(changes, 1):
        change.number = number
    shutil.rmtree(TREE, ignore_errors=True)
    shutil.copytree(ROOT, TREE, symlinks=True, ignore=lambda folder, names: {
        name for name in names if name == '.git' or name == 'build' and pathlib.Path(folder) == ROOT})
    (WORK / 'switches.hpp').write_text(SWITCHES.replace('COUNT', str(len(changes))))


def check(hand):
    """Compiles the changes by hand: each must be of a whole expression, or a whole statement."""
    copy(hand)
    put = {change.file for change in write_switched(hand)}
    (TREE / 'headers.cpp').write_text(''.join(f'#include "{file}"\n' for file in put if file.endswith('.hpp')))
    macros = {f'-D{name}=""' for name in re.findall(r'\b(ROTOR_[A-Z_]+)="', (ROOT / 'CMakeLists.txt').read_text())}
    command = ['c++', '-std=c++20', '-w', '-fsyntax-only', '-isystem', '/usr/include/eigen3', f'-I{TREE}', *macros]
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        sources = ['headers.cpp', *(file for file in put if file.endswith('.cpp'))]
        failed = [done.returncode for done in pool.map(
            lambda file: subprocess.run([*command, TREE / file], check=False), sources)]
    return 1 if any(failed) else 0


def write_switched(changes):
    """Puts the changes into the copy, and no others. Of two that meet, the first is put."""
    put, edits = [], {}
    for change in changes:
        spans = [(at, at + length) for at, length, _ in change.edits]
        own = edits.setdefault(change.file, [])
        if all(end < a or at > b for at, end in spans for a, b, _ in own):
            own += [(at, at + length, text.replace('#', str(change.number))) for at, length, text in change.edits]
            put.append(change)
    for path in [path for folder in ('model', 'figures', 'verification') for path in TREE.glob(f'{folder}/**/*.?pp')]:
        file = str(path.relative_to(TREE))
        text = (ROOT / file).read_text()
        for at, end, inserted in sorted(edits.get(file, []), reverse=True):
            text = text[:at] + inserted + text[end:]
        if file in edits:  # a constant that the compiler evaluates could not be switched
            text = '\n'.join(re.sub(r'\bconstexpr\b(?=[^()]*=)', 'const', line) if '::rotor::instead<' in line or
                             'Switch<' in line else line for line in text.split('\n'))
            text = f'#include "{WORK}/switches.hpp"\n#line 1\n{text}'
        if path.read_text() != text:
            path.write_text(text)
    return put


def units():
    """How the compiler is called for each source."""
    for unit in json.loads((BUILD / 'compile_commands.json').read_text()):
        if not re.search('cmake_pch', unit['file']):
            command = re.sub(r'-Winvalid-pch|-include \S*cmake_pch.hxx', '', unit['command'])
            yield shlex.split(re.sub(r' -o \S+ -c ', ' -fsyntax-only -c ', command))


def blamed(changes, errors):
    """The changes that the compiler means: where an error is, or else where it comes from."""
    wrong, mentioned = [], []
    for line in errors.splitlines():
        if match := re.search(rf'{re.escape(str(TREE))}/([^:]+):(\d+):', line):
            mentioned += [c for c in changes if (c.file, c.line) == (match[1], int(match[2]))]
        mentioned += [c for c in changes if f'[with int N = {c.number};' in line]  # in a constant of several lines
        if 'error:' in line:
            wrong, mentioned = wrong + mentioned, []
    return wrong


def without_errors(changes, pool):
    """The changes that compile, in the copy; of those by hand all must."""
    waiting = list(units())
    while True:
        changes = write_switched(changes)
        outputs = list(pool.map(lambda unit: subprocess.run(
            unit, cwd=BUILD, stderr=subprocess.PIPE, text=True, check=False), waiting))
        waiting = [unit for unit, output in zip(waiting, outputs) if output.returncode]
        if not waiting:
            return changes
        errors = '\n'.join(output.stderr for output in outputs if output.returncode)
        (WORK / 'errors.log').write_text(errors)
        wrong = {c.number for c in blamed(changes, errors) if c.kind != 'by hand'}
        if not wrong:
            sys.exit(f'The changes do not compile; see {WORK}/errors.log')
        changes = [c for c in changes if c.number not in wrong]


def call(command, what):
    """Runs a command that has to succeed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit(f'{done.stdout[-4000:]}\n{what} fails.')


def build(hand, candidates, count):
    """Builds all tests with all changes in them; the changes that are."""
    changes = hand + candidates
    copy(changes)
    call(['cmake', '-S', TREE, '-B', BUILD, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=None',
          '-DCMAKE_CXX_FLAGS=-O1 -w -fno-diagnostics-show-caret', '-DROTOR_WARNINGS_AS_ERRORS=OFF',
          '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'], 'CMake')
    call(['cmake', '--build', BUILD, '--target', 'describe'], 'Writing the version')  # which units() compiles
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        changes = without_errors(changes, pool)
    call(['cmake', '--build', BUILD, '--target', 'verification', 'rotor', 'random-rotors'], 'The build')
    write_switched([])  # tests look at the sources, too
    kept = [change for change in changes if change.kind != 'by hand'][:count]
    return [change for change in changes if change.kind == 'by hand'] + kept


# ---- the tests

class Tests:
    """The tests of the build, how long each takes and which changes it reaches."""

    def __init__(self, pool):
        listed = subprocess.run([BUILD / 'verification', '--gtest_list_tests'], text=True, check=True,
                                stdout=subprocess.PIPE).stdout
        self.seconds, self.reached, suite = {}, {}, ''
        names = [RANDOM_ROTORS]
        for line in listed.splitlines()[1:]:
            name = line.split('#')[0].strip()
            if line.startswith(' '):
                names.append(suite + name)
            else:
                suite = name
        for name, failed, seconds, reached in pool.map(self._look_at, names):
            if failed:
                sys.exit(f'{name} fails without any change.')
            self.seconds[name], self.reached[name] = seconds, reached
        self.names = sorted(names, key=self.seconds.get)

    def _look_at(self, name):
        with tempfile.TemporaryDirectory(dir=WORK) as folder:
            start = time.monotonic()
            failed = self.failed(name, 0, 600, folder)
            reached = {int(number) for file in pathlib.Path(folder).iterdir() for number in file.read_text().split()}
        return name, failed, time.monotonic() - start, reached

    def failed(self, name, number, limit_s, reached=''):
        """Whether a test fails, crashes, or is not over in time."""
        with tempfile.TemporaryDirectory(dir=WORK) as folder:
            environment = {**os.environ, 'LC_ALL': 'C', 'ROTOR_MUTANT': str(number), 'TMPDIR': folder}
            if reached:
                environment['ROTOR_REACHED'] = reached
            command = [BUILD / 'random-rotors', '200', folder] if name == RANDOM_ROTORS else \
                [BUILD / 'verification', '--gtest_filter=' + name, '--gtest_fail_fast']
            process = subprocess.Popen(command, env=environment, cwd=folder, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            try:
                status = process.wait(limit_s)
            except subprocess.TimeoutExpired:
                status = -1
            try:
                os.killpg(process.pid, signal.SIGKILL)  # and all that it has started
            except ProcessLookupError:
                pass
            process.wait()
        return status != 0

    def noticed(self, change):
        """The first test that notices a change, of those that reach it."""
        for name in self.names:
            if change.number in self.reached[name] and self.failed(name, change.number, 20 + 5 * self.seconds[name]):
                return name
        return ''


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--seed', type=int, default=1, help='of both samples')
    parser.add_argument('--hand', type=int, default=50, help='of changes by hand')
    parser.add_argument('--count', type=int, default=100, help='of mechanical changes')
    parser.add_argument('--under', default='', help='folders of the mechanical changes: model figures')
    parser.add_argument('--check', action='store_true', help='only whether those by hand compile')
    options = parser.parse_args()
    for folder in options.under.split():
        if not (ROOT / folder).is_dir():
            parser.error(f'UNDER={folder}: must be a folder, such as model or figures/input')

    start = time.monotonic()
    hand = list(by_hand())
    WORK.mkdir(parents=True, exist_ok=True)
    if options.check:
        return check(hand)
    hand = random.Random(options.seed).sample(hand, min(options.hand, len(hand)))
    folders = options.under.split() or ['model', 'figures', 'verification/report/engine']
    changes = build(hand, sample(options.seed, round(MORE * options.count), folders), options.count)
    print(f'built with {len(changes)} changes after {time.monotonic() - start:.0f} s', flush=True)
    limits = {resource.RLIMIT_AS: 4 << 30, resource.RLIMIT_FSIZE: 1 << 30, resource.RLIMIT_CORE: 0}
    for limit, most in limits.items():  # a change may ask for more than there is
        resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
    survivors = []
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool, \
            open(WORK / 'mutants.csv', 'w', newline='', encoding='utf-8') as file:
        tests = Tests(pool)
        table = csv.writer(file)
        table.writerow(['file', 'line', 'kind', 'change', 'noticed_by'])
        for change, noticed in zip(changes, pool.map(tests.noticed, changes)):
            table.writerow([change.file, change.line, change.kind, change.what, noticed])
            file.flush()
            if not noticed:
                survivors.append(change)
                reach = sum(change.number in reached for reached in tests.reached.values())
                print(f'NOT CAUGHT {change.file}:{change.line}: {change.kind} ({reach} tests reach it)\n'
                      f'    {change.what}', flush=True)
    for kind in ('by hand', 'mechanical'):
        of_kind = [c for c in changes if (c.kind == 'by hand') == (kind == 'by hand')]
        if of_kind:
            share = 1 - sum(c in survivors for c in of_kind) / len(of_kind)
            error = (share * (1 - share) / len(of_kind)) ** 0.5
            print(f'{kind}: {len(of_kind)} changes, {100 * share:.1f} % caught (standard error {100 * error:.1f} %)')
    print(f'It took {(time.monotonic() - start) / 60:.1f} min; {WORK / "mutants.csv"} has all changes.')
    return 1 if any(c.kind == 'by hand' for c in survivors) else 0


if __name__ == '__main__':
    sys.exit(main())
