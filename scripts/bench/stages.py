"""Which stage of a frame an instruction works for.

The frames of its inline chain are asked from the inside out; the first whose file has a stage decides. Code that has
none, such as a multiplication or memcpy that was not inlined, works for whoever called it, and counts there.
"""
from functools import lru_cache

from commands import BenchError
from names import short_name

STAGES = ("clear", "transform", "light", "setup", "raster")

# A file's stage, or None to ask the caller; `functions` are those (or the classes) that belong to another stage.
# "transform" also holds what is done once a frame and the walk over the triangles: fetching, rejecting, clipping.
# "setup" is what is done once a triangle, from its area to its gradients and edges; "raster" once a row or pixel.
_TABLE = {
    "pipeline/transform.hpp": ("transform", {}),
    "pipeline/lattice.hpp": ("transform", {}),
    "pipeline/clip.hpp": ("transform", {}),
    "pipeline/workspace.hpp": ("transform", {}),
    "pipeline/renderer.hpp": ("transform", {}),
    "pipeline/frame_setup.hpp": ("transform", {}),
    "pipeline/vertex_light.hpp": ("light", {}),
    "pipeline/face_samples.hpp": ("setup", {}),
    "pipeline/light_table.hpp": ("transform", {"setup": ("table_place",)}),
    "pipeline/paint_table.hpp": ("raster", {"setup": ("table_sample",)}),
    "pipeline/pipeline.hpp": ("transform", {
        "setup": ("draw_facing", "draw_by_pixel", "centre"),
    }),
    "pipeline/light.hpp": ("light", {}),
    "pipeline/light_setup.hpp": ("light", {}),
    "pipeline/chord.hpp": ("light", {}),
    "pipeline/lamp.hpp": ("light", {}),
    "pipeline/face.hpp": ("light", {}),
    "pipeline/vertex.hpp": ("light", {}),  # a vertex rounds its colour
    "pipeline/setup.hpp": ("setup", {}),
    "pipeline/edge.hpp": ("setup", {"raster": ("column", "next_row")}),
    "pipeline/depth.hpp": ("setup", {"raster": ("next_row", "at", "nearer")}),
    "pipeline/paint_packed.hpp": ("raster", {"setup": ("PackedPlanes", "skip_rows")}),
    "pipeline/paint_exact.hpp": ("raster", {"setup": ("ExactPlane::ExactPlane", "ExactPlanes", "planes_of", "ExactPainter::ExactPainter", "skip_rows", "is_steep")}),
    "pipeline/small_edge.hpp": ("setup", {"raster": ("column", "next_row")}),
    "pipeline/small_planes.hpp": ("setup", {}),
    "pipeline/small_exact.hpp": ("raster", {"setup": ("set",)}),
    "pipeline/small_triangle.hpp": ("raster", {"setup": ("draw_small", "set_corners")}),
    "pipeline/tangents.hpp": ("setup", {}),
    "pipeline/texture_lookup.hpp": ("raster", {"setup": ("divide_by_depth", "TextureLookup::TextureLookup")}),
    "pipeline/sample_planes.hpp": ("setup", {"raster": ("at", "next_pixel", "move")}),
    "pipeline/paint_samples.hpp": ("raster", {"setup": ("SamplePainter::SamplePainter", "skip_rows")}),
    "pipeline/paint_textured.hpp": ("raster", {"light": ("lit_sample",)}),
    "pipeline/surface.hpp": ("setup", {"raster": ("at", "next_pixel", "move")}),
    "pipeline/paint_phong.hpp": ("raster", {"light": ("PixelLight",), "setup": ("PhongPainter::PhongPainter", "skip_rows")}),
    "pipeline/paint_spherical.hpp": ("raster", {"setup": ("EdgeArc::EdgeArc", "SphericalRows::SphericalRows", "SphericalPainter::SphericalPainter", "skip_rows")}),
    "pipeline/raster.hpp": ("raster", {"setup": ("raster", "draw_triangle", "draw_phong")}),
    "target/band.hpp": (None, {"clear": ("clear", "clear_to", "fill", "fill_rows", "fill_halfwords", "fill_bytes", "nearest_pixel")}),
}
DRIVERS = ("firmware/apps/", "tests/")  # the program around the frame


def _is_named(function, name):
    return f"::{name}::" in f"::{function}::"


@lru_cache(maxsize=None)  # a frame is part of many chains
def _stage_of_frame(frame):
    if frame.file.startswith(DRIVERS):
        return "transform"
    if frame.file not in _TABLE:
        if frame.file.startswith("pipeline/"):
            raise BenchError(f"core/include/shade16/{frame.file} has no stage: add it to scripts/bench/stages.py.")
        return None
    stage, functions = _TABLE[frame.file]
    name = short_name(frame.function)
    return next((other for other, names in functions.items() if any(_is_named(name, n) for n in names)), stage)


def stage_of(chain):
    """The stage of an inline chain, innermost frame first; None if it works for its caller."""
    return next((stage for stage in map(_stage_of_frame, chain) if stage), None)


def files():
    """The files that the table knows, for the test that finds new ones."""
    return _TABLE.keys()
