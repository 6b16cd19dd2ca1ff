/// Reads curves, axes and texts from an SVG that gnuplot has drawn.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rotor {

/// An axis as its labelled grid lines show it: pixels over values.
using Tics = std::map<double, double>;

inline double pixel(const Tics& axis, double value) {
  const auto& [a, at_a] = *axis.begin();
  const auto& [b, at_b] = *axis.rbegin();
  return at_a + (value - a) / (b - a) * (at_b - at_a);
}

using Points = std::vector<std::pair<double, double>>;

/// The corners of a path, such as M1.5,2l.3-4, where an l goes on from the last corner.
inline Points corners(const std::string& path) {
  Points points;
  bool is_step = false;
  for (const char* at = path.c_str(); *at != 0;) {
    char *right_end = nullptr, *end = nullptr;
    const double right = std::strtod(at, &right_end),
                 down = std::strtod(right_end + (*right_end == ','), &end);
    if (right_end == at) {
      is_step = *at++ == 'l';
      continue;
    }
    const auto from = is_step ? points.back() : std::pair(0., 0.);
    points.emplace_back(from.first + right, from.second + down);
    at = end;
  }
  return points;
}

inline double width(const Points& points) {
  if (points.empty()) return 0;
  const auto [left, right] = std::ranges::minmax_element(points);
  return right->first - left->first;
}

inline std::string without_tags(const std::string& text) {
  std::string plain;
  bool inside = false;
  for (const char c : text) {
    inside = inside || c == '<';
    if (!inside) plain += c;
    inside = inside && c != '>';
  }
  return plain;
}

/// The number of a tic label, which has a typographic minus sign.
inline double number_of(std::string label) {
  const std::string minus = "\u2212";
  if (label.starts_with(minus)) label.replace(0, minus.size(), "-");
  return std::stod(label);
}

struct Box {
  double left, top, right, bottom;
};

/// The room of a text, of a slanted one its place. Its group states anchor, size and direction;
/// letters are assumed to be half as wide as high (DejaVu Sans: 0.6 on average).
inline Box box_of(const std::string& group, const std::string& text) {
  const auto after = [&](std::string_view key) {
    const std::size_t at = group.find(key);
    return at == std::string::npos ? std::string() : group.substr(at + key.size(), 30);
  };
  const auto letters = std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; });
  const double size = std::stod(after("font-size=\"")),
               length = 0.5 * size * static_cast<double>(letters);
  const std::string anchor = after("text-anchor=\"");
  const double before = anchor.starts_with("start") ? 0
                        : anchor.starts_with("end") ? length
                                                    : length / 2;
  const auto [x, y] = corners(after("translate(")).front();
  if (group.find("rotate(270") != std::string::npos ||
      group.find("rotate(-90") != std::string::npos)
    return {x - 0.7 * size, y + before - length, x + 0.2 * size, y + before};
  if (group.find("rotate(") != std::string::npos) return {x, y, x, y};
  return {x - before, y - 0.7 * size, x - before + length, y + 0.2 * size};
}

struct DrawnCurve {
  Points points;  ///< pixels
  Tics y;
};

/// A picture as gnuplot's SVG has it: each grid line comes before its label, and the axes of a
/// panel before its curves. Curves of insets, which have no grid, are left out.
struct DrawnPicture {
  explicit DrawnPicture(const std::string& svg) {
    Tics y_axis;
    Points line;  // the last one of the grid; the key may interrupt it
    bool in_curve = false, in_inset = false, y_is_old = false, has_curves = false;
    std::string group;
    std::vector<Box> boxes;
    const auto between = [&](std::size_t& at, std::string_view begin, std::string_view end) {
      const std::size_t from = svg.find(begin, at) + begin.size();
      at = svg.find(end, from);
      return svg.substr(from, at - from);
    };
    std::size_t start = 0;
    const Points::value_type canvas = corners(between(start, "viewBox=\"0 0 ", "\"")).front();
    for (std::size_t at = 0; (at = svg.find('<', at)) != std::string::npos; ++at) {
      const std::string_view tag(&svg[at], std::min<std::size_t>(30, svg.size() - at));
      if (tag.starts_with("<g transform=\"translate(")) {
        group = between(at, "<g ", ">");
      } else if (tag.starts_with("<g id=\"gnuplot_plot_")) {
        const bool is_first = tag.size() > 21 && tag[20] == '1' && (tag[21] < '0' || tag[21] > '9');
        if (is_first) in_inset = y_is_old && !curves.empty();  // an inset has no grid
        in_curve = !in_inset;
        if (in_curve) curves.push_back({{}, y_axis});
        y_is_old = has_curves = true;
      } else if (tag.starts_with("<path")) {
        const bool is_grid =
            svg.substr(at, svg.find(" d='", at) - at).find("gridline") != std::string::npos;
        const std::string path = between(at, " d='", "'");
        const Points points = corners(path);
        const bool is_frame = path.ends_with('Z');
        if (is_grid) {
          line = points;
          in_curve = has_curves = false;
        } else if (in_curve && !is_frame && width(points) > width(curves.back().points)) {
          curves.back().points = points;  // the shorter one is the key's sample
        }
      } else if (tag.starts_with("<text")) {
        texts.push_back(without_tags(between(at, ">", "</text>")));
        const Box box = box_of(group, texts.back());
        if (box.left < 0 || box.top < 0 || box.right > canvas.first || box.bottom > canvas.second)
          clipped.push_back(texts.back());
        for (std::size_t n = 0; n < boxes.size() && texts.back().size() > 3; ++n)
          if (std::min(box.right, boxes[n].right) - std::max(box.left, boxes[n].left) > 1 &&
              std::min(box.bottom, boxes[n].bottom) - std::max(box.top, boxes[n].top) > 1)
            overlapping.push_back(texts[n] + " and " + texts.back());
        boxes.push_back(box);
        if (has_curves && group.find("paint-order") != std::string::npos)
          hiding.push_back(texts.back());
        const bool is_level = line.size() >= 2 && line.front().first != line.back().first;
        if (is_level && !texts.back().empty()) {
          if (std::exchange(y_is_old, false)) y_axis.clear();
          y_axis[number_of(texts.back())] = line[0].second;
        }
        line.clear();
      }
    }
    std::erase_if(curves, [](const DrawnCurve& curve) { return curve.points.empty(); });
    std::erase(texts, "");  // which gnuplot 6 leaves out
  }

  std::vector<DrawnCurve> curves;
  std::vector<std::string> texts;
  std::vector<std::string> clipped;      ///< texts that reach beyond the canvas
  std::vector<std::string> overlapping;  ///< texts over an earlier one; marks do, which are short
  std::vector<std::string> hiding;  ///< texts whose white edge is drawn over curves of their panel
};

}  // namespace rotor
