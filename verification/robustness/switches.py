"""Wrong changes in C++ sources, each put behind a switch: mutation schemata.

A source is taken apart into tokens; no C++ parser is needed, because the sources are formatted: binary
operators have blanks on both sides, brackets of templates none. A change concerns some tokens. What
gets the switch is the smallest whole expression around them, one that ends where evaluation order
cannot be changed by brackets (at commas, semicolons, =, ? and :), or else the statements around them.
"""

import dataclasses
import re

TOKEN = re.compile(
    r'(?P<blank>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*)'
    r'|(?P<text>R"(?P<mark>[^(]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\')'
    r"|(?P<number>(?:\d|\.\d)(?:[eE][+-]|['.\w])*)"
    r'|(?P<name>[A-Za-z_]\w*)'
    r'|(?P<sign><=>|\.\.\.|->\*|<<=|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%|&^]=|.)',
    re.DOTALL | re.MULTILINE)
CLOSING = {'(': ')', '[': ']', '{': '}', '<': '>'}
ENDS_OF_EXPRESSIONS = {',', ';', '?', ':', '=', '+=', '-=', '*=', '/=', '|=', '&=', 'return', 'throw',
                       'case', 'else', 'do'}
DECLARATION = re.compile(r'(const|constexpr|static|auto|using)\b|(?!return|throw|delete|else|case)[\w:]+'
                         r'(<.*?>)?[&*]* \w+( = |[({;])')
LABELS = {'default', 'public', 'private', 'protected'}
COMMUTATIVE = {'min', 'max', 'hypot'}
ASSIGNMENTS = {'=', '+=', '-=', '*=', '/=', '|=', '&='}
CONTROLS = {'if', 'for', 'while', 'switch'}
NO_STATEMENT = CONTROLS | {'return', 'throw', 'case', 'else', 'do', 'using', 'const', 'constexpr', 'auto',
                           'static', 'template', 'friend', 'public', 'private', 'protected', 'default',
                           'break', 'continue', 'static_assert', 'typedef', 'struct', 'class', 'enum'}
OPPOSITE = {'+': '-', '-': '+', '*': '/', '/': '*', '<': '>=', '>': '<=', '<=': '>', '>=': '<',
            '==': '!=', '!=': '==', '&&': '||', '||': '&&'}


class Unswitchable(Exception):
    """A change that cannot be put behind a switch."""


@dataclasses.dataclass
class Change:
    """A wrong change: within a file, the text from start to end is replaced by `wrong`."""
    file: str
    line: int
    kind: str       # "by hand" or what a mechanical one changes
    original: str   # the lines as they stand, in one
    changed: str    # and with the change
    what: str       # is wrong then
    wrong: str = ''  # code that takes the place of what lies between start and end
    start: int = 0
    end: int = 0
    first_line: int = 0
    last_line: int = 0
    is_statement: bool = False
    whole_file: str = ''  # for what is read at run time: the file's wrong content
    constant: tuple = ()  # place of a "constexpr" that must become "const"
    in_constexpr: bool = False  # whether it lies in a function that the compiler may call
    number: int = 0

    def summary(self):
        """In one line."""
        return f'{self.original}  ->  {self.changed or "(nothing)"}'


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    parent: int = -1   # the token of the bracket around it
    partner: int = -1  # of a bracket, the other one
    is_block: bool = False


def one_line(text):
    """Without comments and line breaks, so that lines keep their numbers."""
    return ' '.join(re.sub(r'//[^\n]*', '', text).split())


def common_ends(a, b):
    """How many elements two lists have in common at their beginning, and of the rest at their end."""
    shorter = min(len(a), len(b))
    same = next((n for n in range(shorter) if a[n] != b[n]), shorter)
    return same, next((n for n in range(shorter - same) if a[-1 - n] != b[-1 - n]), shorter - same)


class Source:
    """A C++ source, its tokens and their brackets."""

    def __init__(self, file, text):
        self.file, self.text = file, text
        self.tokens = [Token(m.lastgroup if m.lastgroup != 'mark' else 'text', m.group(), m.start(), m.end())
                       for m in TOKEN.finditer(text) if not m.group('blank')]
        self._match_brackets()

    # ---- tokens

    def _blank_before(self, i):
        return 0 < i < len(self.tokens) and self.tokens[i - 1].end < self.tokens[i].start

    def _text(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ''

    def _opens_template(self, i):
        before = self._text(i - 1)
        return before == 'template' or (not self._blank_before(i) and not self._blank_before(i + 1) and
                                        before != 'operator' and i > 0 and self.tokens[i - 1].kind == 'name')

    def _opens_block(self, i):
        return self._blank_before(i) and self._text(i - 1) not in {'=', ',', '(', 'return', '?', ':'}

    def _match_brackets(self):
        open_ones = []
        for i, token in enumerate(self.tokens):
            text = token.text
            if open_ones and text == CLOSING[self._text(open_ones[-1])]:
                token.partner = open_ones.pop()
                self.tokens[token.partner].partner = i
                token.is_block = self.tokens[token.partner].is_block
            token.parent = open_ones[-1] if open_ones else -1
            if token.kind == 'sign' and (text in '([{' or text == '<' and self._opens_template(i)):
                token.is_block = text == '{' and self._opens_block(i)
                open_ones.append(i)

    def _in_block(self, i):
        parent = self.tokens[i].parent
        return parent < 0 or self.tokens[parent].is_block

    def line(self, position):
        return self.text.count('\n', 0, position) + 1

    # ---- what surrounds tokens

    def _ends_expression(self, i, leftwards, but=frozenset()):
        """Whether an expression beside this token, on the level of both, ends there."""
        token = self.tokens[i]
        if token.text in ENDS_OF_EXPRESSIONS - but or (token.partner >= 0 and token.is_block):
            return True
        if leftwards and token.text == ')':  # if (...) expression;
            before = self._text(token.partner - 1)
            return before in CONTROLS or before == 'constexpr'
        return False

    def _expression(self, first, last):
        """The tokens of the expression around some of one level, or None if they are no part of one."""
        on_level, i = [], first
        while i <= last:
            on_level.append(i)
            i = max(i, self.tokens[i].partner) + 1
        # With a part of it, a whole c ? a : b is changed.
        but = {'?', ':'} if any(self._text(i) in {'?', ':'} for i in on_level) else frozenset()
        if any(self._ends_expression(i, False, but) for i in on_level):
            return None
        level = self.tokens[first].parent
        while first - 1 > level and not self._ends_expression(first - 1, True, but):
            partner = self.tokens[first - 1].partner
            first = partner if 0 <= partner < first - 1 else first - 1
        end = self.tokens[level].partner if level >= 0 else len(self.tokens)
        while last + 1 < end and not self._ends_expression(last + 1, False, but):
            last = max(last + 1, self.tokens[last + 1].partner)
        return first, last

    def _ends_label(self, i):
        """Whether this is the colon of case ...: or default:."""
        k = i - 1 if self._text(i) == ':' else -1
        while k >= 0 and self._text(k) not in {';', '{', '}', '?', 'case', *LABELS}:
            k -= 1
        return self._text(k) in {'case', *LABELS}

    def _statements(self, first, last):
        """The tokens of whole statements around some in a block."""
        level = self.tokens[first].parent
        while first - 1 > level:
            before = self.tokens[first - 1]
            if before.text in {';', 'else', 'do'} or before.partner >= 0 and before.is_block or \
               before.text == ')' and self._ends_expression(first - 1, True) or self._ends_label(first - 1):
                break
            first = before.partner if 0 <= before.partner < first - 1 else first - 1
        while self._text(last) != ';' and not (self.tokens[last].partner >= 0 and self.tokens[last].is_block):
            if last + 1 >= len(self.tokens):
                raise Unswitchable('no statement ends there')
            last = max(last + 1, self.tokens[last + 1].partner)
        return first, last

    def _is_constant(self, first):
        """Whether an expression is evaluated at compile time, as far as its surroundings tell."""
        i = first
        while i >= 0:
            parent = self.tokens[i].parent
            opener, callee = self._text(parent), self._text(parent - 1)
            if opener == '<' or opener == '(' and callee in {'constexpr', 'static_assert', 'requires'}:
                return True
            i = parent if parent >= 0 and not self.tokens[parent].is_block else -1
        return self._text(first - 1) == 'case'

    def _constant_declared(self, first):
        """The "constexpr" of the variable that an expression initialises, if any."""
        i = first
        while i >= 0 and not (self.tokens[i].parent >= 0 and not self.tokens[self.tokens[i].parent].is_block):
            start, _ = self._statements(i, i)
            for k in range(start, i):
                if self._text(k) in {'=', '('}:
                    break
                if self._text(k) == 'constexpr' and self._text(k - 1) != 'if':
                    return self.tokens[k].start, self.tokens[k].end
            return ()
        return self._constant_declared(self.tokens[i].parent) if i >= 0 else ()

    def _in_constexpr_function(self, i):
        while (i := self.tokens[i].parent) >= 0:
            k = i - 1
            while k >= 0 and self._text(k) not in {';', '{', '}'}:
                if self.tokens[i].is_block and self._text(k) == 'constexpr' and self._text(k - 1) != 'if':
                    return True
                k -= 1
        return False

    # ---- changes

    def change(self, first, last, start, end, replacement, kind, what=''):
        """The text from start to end, which lies in the tokens first to last, is replaced."""
        tokens = self.tokens
        while True:
            while tokens[first].parent != tokens[last].parent:  # up to one level
                if tokens[first].parent > tokens[last].parent:
                    first = tokens[first].parent
                else:
                    last = tokens[tokens[last].parent].partner
            first = min(first, tokens[first].partner) if tokens[first].partner >= 0 else first
            last = max(last, tokens[last].partner)
            found = self._expression(first, last)
            callee = self._text(tokens[first].parent - 1)
            is_format = tokens[first].kind == 'text' and callee in {'format', 'print', 'format_to'}
            is_list = found and self._text(found[0]) == '{'
            is_assigned = found and self._text(found[1] + 1) in ASSIGNMENTS
            in_template = self._text(tokens[first].parent) == '<'
            if found and not (is_format or is_list or is_assigned or in_template or
                              self._is_whole_statement(*found)):
                break
            if self._in_block(first):
                found = self._statements(first, last)
                if DECLARATION.match(self.text, tokens[found[0]].start):
                    raise Unswitchable('what it declares would end with its switch')
                break
            parent = tokens[first].parent
            first, last = parent, tokens[parent].partner
        first, last = found
        if self._is_constant(first):
            raise Unswitchable('it is worked out by the compiler')
        begin, stop = tokens[first].start, tokens[last].end
        wrong = self.text[begin:start] + replacement + self.text[end:stop]
        line = self.text.rfind('\n', 0, begin) + 1
        line_end = self.text.find('\n', stop)
        return Change(self.file, self.line(start), kind, one_line(self.text[line:line_end]),
                      one_line(self.text[line:begin] + wrong + self.text[stop:line_end]), what, one_line(wrong),
                      begin, stop, self.line(begin), self.line(stop), self._text(last) == ';' or tokens[last].is_block,
                      constant=self._constant_declared(first), in_constexpr=self._in_constexpr_function(first))

    def _is_whole_statement(self, first, last):
        return self._in_block(first) and self._text(last + 1) == ';' and \
            (first == 0 or self._text(first - 1) not in ENDS_OF_EXPRESSIONS - {';', 'else', 'do'} or
             self._ends_label(first - 1))

    def replacement(self, old, new, what):
        """The change that puts `new` where `old` stands."""
        at = self.text.find(old)
        if at < 0:
            raise Unswitchable(f'there is no "{old}"')
        before = [i for i, t in enumerate(self.tokens) if t.end > at and t.start < at + len(old)]
        after = Source('', new).tokens
        same, same_end = common_ends([self._text(i) for i in before], [t.text for t in after])
        if same + same_end == len(before):  # something is inserted: it goes with what follows, or precedes
            follows = same_end > 0 and not self._ends_expression(before[same], False) and \
                self._text(before[same]) not in {')', '}', ']'}
            same, same_end = (same, same_end - 1) if follows else (same - 1, same_end)
        changed, instead = before[same:len(before) - same_end], after[same:len(after) - same_end]
        text = new[instead[0].start:instead[-1].end] if instead else ''
        return self.change(changed[0], changed[-1], self.tokens[changed[0]].start, self.tokens[changed[-1]].end,
                           text, 'by hand', what)

    def mechanical(self):
        """All changes that can be made without thinking."""
        for i, token in enumerate(self.tokens):
            if self._is_constant(i):
                continue
            for attempt in (self._exchanged_operator, self._changed_constant, self._deleted_statement,
                            self._negated_condition, self._exchanged_arguments):
                try:
                    if change := attempt(i, token):
                        yield change
                except Unswitchable:
                    pass

    def _replaced(self, i, text, kind):
        token = self.tokens[i]
        return self.change(i, i, token.start, token.end, text, kind)

    def _exchanged_operator(self, i, token):
        is_binary = token.kind == 'sign' and self._blank_before(i) and self._blank_before(i + 1)
        if is_binary and token.partner < 0 and token.text in OPPOSITE:
            return self._replaced(i, OPPOSITE[token.text], 'operator')

    def _changed_constant(self, i, token):
        if token.kind != 'number' or self._text(i - 1) == '=' and self._text(i - 2) in {')', 'const', 'override'}:
            return None
        if re.fullmatch(r'\d+', token.text):  # an index stays one
            value = int(token.text)
            return self._replaced(i, str(1 if value == 0 else value - 1 if value < 10 else value // 2), 'constant')
        if '.' not in token.text and 'e' not in token.text:
            return None
        is_zero = not re.search('[1-9]', token.text.split('e')[0])
        return self._replaced(i, '1.' if is_zero else f'(1.5 * {token.text})', 'constant')

    def _deleted_statement(self, i, token):
        starts = i > 0 and self._in_block(i) and (self._text(i - 1) == ';' or self.tokens[i - 1].is_block)
        if not starts or token.kind != 'name' or token.text in NO_STATEMENT:
            return None
        first, last = self._statements(i, i)
        text = self.text[token.start:self.tokens[last].end]
        if self._text(last) != ';' or not re.match(r'[\w.:\[\]>-]+(\(|<.*>\(| [-+*/|&]?= |\+\+;)', text):
            return None
        return self.change(first, last, token.start, self.tokens[last].end, '', 'deleted statement')

    def _negated_condition(self, i, token):
        if token.text != 'if' or self._text(i + 1) != '(':
            return None
        inside = range(i + 2, self.tokens[i + 1].partner)
        if any(self._text(k) in {'=', ';'} and self.tokens[k].parent == i + 1 for k in inside):
            return None
        start, end = self.tokens[inside[0]].start, self.tokens[inside[-1]].end
        return self.change(inside[0], inside[-1], start, end, f'!({self.text[start:end]})', 'negated condition')

    def _exchanged_arguments(self, i, token):
        if token.text != '(' or i < 2 or self.tokens[i - 1].kind != 'name' or self._blank_before(i) or \
           self._text(i - 1) in COMMUTATIVE:
            return None
        commas = [k for k in range(i + 1, token.partner) if self.tokens[k].parent == i and self._text(k) == ',']
        if not commas:
            return None
        end = commas[1] if len(commas) > 1 else token.partner
        first = self.text[self.tokens[i + 1].start:self.tokens[commas[0] - 1].end]
        second = self.text[self.tokens[commas[0] + 1].start:self.tokens[end - 1].end]
        is_declaration = any(re.search(r'(^|[ (<])const |\w[&*] |^\w+ \w+$', a) for a in (first, second)) or \
            self.tokens[i - 2].kind == 'name' and self._text(i - 2) not in ENDS_OF_EXPRESSIONS
        if is_declaration or first == second:
            return None
        return self.change(i + 1, end - 1, self.tokens[i + 1].start, self.tokens[end - 1].end,
                           f'{second}, {first}', 'exchanged arguments')


def switched(text, changes):
    """A source with all changes in it, each behind its switch, on the lines where they were."""
    root = sorted(changes, key=lambda c: (c.start, -c.end, c.number))

    def rewrite(start, end, inner):
        """text[start:end] with the changes inside."""
        result, at = '', start
        while inner:
            begin, stop = inner[0].start, inner[0].end
            here = [c for c in inner if (c.start, c.end) == (begin, stop)]
            below = [c for c in inner if begin <= c.start and c.end <= stop and c not in here]
            inner = [c for c in inner if c not in here and c not in below]
            result += text[at:begin] + wrap(here, rewrite(begin, stop, below))
            at = stop
        return result + text[at:end]

    def wrap(here, right):
        for c in here:
            switch = f'rotor::{"constexpr_mutant" if c.in_constexpr else "mutant"}({c.number})'
            if c.is_statement:
                right = f'{{ if ({switch}) {{ {c.wrong} }} else {{ {right} }} }}'
            elif c.kind == 'negated condition':  # as which other types may stand
                right = f'(static_cast<bool>({right}) != {switch})'
            else:
                right = f'({switch} ? rotor::plain({c.wrong}) : rotor::plain({right}))'
        return right

    result = rewrite(0, len(text), root)
    for start, end in {c.constant for c in changes if c.constant}:
        line = text.count('\n', 0, start)
        lines = result.split('\n')
        lines[line] = re.sub(r'\bstatic constexpr\b', 'inline static const', lines[line], 1)
        lines[line] = re.sub(r'\bconstexpr\b', 'const', lines[line], 1)
        result = '\n'.join(lines)
    return result
