#!/usr/bin/env python3
"""Checks that data members that are not public begin with m_. Constants and types are free.

Usage: check_members.py [FOLDER...]   (default: all sources of the package)
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "examples", "benchmark", "test")

CLASS = re.compile(r"(?:^|[;}>\s])(class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^{;]*)?$")
ENUM = re.compile(r"\benum\b")
ACCESS = re.compile(r"^(public|private|protected)\s*:")
NOT_DATA = re.compile(r"^(typedef|using|friend|template|static|constexpr|class|struct|enum|union|explicit|virtual|operator)\b")


def blanked(text):
    """Returns the text without comments, strings and lines of the preprocessor, line for line."""
    text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m.group().count("\n"), text, flags=re.S)
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)
    text = re.sub(r"'(?:\\.|[^'\\\n])'", "0", text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m.group().count("\n"), text, flags=re.M)


def names_of_data(statement):
    """Returns the names that a statement in a class declares as data members."""
    statement = " ".join(statement.split())
    if not statement or NOT_DATA.match(statement):
        return []
    # Initializers are left out: they may call functions.
    depth, parts, part, in_initializer = 0, [], "", False
    for c in statement:
        if c in "([{<":
            depth += 1
        elif c in ")]}>":
            depth -= 1
        if depth == 0 and c == "=":
            in_initializer = True
        if depth == 0 and c == ",":
            parts.append(part)
            part, in_initializer = "", False
        elif not in_initializer:
            part += c
    parts.append(part)
    names = []
    for part in parts:
        part = re.sub(r"\{[^{}]*\}", "", part)
        if "(" in re.sub(r"<[^;]*>", "", part):
            return []  # a function
        match = re.search(r"(\w+)\s*(?:\[[^\]]*\])?\s*$", part)
        if match:
            names.append(match.group(1))
    return names


def offences(path):
    """Yields line and name of each data member that is not public and does not begin with m_."""
    text = blanked(path.read_text(encoding="utf-8"))
    stack = []  # per open brace: class, struct or nothing; access; whether it opens an initializer
    statement, line, start = "", 1, 1
    parentheses = 0
    for c in text:
        if c == "\n":
            line += 1
        if c == "(":
            parentheses += 1
        elif c == ")":
            parentheses -= 1
        if parentheses == 0 and c == "{":
            match = CLASS.search(statement.strip())
            kind = match.group(1) if match and not ENUM.search(statement) else ""
            is_initializer = bool(stack) and stack[-1][0] and not kind and "(" not in statement and not ENUM.search(statement)
            stack.append([kind, {"class": "private", "struct": "public"}.get(kind, ""), is_initializer])
            if not is_initializer:
                statement = ""
            continue
        if parentheses == 0 and c == "}":
            if stack:
                _, _, was_initializer = stack.pop()
                if not was_initializer:
                    statement = ""
            continue
        if stack and stack[-1][2]:
            continue
        if parentheses == 0 and c == ";":
            if stack and stack[-1][0] and stack[-1][1] != "public":
                for name in names_of_data(statement):
                    if not name.startswith("m_"):
                        yield start, name
            statement = ""
            continue
        if not statement.strip() and not c.isspace():
            start = line
        statement += c
        match = ACCESS.match(statement.strip())
        if match and stack and stack[-1][0] and not statement.strip().endswith("::"):
            stack[-1][1] = match.group(1)
            statement = ""


def main():
    folders = [pathlib.Path(f) for f in sys.argv[1:]] or [ROOT / f for f in FOLDERS]
    number = 0
    for folder in folders:
        for path in sorted(folder.rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            for line, name in offences(path):
                print(f"{path}:{line}: the member {name} is not public and does not begin with m_")
                number += 1
    print("1 offence" if number == 1 else f"{number} offences")
    return 1 if number else 0


if __name__ == "__main__":
    sys.exit(main())
