// Hashes of small frames: the shadings, lights, maps, cameras, tiers and kinds of pixel.
#pragma once

namespace shade16::identity {

/// With code and memory for a board of 256 KB and 16 KB.
void say_frames();
void say_large_frames();

}  // namespace shade16::identity
