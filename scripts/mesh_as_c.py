#!/usr/bin/env python3
"""Writes the meshes of a baked header as C, for shade16.h: arrays in flash and a `const shade16_mesh` each.

usage: scripts/mesh_as_c.py assets/teapot.hpp > teapot.h
"""
import re
import sys

ARRAY = re.compile(r"inline constexpr shade16::(Position16|Normal14|Rgb|Triangle) (\w+)\[\] = \{\n(.*?)\n\};", re.S)
MESH = re.compile(r"inline constexpr shade16::Mesh (\w+)\{\n(.*?)\n\};", re.S)
C_TYPES = {"Position16": "position", "Normal14": "normal", "Rgb": "color", "Triangle": "triangle"}


def c_array(kind, name, rows):
    """Number types are structs in C++ and numbers in C: {{1}, {2}, {3}} becomes {1, 2, 3}."""
    flat = re.sub(r"\{(-?\w+)\}", r"\1", rows)
    return f"static const shade16_{C_TYPES[kind]} {name}[] = {{\n{flat}\n}};\n"


def c_number(text):
    raw = re.fullmatch(r"shade16::Q16::from_raw\((-?\d+)\)", text)
    return raw.group(1) if raw else f"SHADE16_Q16({text})"


def c_mesh(name, fields, counts):
    value = dict(re.findall(r"\.(\w+) = (.*?),$", fields, re.M | re.S))
    centre = value.get("centre", "{0, 0, 0}").strip("{}").split(",")
    pointers = ", ".join(value.get(key, "0") for key in ("positions", "normals", "colors", "triangles"))
    return (f"static const shade16_mesh {name} = {{\n    {pointers},\n"
            f"    {counts[value['positions']]}, {counts[value['triangles']]},\n"
            f"    {{{', '.join(c_number(c.strip()) for c in centre)}}},\n"
            f"    {value.get('fraction_bits', 14)}, {int(value.get('convex') == 'true')}\n}};\n")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    header = open(sys.argv[1], encoding="utf-8").read()
    arrays, meshes = ARRAY.findall(header), MESH.findall(header)
    if not meshes:
        sys.exit(f"{sys.argv[1]}: holds no mesh; expected a header that 'shade16 bake' made of a model.")
    counts = {name: rows.count("{{") or rows.count("{") for _, name, rows in arrays}
    print(f"// Made by: scripts/mesh_as_c.py {sys.argv[1]}\n#include \"shade16.h\"\n")
    for kind, name, rows in arrays:
        print(c_array(kind, name, rows))
    for name, fields in meshes:
        print(c_mesh(name, fields, counts))


if __name__ == "__main__":
    main()
