#include "host_sim/gallery/plate.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "host_sim/gallery/canvas.hpp"
#include "host_sim/gallery/font.hpp"
#include "host_sim/gallery/heat_map.hpp"
#include "host_sim/io/magnify.hpp"

namespace shade16::host {

namespace {

constexpr int margin_px = 8, line_px = glyph_height_px + 5;

int cell_height(const Panel& p) {
    int height = p.image.height + line_px;
    if (p.profile) height += p.profile->height + 4;
    if (p.error) height += p.error->height * p.error_scale + line_px + 2;
    return height + margin_px;
}

void put_panel(Canvas& canvas, const Panel& p, int x, int y) {
    canvas.put(p.image, x, y);
    y += p.image.height;
    if (p.profile) {
        canvas.put(*p.profile, x, y + 4);
        y += p.profile->height + 4;
    }
    canvas.write(p.name, x, y + 3);
    y += line_px;
    if (!p.error) return;
    const Image map = magnified(heat_map(*p.error), p.error_scale);
    canvas.put(map, x, y + 2);
    canvas.write(fmt::format("mean {:.3f}, largest {:.2f}", p.error->mean_levels, p.error->largest_levels), x,
                 y + map.height + 5, faint);
}

const Panel& panel_of(const Plate& plate, const std::string& name) {
    const auto found = std::ranges::find(plate.panels, name, &Panel::name);
    if (found == plate.panels.end()) throw std::logic_error("a pair names panels of its plate");
    return *found;
}

}  // namespace

void Plate::add_pair(const std::string& a, const std::string& b, double stated_share) {
    pairs.push_back({a, b, stated_share, difference(panel_of(*this, a).image, panel_of(*this, b).image)});
}

void compose(Plate& plate) {
    int cell_width = 0, height = margin_px;
    const auto columns = static_cast<std::size_t>(plate.columns);
    std::vector<int> tops;
    for (std::size_t first = 0; first < plate.panels.size(); first += columns) {
        int row = 0;
        for (std::size_t i = first; i < std::min(first + columns, plate.panels.size()); ++i) {
            const Panel& p = plate.panels[i];
            cell_width = std::max({cell_width, p.image.width, p.error ? p.error->width * p.error_scale : 0});
            row = std::max(row, cell_height(p));
        }
        tops.push_back(height);
        height += row;
    }
    const Image scale = heat_scale();
    const bool has_scale = std::ranges::any_of(plate.panels, [](const Panel& p) { return p.error.has_value(); });
    const int width =
        std::max(plate.columns * (cell_width + margin_px) + margin_px, has_scale ? scale.width + 2 * margin_px : 0);
    Canvas canvas(width, height + (has_scale ? line_px + 2 : 0));
    for (std::size_t i = 0; i < plate.panels.size(); ++i)
        put_panel(canvas, plate.panels[i], margin_px + static_cast<int>(i % columns) * (cell_width + margin_px),
                  tops[i / columns]);
    if (has_scale) canvas.put(scale, margin_px, height);
    plate.image = canvas.image();
}

}  // namespace shade16::host
