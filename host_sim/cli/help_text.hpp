// What each help begins and ends with. Examples come first: most readers need nothing else.
#pragma once

namespace shade16::host {

inline constexpr const char* program_help =
    R"(Examples:
  shade16 render teapot.obj -o teapot.png               one picture
  shade16 render teapot.obj -o teapot.y4m               one turn, 90 frames; plays in mpv, VLC and ffplay
  shade16 render teapot.obj -o - | mpv --loop=inf -     the same without a file
  shade16 compare teapot.obj                            how far from double precision, and is it what is promised?
  shade16 bake teapot.obj -o teapot.hpp                 the model as a C++ header for the microcontroller
  shade16 preview teapot.obj                            a look at it in the terminal
  shade16 show teapot.obj --dc GPIO25                   the same on a panel at the SPI of a Raspberry Pi
  shade16 info teapot.obj                               what it needs, and what it takes in flash and RAM
  shade16 materials -o sheet.png                        the 24 classic materials by name

shade16 draws on this computer what the fixed-point engine draws on a microcontroller, bit for bit.
)";

inline constexpr const char* render_help =
    R"(Examples:
  shade16 render teapot.obj -o teapot.png                            one picture
  shade16 render teapot.obj -o turn.y4m --frames 60 --size 240x240   one turn as a film
  shade16 render teapot.obj -o turn.apng --size 128x64 --scale 3     a small panel, large, for a web page
  shade16 render teapot.obj -o turn.png --frames 12                  turn-0000.png to turn-0011.png
  shade16 render teapot.obj -o frame.rgb565 --format rgb565_swapped  the bytes that an SPI display takes
  shade16 render teapot.obj -o - | ffmpeg -i - turn.gif              a stream
  shade16 render teapot.obj -o shine.png --component specular        the highlights alone
  shade16 render scene.toml -o scene.y4m                             camera, lights and objects of your own
  shade16 render teapot.obj --dump-scene                             the scene around a model: a file to begin with

Draws a model turning once about its vertical axis, fitted into the frame and lit; or a scene file as it says. The
command line wins over the scene file. docs/scene-file.md has every key.
)";

inline constexpr const char* compare_help =
    R"(Examples:
  shade16 compare teapot.obj                            every tier, 8 turns
  shade16 compare teapot.obj --tier lowp --frames 90    one tier, more closely
  shade16 compare teapot.obj --shading flat
  shade16 compare scene.toml                            a scene file

Measures the fixed-point engine against double precision and prints three errors, each beside what is promised of it.
The exit code is 1 when a promise is broken.
)";

inline constexpr const char* bake_help =
    R"(Examples:
  shade16 bake teapot.obj -o teapot.hpp                 defines assets::teapot and assets::teapot_material
  shade16 bake teapot.obj -o mesh.hpp --name pot        defines assets::pot and assets::pot_material
  shade16 bake scene.toml -o scene.hpp                  defines assets::scene::scene, its meshes and its animation

Rounds models to 16 bits a coordinate and writes them as a C++ header of constants, which stay in flash; of a scene file
everything that it says. docs/scene-file.md tells how an image draws such a header.
)";

inline constexpr const char* info_help =
    R"(Examples:
  shade16 info teapot.obj                               what it needs, and what it takes in flash and RAM
  shade16 info teapot.obj --size 128x64                 the same for a small display
  shade16 info teapot.obj --json | jq .memory.tiers     for scripts

Says which terms of the shading the compiler would keep for this model in the light of 'shade16 render', and which it
would leave out.
)";

inline constexpr const char* preview_help =
    R"(Examples:
  shade16 preview teapot.obj                            turns until q or Ctrl-C
  shade16 preview teapot.obj --frames 1                 one picture, which stays
  shade16 preview teapot.obj | less -R                  the same where there is no terminal

Shows the model in the terminal, two pixels a character, in 24-bit colour; in letters alone where NO_COLOR is set.
)";

inline constexpr const char* show_help =
    R"(Examples:
  shade16 show teapot.obj --panel ili9341 --dc GPIO25 --reset GPIO27 --backlight GPIO18 --rotate 90
  shade16 show teapot.obj --panel st7789_240x240 --dc GPIO25 --spi /dev/spidev0.1 --spi-hz 40M
  shade16 show teapot.obj --panel mine.txt --dc GPIO25 --clock 11 --data 10     without SPI, slowly
  shade16 show teapot.obj --board fbdev                 the kernel's framebuffer
  shade16 show teapot.obj --board terminal              a look at it over ssh
  shade16 show --probe --dc GPIO25                      what is there, and what brings the rest
  shade16 show teapot.obj --frames 1 --dry-run          what the panel would be sent

Draws frame after frame, sends the rows that changed, and ends with Ctrl-C. docs/linux.md has the wiring.
)";

inline constexpr const char* materials_help =
    R"(Examples:
  shade16 materials                                     the table: colours, shininess and alpha
  shade16 materials -o sheet.png                        a sheet of spheres
  shade16 materials -o sheet.png --size 160x160 --shading phong
  shade16 materials --json | jq '.materials[].name'     for scripts

The classic OpenGL materials, which a scene file takes by their names, such as like = "emerald". Their alpha is kept and
not drawn.
)";

inline constexpr const char* gallery_help =
    R"(Examples:
  shade16 gallery assets -o docs/gallery                what scripts/gallery.sh runs

Draws the pictures of docs/gallery.md and prints the figures that the page quotes. The exit code is 1 when two pictures that
are shown side by side differ in fewer pixels than the page says.
)";

inline constexpr const char* report_help =
    R"(Examples:
  shade16 report bounds -o out                          a minute: out/bounds.html, out/bounds.json, out/bounds.md
  shade16 report bounds -o out --only rsqrt             some functions alone
  shade16 report bounds -o out --full                   every input of every function of one argument: hours
  shade16 report bounds -o out/0 --full --shard 0/2     the first of two halves of that
  shade16 report bounds -o out --merge out/*/bounds.json

Measures the error of every function of which the engine promises one, and of vertices in every tier. The exit code is 1
when a bound is broken.
)";

inline constexpr const char* exit_codes_help =
    R"(Exit codes: 0 done, 1 a promise is broken, 2 wrong input or usage, 3 the machine could not read or write.
)";

}  // namespace shade16::host
