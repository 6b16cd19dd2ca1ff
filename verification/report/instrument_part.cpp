/// The accident for the interactive part of the page: the paper's cases in the form of the engine's
/// answers, and the map of outcomes.
#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "figures/data/csv.hpp"
#include "figures/data/read_csv.hpp"
#include "verification/report/document.hpp"
#include "verification/report/engine/explorer.hpp"

namespace rotor {
namespace {

/// The settings of the map's pins.
const std::vector<Options> cases = {{},
                                    {{"friction", "0.2"}},
                                    {{"friction", "0.08"}},
                                    {{"mass-loss-time", "19.1"}},
                                    {{"mass-loss-time", "14.15"}},
                                    {{"mass-loss-time", "9.4"}},
                                    {{"mass-loss-time", "2.2"}}};

/// Largest error of curves, relative to their ranges: a pixel or two.
constexpr double closeness = 8e-3;

/// The kept part of the rolling or sliding at the end of a run, s; the rest is similar.
constexpr double kept_s = 0.012;

/// Start of the last kind of motion of a run.
double last_change_s(const Json& run) {
  const Json& onset_s = run["summary"]["rolling_onset_s"];
  if (!onset_s.is_null()) return onset_s;
  double last_s = run["until_s"];
  for (const Json& event : run["events"]) {
    if (event["event"] == "touch_down") last_s = event["time_s"];
    if (event["event"] == "release") last_s = run["until_s"];
  }
  return last_s;
}

std::string base64(std::string bytes) {
  using namespace boost::archive::iterators;
  using Letter = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.append(missing, 0);
  std::string text(Letter(bytes.cbegin()), Letter(bytes.cend()));
  return text.replace(text.size() - missing, missing, missing, '=');
}

/// Columns by their names, each in steps of a 65535th of its range: [least, greatest, steps].
Json quantised(const Table& table, const Json& names, double until_s) {
  Json columns;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows() && table.row(row)[0] <= until_s; ++row)
      values.push_back(table.row(row)[i]);
    const auto [least, greatest] = std::ranges::minmax(values);
    const double step = greatest > least ? (greatest - least) / 65535 : 1;
    std::string bytes;
    for (const double value : values) {
      const auto steps = static_cast<unsigned>(std::lround((value - least) / step));
      bytes += static_cast<char>(steps);
      bytes += static_cast<char>(steps >> 8U);
    }
    columns[names[i].get<std::string>()] = {least, greatest, base64(bytes)};
  }
  return columns;
}

Json runs_json() {
  Explorer explorer;
  Json runs = Json::array();
  for (const Set& set : sets)
    for (Options options : cases) {
      if (set.equations != Scenario().equations) options["equations"] = set.name;
      const Picture picture = explorer.run(options, closeness);
      Json run = picture.metadata;
      const double until_s = std::min(run["until_s"].get<double>(), last_change_s(run) + kept_s);
      run["until_s"] = until_s;
      run["options"] = options;
      run["motion"] = quantised(picture.motion, picture.metadata["motion"], until_s);
      for (Json& event : run["events"])
        event = {{"event", event["event"]}, {"time_s", event["time_s"]}};
      runs.push_back(run);
    }
  return runs;
}

/// Outcomes by their places among `outcomes`, row after row; a rotor that touches the ring before
/// the loss has no result, which counts as stalled.
Json maps_json(const std::filesystem::path& csv) {
  std::map<std::string, Json> maps;
  for (const CsvRow& row : read_csv(csv)) {
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    const Json point = {number("start_speed_Hz"), number("friction")};
    Json& map = maps.try_emplace(row["equations_varied"], Json{{"from", point}, {"cells", Json()}})
                    .first->second;
    if (map["to"].is_null() || point[1] != map["to"][1]) map["cells"].push_back("");
    map["to"] = point;
    const std::string name = row["outcome"].empty() ? "stalled" : row["outcome"];
    std::size_t code = 0;
    while (outcomes.at(code).name != name) ++code;
    map["cells"].back().get_ref<std::string&>() += std::to_string(code);
  }
  return maps;
}

/// The lines of the map, as gnuplot prints them: `line SET NUMBER`, then the points of its parts,
/// parted by empty lines. Points are left out that a straight line misses by less than half a
/// pixel.
Json lines_json(const std::filesystem::path& printed) {
  namespace geometry = boost::geometry;
  constexpr double width_Hz = 180, height = 0.5, half_a_pixel = 0.5 / 800;
  geometry::model::linestring<geometry::model::d2::point_xy<double>> part, kept;
  Json lines = Json::array();
  std::string set, line;
  int number = 0;
  const auto end_part = [&] {
    geometry::simplify(part, kept, half_a_pixel);
    Json points = Json::array();
    for (const auto& point : kept) points.push_back({point.x() * width_Hz, point.y() * height});
    if (!points.empty()) lines.push_back({{"set", set}, {"line", number - 1}, {"points", points}});
    part.clear();
  };
  for (std::ifstream text(printed); std::getline(text, line);) {
    std::istringstream words(line);
    double x = 0, y = 0;
    if (words >> x >> y) {
      part.emplace_back(x / width_Hz, y / height);
      continue;
    }
    end_part();
    if (line.starts_with("line ")) std::istringstream(line.substr(5)) >> set >> number;
  }
  end_part();
  return lines;
}

}  // namespace

Json instrument_json(const std::filesystem::path& report) {
  return {{"runs", runs_json()},
          {"maps", maps_json(report / "map.csv")},
          {"lines", lines_json(report / "lines.txt")}};
}

}  // namespace rotor
