"""Mutation operators: small changes of the kinds that engineers make, read off the syntax tree of a file.

C++ is parsed by libclang, templates and headers too; Python by ast. Messages, logging and declarations of enumerations
are left alone. `changes(path, arguments)` gives every change; which of them are tried is drawn elsewhere.
"""

import ast
import dataclasses
import pathlib
import re

RELATIONAL = {"<": ("<=", ">"), "<=": ("<", ">="), ">": (">=", "<"), ">=": (">", "<="), "==": ("!=",), "!=": ("==",)}
ARITHMETIC = {"+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "+=": ("-=", "="), "-=": ("+=",), "*=": ("/=",),
              "/=": ("*=",)}
LOGICAL = {"&&": ("||",), "||": ("&&",), "and": ("or",), "or": ("and",)}
SIGNS = {"relation": RELATIONAL, "arithmetic": ARITHMETIC, "logic": LOGICAL}
MEMBERS = [("x", "y"), ("left", "right"), ("front", "back"), ("lower", "upper"), ("top", "bottom"), ("width", "height"),
           ("first", "last"), ("rows", "columns"), ("nx", "ny"), ("min", "max"), ("sin", "cos")]
STALE = [("before", "after"), ("previous", "next"), ("begin", "end"), ("old", "new")]
EXCHANGED = {"member": {**dict(MEMBERS), **{b: a for a, b in MEMBERS}}, "stale value": {**dict(STALE), **{b: a for a, b in STALE}}}
SYMMETRIC = re.compile(r"f?(max|min)|hypot|swap|minmax|midpoint")
MESSAGES = re.compile(r"format|print|println|warn|fail|refuse|reject|say|to_string|describe|help")
WHOLE, REAL = re.compile(r"\d[\d']*"), re.compile(r"[\d'.]+([eE][+-]?\d+)?[fF]?")


@dataclasses.dataclass(frozen=True)
class Change:
    """The bytes of a file from begin to end are replaced by a text."""

    file: str
    begin: int
    end: int
    text: str
    operator: str
    line: int = 0
    units: tuple[tuple[int, int], ...] = ()  # the expressions, or the statement, that the change makes others of

    def applied(self, whole):
        return whole[:self.begin] + self.text.encode() + whole[self.end:]

    def shown(self, whole):
        """One line: what stood there, and what stands there now."""
        was, now = (" ".join(text.split()) for text in (whole[self.begin:self.end].decode(), self.text))
        return f"{self.operator}: {was[:80]} → {now[:80] or 'nothing'}"

    def chosen(self, whole, condition):
        """(begin, end, text) to put in place of others, so that a condition in C++ chooses between what was and what is."""
        was = [whole[begin:end].decode() for begin, end in self.units]
        if self.operator == "arguments":
            return [(*unit, f"({condition} ? ({other}) : ({one}))") for unit, one, other in zip(self.units, was, was[::-1])]
        (begin, end), = self.units
        if self.operator == "statement left out":
            return [(begin, end, f"if (!{condition}) {was[0]}")]
        now = (whole[begin:self.begin] + self.text.encode() + whole[self.end:end]).decode()
        yes_or_no = "bool" if self.operator in ("condition", "guard taken away") else ""
        return [(begin, end, f"({condition} ? {yes_or_no}({now}) : {yes_or_no}({was[0]}))")]


def other_names(name):
    """The operators that know a name by its words, and what they make of it."""
    words = re.split(r"(_)", name)
    for operator, partner in EXCHANGED.items():
        for i, word in enumerate(words):
            if word in partner:
                yield operator, "".join([*words[:i], partner[word], *words[i + 1:]])


def other_constants(literal):
    if WHOLE.fullmatch(literal):
        return [str(int(literal.replace("'", "")) + step) for step in (1, -1) if literal != "0" or step > 0]
    if not REAL.fullmatch(literal) or not re.search(r"\d", literal):
        return []
    return [f"(1.01 * {literal})"] if float(literal.rstrip("fF").replace("'", "")) else ["1.0"]


class Finder:
    def __init__(self, file, whole):
        self.file, self.whole, self.found = file, whole, {}

    def add(self, operator, begin, end, text, *units):
        units = units or ((begin, end),)
        change = Change(self.file, begin, end, text, operator, self.whole.count(b"\n", 0, begin) + 1, units)
        if begin < end and self.text(begin, end) != text:
            self.found.setdefault((begin, end, text), change)

    def text(self, begin, end):
        return self.whole[begin:end].decode(errors="replace")

    def sign(self, begin, end, unit=None):
        """The operator's sign between two operands, of an expression."""
        between = self.text(begin, end)
        sign = between.strip()
        for operator, others in SIGNS.items():
            for other in others.get(sign, ()):
                first = begin + between.index(sign)
                self.add(operator, first, first + len(sign), other, *filter(None, [unit]))

    def arguments(self, extents):
        """Neighbours exchanged."""
        for (a, b), (c, d) in zip(extents, extents[1:]):
            if a < b <= c < d and self.text(a, b) != self.text(c, d):
                self.add("arguments", a, d, self.text(c, d) + self.text(b, c) + self.text(a, b), (a, b), (c, d))

    def names(self, name, end, called, unit=None):
        if self.text(end - len(name), end) == name:
            for operator, other in other_names(name):
                if not (called and operator == "stale value"):
                    self.add(operator, end - len(name), end, other, *filter(None, [unit]))

    def index(self, begin, end):
        text = self.text(begin, end)
        neighbour = re.fullmatch(r"(\w+) [+-] 1", text)
        if neighbour:
            self.add("index", begin, end, neighbour[1])
        elif re.fullmatch(r"[a-z]\w*", text):
            self.add("index", begin, end, f"{text} + 1")


class Cpp(Finder):
    def run(self, arguments):
        from clang.cindex import CursorKind, Index
        self.kind = CursorKind
        unit = Index.create().parse(self.path, arguments)
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name == self.path:
                self.visit(cursor)
        return list(self.found.values())

    def __init__(self, file, whole, path):
        super().__init__(file, whole)
        self.path = path

    @staticmethod
    def extent(cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def visit(self, cursor, call=None):
        """@param call  the extent of the call of which this is the function"""
        kind, kinds = cursor.kind, self.kind
        children = list(cursor.get_children())
        begin, end = self.extent(cursor)
        if kind in (kinds.CXX_THROW_EXPR, kinds.STATIC_ASSERT, kinds.ENUM_DECL, kinds.STRING_LITERAL):
            return
        if kind == kinds.CALL_EXPR:
            name = cursor.spelling or self.text(*self.extent(children[0])).split("::")[-1] if children else cursor.spelling
            if MESSAGES.fullmatch(name):
                return
            condition_and_message = name.startswith("require_that")
            if condition_and_message:
                children = children[:2]
            if name.startswith("operator") and name[8:9] in ("[", "+", "-", "*", "/", "<", ">", "=", "!"):
                if len(children) == 3:
                    if name == "operator[]":
                        self.index(*self.extent(children[2]))
                    else:
                        self.sign(*self.extent(children[1]), (begin, end))
            elif not SYMMETRIC.fullmatch(name) and not condition_and_message:
                self.exchange(list(cursor.get_arguments()))
        elif kind == kinds.INIT_LIST_EXPR:
            self.exchange(children)
        elif kind in (kinds.BINARY_OPERATOR, kinds.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.sign(self.extent(children[0])[1], self.extent(children[1])[0], (begin, end))
        elif kind == kinds.UNARY_OPERATOR and self.text(begin, begin + 1) in "-!":
            self.add("sign" if self.text(begin, begin + 1) == "-" else "condition", begin, begin + 1, " ", (begin, end))
        elif kind in (kinds.INTEGER_LITERAL, kinds.FLOATING_LITERAL):
            for other in other_constants(self.text(begin, end)):
                self.add("constant", begin, end, other)
        elif kind in (kinds.DECL_REF_EXPR, kinds.MEMBER_REF_EXPR):
            self.names(cursor.spelling, end, self.text(end, end + 1) == "(", call or (begin, end))
        elif kind == kinds.ARRAY_SUBSCRIPT_EXPR and len(children) == 2:
            self.index(*self.extent(children[1]))
        elif kind == kinds.COMPOUND_STMT:
            for child in children:
                if child.kind in (kinds.CALL_EXPR, kinds.BINARY_OPERATOR, kinds.COMPOUND_ASSIGNMENT_OPERATOR,
                                  kinds.UNEXPOSED_EXPR) and not MESSAGES.fullmatch(child.spelling):
                    self.add("statement left out", *self.extent(child), "")
        elif kind in (kinds.IF_STMT, kinds.CONDITIONAL_OPERATOR):
            self.decision(children, kind == kinds.IF_STMT)
        for i, child in enumerate(children):
            called = (begin, end) if kind == kinds.CALL_EXPR and i == 0 else call if kind == kinds.UNEXPOSED_EXPR else None
            self.visit(child, called)

    def exchange(self, arguments):
        def plain(one):
            return one.type.get_canonical().spelling.replace("const ", "").rstrip(" &")
        for one, other in zip(arguments, arguments[1:]):
            if plain(one) == plain(other):
                self.arguments([self.extent(one), self.extent(other)])

    def decision(self, children, is_statement):
        at = next((i for i, child in enumerate(children) if child.kind.is_expression()), None)
        if at is None or len(children) < at + 2:
            return
        begin, end = self.extent(children[at])
        self.add("condition", begin, end, f"!({self.text(begin, end)})")
        then = self.text(*self.extent(children[at + 1])).lstrip("{ \n")
        if is_statement and len(children) == at + 2 and re.match(r"throw|return|continue|break", then):
            self.add("guard taken away", begin, end, "false")


class Python(Finder):
    def run(self):
        self.starts = [0]
        for line in self.whole.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))
        self.visit(ast.parse(self.whole))
        return list(self.found.values())

    def extent(self, node):
        return self.starts[node.lineno - 1] + node.col_offset, self.starts[node.end_lineno - 1] + node.end_col_offset

    def visit(self, node):
        if isinstance(node, (ast.JoinedStr, ast.Raise, ast.Assert)):
            return
        if isinstance(node, ast.Call):
            if MESSAGES.fullmatch(ast.unparse(node.func).split(".")[-1]):
                return
            if not SYMMETRIC.fullmatch(ast.unparse(node.func).split(".")[-1]):
                self.arguments([self.extent(one) for one in node.args])
        elif isinstance(node, ast.BinOp):
            self.sign(self.extent(node.left)[1], self.extent(node.right)[0])
        elif isinstance(node, ast.BoolOp):
            for a, b in zip(node.values, node.values[1:]):
                self.sign(self.extent(a)[1], self.extent(b)[0])
        elif isinstance(node, ast.Compare):
            for a, b in zip([node.left, *node.comparators], node.comparators):
                self.sign(self.extent(a)[1], self.extent(b)[0])
        elif isinstance(node, ast.AugAssign):
            self.sign(self.extent(node.target)[1], self.extent(node.value)[0])
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.Not)):
            begin = self.extent(node)[0]
            self.add("sign" if isinstance(node.op, ast.USub) else "condition", begin, self.extent(node.operand)[0], "")
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            for other in other_constants(self.text(*self.extent(node))):
                self.add("constant", *self.extent(node), other)
        elif isinstance(node, (ast.Name, ast.Attribute)):
            self.names(node.id if isinstance(node, ast.Name) else node.attr, self.extent(node)[1], False)
        elif isinstance(node, ast.Subscript):
            begin, end = self.extent(node.slice)
            self.index(begin, end)
            if isinstance(node.slice, ast.Constant) and isinstance(node.slice.value, str):
                self.names(node.slice.value, end - 1, False)
        elif isinstance(node, (ast.If, ast.IfExp)):
            begin, end = self.extent(node.test)
            self.add("condition", begin, end, f"not ({self.text(begin, end)})")
            if isinstance(node, ast.If) and not node.orelse and isinstance(
                    node.body[0], (ast.Raise, ast.Return, ast.Continue, ast.Break)):
                self.add("guard taken away", begin, end, "False")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            self.add("statement left out", *self.extent(node), "pass")
        for child in ast.iter_child_nodes(node):
            self.visit(child)


def changes(file, root, arguments=()):
    """Every change that the operators make of a file, in its order.

    @param arguments  of the compiler: standard, folders of headers, definitions
    """
    path = pathlib.Path(root) / file
    whole = path.read_bytes()
    found = Python(file, whole).run() if file.endswith(".py") else Cpp(file, whole, str(path)).run(arguments)
    return sorted(found, key=lambda change: (change.begin, change.end, change.text))
