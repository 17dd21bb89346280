"""What each term adds to a scene, on the Cortex-M3: instructions of a frame, and bytes. And what code belongs to which term."""
import re
from functools import lru_cache

from commands import PROJECT, run
from counting import FrameCount
from image import Image
from plan import DEFAULT_BOARD

# A term's image has these terms; it is held against another image. tests/budget/term_scene.cpp has the scene.
VARIANTS = {
    "base": ("", None), "unlit": ("unlit", "base"), "orthographic": ("orthographic", "base"), "no_depth": ("no_depth", "base"),
    "ambient": ("ambient", "base"), "specular": ("specular", "base"), "reflected": ("specular reflected", "specular"),
    "local_viewer": ("specular local_viewer", "specular"), "point": ("point", "base"), "attenuation": ("point attenuation", "point"),
    "falloff": ("point falloff", "point"), "range": ("point range", "point"), "spot": ("spot", "point"),
    "spot_exponent": ("spot spot_exponent", "spot"), "vertex_colors": ("vertex_colors", "base"), "stretch": ("stretch", "base"),
    "flat": ("flat", "base"), "phong": ("phong", "base"), "spherical": ("phong spherical", "phong"),
    "light_table": ("phong light_table", "phong"), "light_table_bilinear": ("phong light_table bilinear", "light_table"),
    "texture": ("texture", "base"), "texture_bilinear": ("texture bilinear", "texture"),
    "texture_perspective": ("texture perspective_texture", "texture"), "bump": ("phong bump", "phong"),
}
WORDS = {
    "base": "a sphere, one directional light, diffuse", "unlit": "unlit, without light", "orthographic": "an orthographic camera",
    "no_depth": "a convex mesh alone: no depth", "ambient": "ambient light", "specular": "a highlight, Blinn-Phong",
    "reflected": "a highlight, Phong", "local_viewer": "a local viewer", "point": "a point light in its place",
    "attenuation": "its attenuation", "falloff": "its falloff, 1/d^p", "range": "its range", "spot": "a spot in its place",
    "spot_exponent": "the spot's exponent", "vertex_colors": "vertex colours", "stretch": "a scale that differs by axis",
    "flat": "flat shading", "phong": "Phong shading", "spherical": "spherical normals", "light_table": "a light table, nearest",
    "light_table_bilinear": "a light table, bilinear", "texture": "a texture, nearest and affine",
    "texture_bilinear": "bilinear", "texture_perspective": "in perspective", "bump": "a relief, nearest and affine",
}


def _image(name):
    return Image(PROJECT / "build" / DEFAULT_BOARD / "tests" / f"term_{name}.elf")


def _measured(name, plugin):
    image = _image(name)
    sizes = image.sizes()
    return (FrameCount(image, plugin, DEFAULT_BOARD).instructions, sizes["text_bytes"] + sizes["rodata_bytes"],
            sizes["ram_bytes"])


def table(plugin):
    run(["cmake", "--preset", DEFAULT_BOARD], f"{DEFAULT_BOARD} cannot be configured")
    run(["cmake", "--build", "--preset", DEFAULT_BOARD, "--target", *(f"term_{name}" for name in VARIANTS)],
        f"{DEFAULT_BOARD} cannot be built")
    measured = {name: _measured(name, plugin) for name in VARIANTS}
    lines = ["| term | against | instructions | flash | RAM |", "| --- | --- | --: | --: | --: |"]
    for name, (_, base) in VARIANTS.items():
        if base is None:
            values = [f"{value:,}" for value in measured[name]]
        else:
            values = [f"{value - other:+,}" for value, other in zip(measured[name], measured[base])]
        lines.append(f"| {WORDS[name]} | {WORDS[base] if base else ''} | " + " | ".join(values) + " |")
    return "\n".join(lines)


# Code that only a scene with one of some terms may have: (terms, files, functions).
_CODE = (
    ({"texture", "bump", "light_table"}, {"pipeline/texture_lookup.hpp"}, ()),
    ({"texture"}, {"pipeline/paint_textured.hpp"}, ("split_light_point", "keep_split_light")),
    ({"bump"}, {"pipeline/tangents.hpp"}, ("turned", "face_tangents")),
    ({"light_table"}, {"pipeline/light_table.hpp", "pipeline/paint_table.hpp"}, ()),
    ({"spherical"}, {"pipeline/paint_spherical.hpp", "num/arc.hpp"}, ("arctangent",)),
    ({"phong"}, {"pipeline/paint_phong.hpp"}, ("PixelLight",)),
    ({"phong", "texture"}, {"pipeline/paint_samples.hpp", "pipeline/sample_planes.hpp", "pipeline/surface.hpp"}, ()),
    ({"spot", "range", "falloff"}, {"pipeline/lamp.hpp"}, ("lamp_factor",)),
    ({"falloff", "spot_exponent"}, {"num/scaled_power.hpp"}, ()),
    ({"flat"}, {"pipeline/face.hpp"}, ("light_face",)),
    ({"specular"}, {"num/shininess_window.hpp", "num/shininess_shared.hpp", "pipeline/chord.hpp"}, ("half_of",)),
    ({"reflected"}, set(), ("reflected_chord",)),
    ({"halfway"}, set(), ("half_vector", "half_of")),
    ({"point"}, set(), ("place_lamp", "object_point")),
    ({"point", "local_viewer"}, set(), ("vector_to", "towards", "from_scaled")),
    ({"attenuation"}, set(), ("attenuation_along", "LatticeAttenuation")),
    ({"stretch"}, set(), ("make_stretch", "ratio")),
    ({"vertex_colors", "texture"}, set(), ("modulate",)),
    ({"depth"}, {"pipeline/depth.hpp"}, ()),
    ({"diffuse", "specular"}, set(), ("add_lights", "cosine", "make_object_light")),
)

# And tables: (terms, a part of their mangled names).
_TABLES = (
    ({"specular"}, "shininess_in_flash"),
    ({"falloff", "spot_exponent"}, "middle_log_table"),
    ({"falloff", "spot_exponent"}, "middle_exp_table"),
)


def rules():
    """The terms of each rule, as foreign_code writes them."""
    return [" or ".join(sorted(terms)) for terms, *_ in _CODE + _TABLES]


def foreign_code(image, needed):
    """Sentences about code and tables of terms that a scene does not need."""
    frames = {frame for chain in image.chains.values() for frame in chain}
    complaints = []
    for terms, files, functions in _CODE:
        if terms & needed:
            continue
        found = next((f for f in sorted(frames) if f.file in files or _names(f.function) & set(functions)), None)
        if found:
            complaints.append(f"{image.path} has code of {' or '.join(sorted(terms))}, which its scene does not need: "
                              f"{found.function} of {found.file}.")
    for terms, part in _TABLES:
        found = next((name for name in image.objects if part in name), None)
        if found and not terms & needed:
            complaints.append(f"{image.path} has code of {' or '.join(sorted(terms))}, which its scene does not need: the table {found}.")
    return complaints


@lru_cache(maxsize=None)
def _names(function):
    return set(re.split(r"[<(]|::", function))
