#include "tests/fuzz/drawing.hpp"

namespace shade16::fuzz {

extern template bool check_drawing_of<lowp, Channels::rgb>(const Drawing&);
extern template bool check_drawing_of<lowp, Channels::luma>(const Drawing&);
extern template bool check_drawing_of<mediump, Channels::rgb>(const Drawing&);
extern template bool check_drawing_of<mediump, Channels::luma>(const Drawing&);
extern template bool check_drawing_of<highp, Channels::rgb>(const Drawing&);
extern template bool check_drawing_of<highp, Channels::luma>(const Drawing&);

bool check_drawing(const Drawing& d) {
    switch (d.target / 2) {
        case 0: return check_drawing_of<lowp, Channels::rgb>(d);
        case 1: return check_drawing_of<lowp, Channels::luma>(d);
        case 2: return check_drawing_of<mediump, Channels::rgb>(d);
        case 3: return check_drawing_of<mediump, Channels::luma>(d);
        case 4: return check_drawing_of<highp, Channels::rgb>(d);
        default: return check_drawing_of<highp, Channels::luma>(d);
    }
}

}  // namespace shade16::fuzz
