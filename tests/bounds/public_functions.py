#!/usr/bin/env python3
"""Every public function of the core's numbers has a bound that is measured.

The functions are read from the compiler's syntax tree, and what is measured from bounds.json.
usage: public_functions.py CLANG BOUNDS_JSON INCLUDE_DIRECTORY...
"""
import json
import pathlib
import subprocess
import sys
import tempfile

FUNCTIONS = {"FunctionDecl", "CXXMethodDecl", "CXXConversionDecl"}
HIDDEN = {"detail", "wide", "narrow"}  # namespaces; wide and narrow are the two bodies of one definition
SAID = ("Range", "Error", "Cost", "Source")  # by the comment of whatever errs
# Those that say it in the comment of the function that they call, or of the one that stands before them.
BESIDE = {"as_factor", "sin", "cos", "Block::operator-", "Block::in_units_of", "ShininessWindow::build", "ShininessShared::build", "shininess"}


class Tree:
    """Walks clang's JSON, which names a file only where it differs from that of the location before."""

    def __init__(self, includes):
        self.includes, self.file, self.found = includes, "", {}

    def header(self, file):
        """The file as users include it, without shade16/; empty for what is not ours."""
        for include in self.includes:
            if file.startswith(include):
                return file[len(include):].lstrip("/").removeprefix("shade16/")
        return ""

    def locate(self, place):
        for part in (place.get("spellingLoc"), place.get("expansionLoc"), place):
            if part and "file" in part:
                self.file = part["file"]

    def walk(self, node, scope, access):
        self.locate(node.get("loc", {}))
        file = self.file
        for end in ("begin", "end"):
            self.locate(node.get("range", {}).get(end, {}))
        kind, name = node.get("kind"), node.get("name", "")
        inner = node.get("inner", [])
        if kind in FUNCTIONS:
            # Whatever the language writes itself, and what is never defined, promises nothing.
            is_written = not (node.get("isImplicit") or node.get("explicitlyDefaulted"))
            has_body = any(part.get("kind") == "CompoundStmt" for part in inner)
            if is_written and has_body and access != "private" and not HIDDEN & set(scope) and self.header(file):
                text = json.dumps([part for part in inner if part.get("kind") == "FullComment"])
                self.found.setdefault((self.header(file), "::".join(scope[1:] + [name])), []).append(text)
        if kind == "UsingDecl" and self.header(file) and not HIDDEN & set(scope):
            self.found.setdefault((self.header(file), name.split("::")[-1]), [])
        if kind in ("NamespaceDecl", "CXXRecordDecl") and name:
            scope = scope + [name]
        own = "private" if kind == "CXXRecordDecl" and node.get("tagUsed") == "class" else "public"
        if kind == "FunctionTemplateDecl":  # what follows its own function are instances of it
            inner = [part for part in inner if part.get("kind") not in FUNCTIONS] + [part for part in inner if part.get("kind") in FUNCTIONS][:1]
        for part in inner:
            if part.get("kind") == "AccessSpecDecl":
                own = part.get("access", own)
            self.walk(part, scope, own if kind == "CXXRecordDecl" else access)


def functions(clang, includes):
    with tempfile.TemporaryDirectory() as scratch:
        source = pathlib.Path(scratch) / "numbers.cpp"
        headers = sorted(f"shade16/num/{path.name}" for include in includes for path in pathlib.Path(include, "shade16/num").glob("*.hpp"))
        source.write_text("".join(f'#include "{header}"\n' for header in headers))
        command = [clang, "-std=c++20", *(f"-I{include}" for include in includes), "-fsyntax-only", "-Xclang", "-ast-dump=json", str(source)]
        tree = Tree(includes)
        tree.walk(json.loads(subprocess.run(command, check=True, capture_output=True).stdout), [], "public")
    return {key: texts for key, texts in tree.found.items() if key[0].startswith("num/")}


def measured(path):
    largest = {}
    for entry in json.loads(pathlib.Path(path).read_text())["bounds"]:
        for header in entry["header"].split():
            for function in entry["functions"].split():
                largest[header, function] = max(largest.get((header, function), 0), entry["bound"])
    return largest


def main(clang, bounds, *includes):
    known, bounded, mistakes = functions(clang, [str(pathlib.Path(include).resolve()) for include in includes]), measured(bounds), []
    for (header, function), comments in known.items():
        if (header, function) not in bounded:
            mistakes.append(f"{header}: {function} has no bound: expected an entry in host_sim/bounds that measures it.")
        elif bounded[header, function] > 0 and function not in BESIDE and not function.startswith("operator\"\""):
            for comment in comments:  # of every overload
                if missing := " and ".join(word for word in SAID if word not in comment):
                    mistakes.append(f"{header}: {function} errs, and a comment of it does not say {missing}.")
    for header, function in bounded:
        if header.startswith("num/") and not any(f == function for _, f in known):
            mistakes.append(f"{header}: {function} is measured, and there is no such function.")
    if len(known) < 80:
        mistakes.append(f"only {len(known)} functions were found in the syntax tree: expected at least 80.")
    print("\n".join(mistakes) or f"{len(known)} functions, each with a bound.")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
