/// Reads curves, axes and texts from an SVG that gnuplot has drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rotor {

/// An axis as its labelled grid lines tell it: pixels over values.
using Tics = std::map<double, double>;

inline double pixel(const Tics& axis, double value) {
  const auto& [a, at_a] = *axis.begin();
  const auto& [b, at_b] = *axis.rbegin();
  return at_a + (value - a) / (b - a) * (at_b - at_a);
}

struct DrawnCurve {
  std::vector<std::pair<double, double>> points;  ///< pixels
  Tics y;
  std::string colour = {};
};

using Points = std::vector<std::pair<double, double>>;

/// The corners of a path: M1.5,2 L3,4 ...
inline Points corners(std::string path) {
  std::replace_if(
      path.begin(), path.end(), [](char c) { return c == 'M' || c == 'L' || c == ','; }, ' ');
  std::istringstream numbers(path);
  Points points;
  for (double x = 0, y = 0; numbers >> x >> y;) points.emplace_back(x, y);
  return points;
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

/// A number as a tic label has it, whose minus sign is the typographer's.
inline double number_of(std::string label) {
  const std::string minus = "\u2212";
  if (label.starts_with(minus)) label.replace(0, minus.size(), "-");
  return std::stod(label);
}

inline bool is_closed(const Points& path) {
  return std::hypot(path.front().first - path.back().first,
                    path.front().second - path.back().second) < 0.1;
}

/// An arrow's head is a triangle that begins and ends in the middle of its base.
inline bool is_arrowhead(const Points& path) {
  if (path.size() != 5 || path.front() != path.back()) return false;
  return std::abs(path[1].first + path[3].first - 2 * path[0].first) < 0.1 &&
         std::abs(path[1].second + path[3].second - 2 * path[0].second) < 0.1;
}

/// Whether a text reaches beyond a canvas that begins at 0. Its group states where it is anchored,
/// its size and whether it stands upright; its letters are taken to be half as wide as they are
/// high (DejaVu Sans has 0.6 on average).
inline bool is_clipped(const std::string& group, const std::string& text,
                       Points::value_type canvas) {
  const auto after = [&](std::string_view key) {
    const std::size_t at = group.find(key);
    return at == std::string::npos ? std::string() : group.substr(at + key.size(), 30);
  };
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
  const double length = 0.5 * std::stod(after("font-size=\"")) * static_cast<double>(letters);
  const std::string anchor = after("text-anchor=\"");
  const double before = anchor.starts_with("start") ? 0 : anchor.starts_with("end") ? 1 : 0.5;
  const auto [x, y] = corners(after("translate(")).front();
  if (group.find("rotate(270") != std::string::npos)
    return y + before * length > canvas.second || y - (1 - before) * length < 0;
  return x - before * length < 0 || x + (1 - before) * length > canvas.first || y < 0 ||
         y > canvas.second;
}

struct Arrow {
  std::pair<double, double> base, tip;  ///< of its head, pixels
};

/// The arrows with two flat heads in a path: where each begins and ends. The head at its end comes
/// first.
inline std::vector<Points> brackets_in(const Points& path) {
  std::vector<Points> brackets;
  for (std::size_t n = 0; n + 8 <= path.size(); n += 8)
    if (path[n + 1] == path[n + 7] && path[n + 4] == path[n + 6])
      brackets.push_back({path[n + 4], path[n + 1]});
  return brackets;
}

/// A picture as gnuplot's SVG has it: each grid line stands before its label, and the axes of a
/// panel before its curves. All panels have the x axis of the last one.
struct DrawnPicture {
  explicit DrawnPicture(const std::string& svg) {
    Tics y_axis;
    Points line;  // the last one of the grid; the key may interrupt it
    bool in_curve = false, y_is_old = false;
    std::string group;
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
        std::string title = without_tags(between(at, "<title>", "</title>"));
        if (!title.starts_with("gnuplot_plot_")) keys.push_back(std::move(title));
        in_curve = y_is_old = true;
        curves.push_back({{}, y_axis});
      } else if (tag.starts_with("<path")) {
        const std::string head = svg.substr(at, svg.find(" d='", at) - at);
        const std::string colour = head.substr(0, head.find(')'));  // of its stroke
        const Points points = corners(between(at, " d='", "'"));
        if (head.find("gridline") != std::string::npos) {
          line = points;
          in_curve = false;
        } else if (points.size() == 2 && head.find("stroke-dasharray") != std::string::npos &&
                   points[0].second == points[1].second) {
          levels.push_back(points[0].second);
        } else if (!in_curve && points.size() == 2 && points[0].first == points[1].first &&
                   colour.find("rgb") != std::string::npos) {
          uprights.push_back(points[0].first);
        } else if (points.size() == 2 && head.find("stroke-dasharray") != std::string::npos) {
          dashes.push_back(points);
        } else if (!in_curve && points.size() > 20 && is_closed(points) &&
                   head.find("stroke-dasharray") != std::string::npos) {
          circles.push_back(points);
        } else if (is_arrowhead(points)) {
          arrows.push_back({points[0], points[2]});
        } else if (in_curve && points.size() > curves.back().points.size()) {
          curves.back().points = points;  // the shorter one is the key's sample
          curves.back().colour = colour;
        } else if (!in_curve && points.size() == 2 && colour.find("rgb") != std::string::npos) {
          samples.push_back(colour);
        } else if (!in_curve) {
          for (const Points& bracket : brackets_in(points)) brackets.push_back(bracket);
        }
      } else if (tag.starts_with("<use xlink:href='#gpPt") && tag.find("' tr") != tag.npos) {
        marks.push_back(corners(between(at, "translate(", ")")).front());
        if (tag.starts_with("<use xlink:href='#gpPt3'")) squares.push_back(marks.back());
        if (tag.starts_with("<use xlink:href='#gpPt1'")) crosses.push_back(marks.back());
      } else if (tag.starts_with("<text")) {
        texts.push_back(without_tags(between(at, ">", "</text>")));
        places.push_back(corners(group.substr(group.find('(') + 1)).front());
        if (is_clipped(group, texts.back(), canvas)) clipped.push_back(texts.back());
        if (line.size() >= 2 && !texts.back().empty()) {
          const double value = number_of(texts.back());
          const bool upright = line.front().first == line.back().first;
          if (!upright && std::exchange(y_is_old, false)) y_axis.clear();
          (upright ? x : y_axis)[value] = upright ? line[0].first : line[0].second;
        }
        line.clear();
      }
    }
    std::erase_if(curves, [](const DrawnCurve& curve) { return curve.points.size() < 10; });
  }

  Tics x;
  std::vector<DrawnCurve> curves;
  std::vector<Arrow> arrows;
  std::vector<Points> brackets;      ///< beginning and end of arrows with flat heads
  std::vector<std::string> samples;  ///< colours of full lines that are no curves
  std::vector<Points> circles;       ///< dashed and closed, that are no curves
  Points marks;                      ///< all symbols
  Points squares;                    ///< symbols of points that were read off, the key's included
  Points crosses;                    ///< symbols of mass losses, the key's included
  std::vector<std::string> texts;
  Points places;                     ///< of the texts
  std::vector<std::string> clipped;  ///< texts that reach beyond the canvas
  std::vector<std::string> keys;     ///< titles of curves, in their order; each key is drawn twice
  std::vector<double> levels;        ///< of dashed horizontal lines
  std::vector<double> uprights;      ///< of vertical lines
  std::vector<Points> dashes;        ///< other dashed lines, from end to end
};

}  // namespace rotor
