// shade16 gallery: the pictures of docs/gallery.md and the figures that it quotes.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode gallery(const GalleryOptions& options);

}  // namespace shade16::host
