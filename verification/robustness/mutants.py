#!/usr/bin/env python3
"""Breaks the program on purpose in many ways, one at a time: the tests must notice each.

The changes are a seeded sample of those of mutants.txt, and one of what can be changed mechanically in
model/ and figures/. All are compiled at once into a copy of the sources, each behind a switch that the
environment turns on (ROTOR_MUTANT=17), so that programs which tests start have it too. What is read at
run time (scenes, gnuplot scripts, texts) is replaced in the copy for a run, one file at a time.

First each test runs without any change and tells which switches it passes, and how long it takes. Then,
for each change, the tests that reach it run, short ones first, until one notices. Results are in
build/mutants/mutants.csv. The status is 1 if a change survives that equivalent.txt does not have.
"""

import argparse
import collections
import concurrent.futures
import csv
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

from switches import Change, Source, Unswitchable, switched

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / 'build' / 'mutants'
TREE, BUILD = WORK / 'tree', WORK / 'build'
WORKERS = os.cpu_count() or 1
SOURCES = {'.hpp', '.ipp', '.cpp'}
NOT_MET = {'figures/explore/main.cpp', 'figures/sweep/ranks.cpp'}  # only in a browser, or under mpirun
RANDOM_ROTORS = 'RandomRotors.KeepTheirBalances'  # what make verify runs beside the tests
LIKELY_S = 2  # tests that are quicker may be asked first
MORE = 1.5  # times as many mechanical changes are tried as are asked for: some do not compile

SWITCHES = r'''#pragma once
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
      if (reached[n]) std::fprintf(file, "%d\n", n);
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
/// The same in functions that the compiler may call: there none is.
[[gnu::always_inline]] constexpr bool constexpr_mutant(int number) {
  if (std::is_constant_evaluated()) return false;
  return mutant(number);
}
/// A value, so that right and wrong have one type: what Eigen would put off is worked out.
template <class T>
constexpr auto plain(T&& value) {
  if constexpr (requires { typename std::decay_t<T>::PlainObject; value.eval(); })
    return typename std::decay_t<T>::PlainObject(value);
  else
    return std::decay_t<T>(std::forward<T>(value));
}
}  // namespace rotor
'''


# ---- changes

def lines_of(name):
    """The cells of a list whose columns are parted by @."""
    for line in (HERE / name).read_text().splitlines():
        if line.strip() and not line.startswith('#'):
            yield [cell.strip() for cell in line.split(' @ ' if ' @ ' in line else '@', 3)]


def by_hand():
    """The changes of mutants.txt."""
    for file, old, new, what in lines_of('mutants.txt'):
        text = (ROOT / file).read_text()
        at = text.find(old)
        if at < 0:
            sys.exit(f'{file}: there is no "{old}"; mutants.txt is out of date')
        if pathlib.Path(file).suffix in SOURCES:
            try:
                yield Source(file, text).replacement(old, new, what)
            except Unswitchable as reason:
                sys.exit(f'{file}: "{old}" cannot be put behind a switch: {reason}')
        else:
            yield Change(file, text.count('\n', 0, at) + 1, 'by hand', old, new, what,
                         whole_file=text.replace(old, new, 1))


def sample(seed, count):
    """Mechanical changes, half of them where motions become what a reader sees."""
    outer, inner = [], []
    for folder in ('model', 'figures'):
        for path in sorted((ROOT / folder).rglob('*')):
            file = str(path.relative_to(ROOT))
            if path.suffix in SOURCES and file not in NOT_MET:
                is_outer = file.startswith(('figures/', 'model/simulation/'))
                (outer if is_outer else inner).extend(Source(file, path.read_text()).mechanical())
    chance = random.Random(seed)
    for changes in (outer, inner):
        chance.shuffle(changes)
    pairs = [change for pair in zip(outer, inner) for change in pair]
    return pairs[:count]


def equivalents():
    """Changes that change nothing, with the reason."""
    return {(file, original, changed): reason for file, original, changed, reason in lines_of('equivalent.txt')}


# ---- the build

def copy_tree():
    shutil.rmtree(TREE, ignore_errors=True)
    shutil.copytree(ROOT, TREE, symlinks=True, ignore=lambda folder, names: {
        name for name in names if name == '.git' or name == 'build' and pathlib.Path(folder) == ROOT})


def write_switched(changes):
    """Puts the changes into the copy, and no others."""
    of_file = collections.defaultdict(list)
    for change in changes:
        of_file[change.file].append(change)
    for file, own in of_file.items():
        text = switched((ROOT / file).read_text(), own)
        write_if_new(TREE / file, f'#include "{WORK}/switches.hpp"\n#line 1\n{text}')
    for path in [*TREE.glob('model/**/*'), *TREE.glob('figures/**/*')]:
        file = str(path.relative_to(TREE))
        if path.suffix in SOURCES and file not in of_file:
            write_if_new(path, (ROOT / file).read_text())


def write_if_new(path, text):
    if path.read_text() != text:
        path.write_text(text)


def call(command, what):
    """Runs a command that has to succeed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit(f'{done.stdout[-4000:]}\n{what} fails.')


def units():
    """How the compiler is called for each source of model/ and figures/."""
    for unit in json.loads((BUILD / 'compile_commands.json').read_text()):
        if re.search(r'/tree/(model|figures)/(?!.*extended/event_method)', unit['file']):
            yield unit['file'], shlex.split(re.sub(r' -o \S+ -c ', ' -fsyntax-only -c ', unit['command']))


def without_errors(changes, pool):
    """The changes that compile, in the copy; of those by hand all must."""
    waiting = list(units())
    while waiting:
        write_switched(changes)
        outputs = list(pool.map(lambda unit: subprocess.run(
            unit[1], cwd=BUILD, stderr=subprocess.PIPE, text=True, check=False), waiting))
        waiting = [unit for unit, output in zip(waiting, outputs) if output.returncode]
        wrong = {id(change) for output in outputs if output.returncode
                 for change in blamed(changes, output.stderr)}
        (WORK / 'errors.log').write_text(''.join(output.stderr for output in outputs))
        if waiting and not wrong:
            sys.exit(f'The changes do not compile; see {WORK}/errors.log')
        left = [change for change in changes if id(change) not in wrong or change.kind == 'by hand']
        if waiting and len(left) == len(changes):  # an error of a mechanical one may name others, too
            sys.exit('\n'.join(f'{c.file}: does not compile: {c.summary()}' for c in changes if id(c) in wrong))
        changes = left
    return changes


def blamed(changes, errors):
    """The changes that the compiler means: where its errors are, or else where it has come from."""
    for kind in 'error|note: .*declared', ' required|note':
        places = {(match[1], int(match[2])) for match in re.finditer(
            rf'{re.escape(str(TREE))}/(\S+?):(\d+):\d+: *(?:{kind})', errors)}
        found = [change for file, line in places for change in at_line(changes, file, line)]
        if found:
            return found
    return []


def at_line(changes, file, line):
    """The mechanical changes that the compiler may mean by an error there, or else one by hand."""
    covering = [c for c in changes if c.file == file and c.first_line <= line <= c.last_line]
    mechanical = [c for c in covering if c.kind != 'by hand']
    shortest = min((c.last_line - c.first_line for c in mechanical), default=0)
    if not mechanical:
        return covering
    return [c for c in mechanical if c.last_line - c.first_line <= max(shortest, 2)]


def build(hand, mechanical, count):
    """Builds all tests with all changes in them; the changes that are, with their numbers."""
    changes = [change for change in hand if not change.whole_file] + mechanical
    for number, change in enumerate(changes, 1):
        change.number = number
    copy_tree()
    write_if_new_header(len(changes))
    call(['cmake', '-S', TREE, '-B', BUILD, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=None',
          '-DCMAKE_CXX_FLAGS=-O1 -w -Wno-narrowing -fno-diagnostics-show-caret', '-DROTOR_WARNINGS_AS_ERRORS=OFF',
          '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'], 'CMake')
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        changes = without_errors(changes, pool)
    call(['cmake', '--build', BUILD, '--target', 'verification', 'rotor', 'stress'], 'The build')
    write_switched([])  # tests look at the sources, too
    kept = [change for change in changes if change.kind != 'by hand'][:count]
    return [change for change in changes if change.kind == 'by hand'] + kept


def write_if_new_header(count):
    header = WORK / 'switches.hpp'
    header.touch()
    write_if_new(header, SWITCHES.replace('COUNT', str(count)))


# ---- the tests

class Tests:
    """The tests of the build, how long each takes and which changes it reaches."""

    def __init__(self, thorough):
        self.fast = [] if thorough else ['--gtest_fail_fast']
        listed = subprocess.run([BUILD / 'verification', '--gtest_list_tests'], text=True, check=True,
                                stdout=subprocess.PIPE).stdout
        self.names, suite = [RANDOM_ROTORS], ''
        for line in listed.splitlines():
            name = line.split('#')[0].strip()
            if not line.startswith(' '):
                suite = name
            elif suite:
                self.names.append(suite + name)
        self.seconds = {}
        self.reached = {}

    def look(self, pool):
        """Runs each without any change."""
        for name, failed, seconds, reached in pool.map(self._look_at, self.names):
            if failed:
                sys.exit(f'{name} fails without any change.')
            self.seconds[name], self.reached[name] = seconds, reached
        self.names.sort(key=self.seconds.get)

    def _look_at(self, name):
        with tempfile.TemporaryDirectory(dir=WORK) as folder:
            start = time.monotonic()
            failed = self.run([name], 0, 600, folder)
            seconds = time.monotonic() - start
            reached = {int(number) for file in pathlib.Path(folder).iterdir() for number in file.read_text().split()}
        return name, failed, seconds, reached

    def run(self, names, number, limit_s, reached=''):
        """The tests that fail; those that are not over in time, or crash, do."""
        if RANDOM_ROTORS in names and len(names) > 1:
            others = [name for name in names if name != RANDOM_ROTORS]
            return self.run(others, number, limit_s) + self.run([RANDOM_ROTORS], number, limit_s)
        with tempfile.TemporaryDirectory(dir=WORK) as folder:
            environment = {**os.environ, 'RC_PARAMS': 'seed=1', 'ROTOR_MUTANT': str(number), 'TMPDIR': folder}
            if reached:
                environment['ROTOR_REACHED'] = reached
            command = [BUILD / 'stress', 'rotors', '300', folder] if names == [RANDOM_ROTORS] else \
                [BUILD / 'verification', '--gtest_filter=' + ':'.join(names), *self.fast]
            with open(os.path.join(folder, 'output'), 'w+', encoding='utf-8', errors='replace') as output:
                status = run_limited(command, environment, folder, output, limit_s)
                output.seek(0)
                text = output.read()
        if status == 0:
            return []
        failed = re.findall(r'^\[  FAILED  \] (\S+?)(?:, where .*)? \(\d+ ms\)$', text, re.MULTILINE)
        begun = re.findall(r'^\[ RUN      \] (\S+)$', text, re.MULTILINE)
        ended = re.findall(r'^\[  (?:     OK|FAILED |SKIPPED) \] (\S+?)(?:,| )', text, re.MULTILINE)
        lost = [name for name in begun if name not in ended]
        return failed + lost or names[:1]

    def batches(self, names):
        """The tests in the order of their times, in groups that each take as long as all before."""
        batch, so_far, own = [], 0.5, 0
        for name in (n for n in self.names if n in names):
            batch.append(name)
            own += self.seconds[name]
            if own >= so_far:
                yield batch
                so_far, batch, own = so_far + own, [], 0
        if batch:
            yield batch

    def limit_s(self, names):
        return 20 + 5 * sum(self.seconds[name] for name in names)


def run_limited(command, environment, folder, output, limit_s):
    """The status of a command, which is ended with all that it has started when its time is over."""
    process = subprocess.Popen(command, env=environment, cwd=folder, stdin=subprocess.DEVNULL, stdout=output,
                               stderr=subprocess.STDOUT, start_new_session=True)
    try:
        return process.wait(limit_s)
    except subprocess.TimeoutExpired:
        return -1
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()


# ---- the run

class Run:
    """What becomes of the changes."""

    def __init__(self, changes, tests, thorough):
        self.changes, self.tests, self.thorough = changes, tests, thorough
        self.known = equivalents()
        self.caught_by = {}             # of a change's id
        self.noticed = collections.defaultdict(collections.Counter)  # by each test, of a kind of change
        self.idle = set(tests.names)    # tests that have noticed nothing
        self.start = time.monotonic()

    def all(self, pool):
        switches = [change for change in self.changes if not change.whole_file]
        for change, failed in zip(switches, pool.map(self._switch, switches)):
            self._note(change, failed)
        for change in self.changes:
            if change.whole_file:
                self._note(change, self._replace(change, pool))

    def _until_caught(self, change, names, run):
        """First come tests that bear the file's name (Fig04), and those that noticed such changes."""
        path = pathlib.Path(change.file)
        noticed = self.noticed[change.file if change.number else path.suffix]
        likely = {name for name, _ in noticed.most_common(20)}
        likely |= {name for name in names if '/' + path.stem.capitalize() in name}
        likely = [name for name in self.tests.names  # in the order of their times
                  if name in likely & names and self.tests.seconds[name] < LIKELY_S]
        caught = []
        for batch in [*([likely] if likely else []), *self.tests.batches(names.difference(likely))]:
            caught += run(batch)
            if caught and not self.thorough:
                break
        noticed.update(caught)
        return caught

    def _switch(self, change):
        if self._is_known(change):
            return []  # whatever is run
        reaching = {name for name in self.tests.names if change.number in self.tests.reached[name]}
        return self._until_caught(change, reaching, lambda batch: self.tests.run(
            batch, change.number, self.tests.limit_s(batch)))

    def _replace(self, change, pool):
        """Alone in the copy, with all tests, dealt to all workers."""
        path = TREE / change.file
        path.write_text(change.whole_file)
        def run(batch):
            parts = [batch[n::WORKERS] for n in range(WORKERS) if batch[n::WORKERS]]
            return sum(pool.map(lambda part: self.tests.run(part, 0, self.tests.limit_s(part)), parts), [])
        caught = self._until_caught(change, set(self.tests.names), run)
        shutil.copy2(ROOT / change.file, path)
        return caught

    def _note(self, change, failed):
        self.caught_by[id(change)] = failed
        self.idle -= set(failed)
        if self.verdict(change) == 'survives':
            reach = sum(change.number in reached for reached in self.tests.reached.values())
            reached = '' if change.whole_file else f' ({reach} tests reach it)' if reach else ' (no test reaches it)'
            print(f'\rNOT CAUGHT {change.file}:{change.line}: {change.what or change.kind}{reached}\n'
                  f'    {change.summary()}', flush=True)
        if sys.stderr.isatty():
            done, all_of_them = len(self.caught_by), len(self.changes)
            rest = (time.monotonic() - self.start) / done * (all_of_them - done)
            print(f'\r{done} of {all_of_them}, {len(self.survivors())} survive; about {rest / 60:.0f} min to go   ',
                  end='' if done < all_of_them else '\n', file=sys.stderr, flush=True)

    def verdict(self, change):
        if self.caught_by[id(change)]:
            return 'caught'
        return 'equivalent' if self._is_known(change) else 'survives'

    def _is_known(self, change):
        return (change.file, change.original, change.changed) in self.known

    def judged(self):
        return [c for c in self.changes if id(c) in self.caught_by]

    def survivors(self):
        return [c for c in self.judged() if self.verdict(c) == 'survives']

    def write(self, path):
        with open(path, 'w', newline='', encoding='utf-8') as file:
            table = csv.writer(file)
            table.writerow(['number', 'file', 'line', 'kind', 'original', 'changed', 'what', 'verdict', 'caught_by'])
            for c in sorted(self.judged(), key=lambda c: self.verdict(c) != 'survives'):
                table.writerow([c.number, c.file, c.line, c.kind, c.original, c.changed, c.what, self.verdict(c),
                                ' '.join(self.caught_by[id(c)])])

    def report(self):
        for kind in ('by hand', 'mechanical'):
            own = [c for c in self.judged() if (c.kind == 'by hand') == (kind == 'by hand')]
            count = collections.Counter(self.verdict(c) for c in own)
            counted = len(own) - count['equivalent']
            print(f'{kind}: {len(own)} changes judged, {count["equivalent"]} of them equivalent, {count["caught"]} caught, '
                  f'{count["survives"]} survive' + (f': {100 * count["caught"] / counted:.1f} %' if counted else ''))
        in_outer = sum(c.file.startswith(('figures/', 'model/simulation/')) for c in self.judged())
        print(f'{in_outer} of {len(self.judged())} are in figures/ and model/simulation/.')
        if not self.thorough:
            print('Which tests notice nothing, only --thorough can tell: here a change that one has noticed '
                  'does not meet the slower ones.')
            return
        print(f'{len(self.idle)} of the {len(self.tests.names)} tests noticed none of the changes:')
        for name in sorted(self.idle):
            print(f'  {name}')


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--seed', type=int, default=1, help='of both samples')
    parser.add_argument('--hand', type=int, default=50, help='of changes by hand')
    parser.add_argument('--count', type=int, default=100, help='of mechanical changes')
    parser.add_argument('--only', default='', help='only changes in files whose path fits this expression')
    parser.add_argument('--check', action='store_true', help='only whether those by hand can be made')
    parser.add_argument('--thorough', action='store_true', help='run all tests that reach a change')
    options = parser.parse_args()

    start = time.monotonic()
    hand = list(by_hand())
    if options.check:
        return 0
    hand = random.Random(options.seed).sample(hand, min(options.hand, len(hand)))
    WORK.mkdir(parents=True, exist_ok=True)
    candidates = sample(options.seed, round(MORE * options.count))
    changes = build(hand, candidates, options.count)
    changes = [c for c in changes + [c for c in hand if c.whole_file] if re.search(options.only, c.file)]
    print(f'built with {len(changes)} changes after {time.monotonic() - start:.0f} s', file=sys.stderr)

    limits = {resource.RLIMIT_AS: 4 << 30, resource.RLIMIT_FSIZE: 1 << 30, resource.RLIMIT_CORE: 0}
    for limit, most in limits.items():  # a change may ask for more than there is
        resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
    tests = Tests(options.thorough)
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        tests.look(pool)
        print(f'{len(tests.names)} tests take {sum(tests.seconds.values()):.0f} s on one processor', file=sys.stderr)
        run = Run(changes, tests, options.thorough)
    is_whole = True
    try:
        with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
            run.all(pool)
    except KeyboardInterrupt:
        is_whole = False
        print(f'\nInterrupted: {len(changes) - len(run.judged())} changes are not judged.', file=sys.stderr)
    run.write(WORK / 'mutants.csv')
    run.report()
    print(f'It took {(time.monotonic() - start) / 60:.1f} min; {WORK / "mutants.csv"} has all changes.')
    return 130 if not is_whole else 1 if run.survivors() else 0


if __name__ == '__main__':
    sys.exit(main())
