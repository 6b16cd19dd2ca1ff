/// The drawn figures: the curves in the SVG are the data's, and the numbers in it the engine's.
/// `make approve` copies them into the gallery, figures/paper/README.md.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/paper_figures.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

constexpr std::array sets_of_equations = {Equations::published, Equations::consistent};

class Pictures : public CommandLine, public testing::WithParamInterface<Figure> {
 protected:
  const Figure& figure() const { return GetParam(); }
  fs::path csv(Equations equations) const {
    return FigureFolder::of(equations).csv(figure().number);
  }

  /// Draws it as make does. A missing column is an error of gnuplot.
  DrawnPicture drawn() const {
    const auto [status, output] =
        shell(fmt::format("'{0}/../draw.sh' a.svg \"data_published = '{1}'; data_consistent = "
                          "'{2}';\" '{0}/fig{3:02}.gp' >/dev/null",
                          ROTOR_SCENES, csv(sets_of_equations[0]).string(),
                          csv(sets_of_equations[1]).string(), figure().number));
    EXPECT_EQ(status, 0);
    EXPECT_EQ(output, "");
    DrawnPicture picture(content("a.svg"));
    if (picture.x.size() < 2 || figure().number == 9)
      picture.curves.clear();  // a scheme, or parts of curves
    return picture;
  }

  /// A possible curve of a run's data, or of minus them: over time, or an orbit, in the axes'
  /// units.
  struct Candidate {
    Equations equations;
    std::string run;
    bool is_orbit;
    Points points;
  };
  std::vector<Candidate> candidates() const {
    const auto scale = [](const std::string& column) {
      return column.ends_with("_m") ? 1e3 : column.ends_with("_N") ? 1e-3 : 1.;
    };
    std::vector<Candidate> all;
    for (const Equations equations : sets_of_equations) {
      auto rows = read_csv(csv(equations));
      if (figure().number == 8) {  // until a fixed time after the onset of rolling
        const auto onset = std::ranges::find_if(
            rows, [](const CsvRow& row) { return row.number("contact_state") == 2; });
        const auto end = onset->number("time_s") + 7e-3L;
        std::erase_if(rows, [&](const CsvRow& row) { return row.number("time_s") >= end; });
      }
      for (const SceneRun& run : figure().scene.runs)
        for (const Column* its : figure().scene.columns) {
          const std::string column(its->name);
          if (column == "time_s" || column == "y_a_m") continue;
          const std::string abscissa = column == "x_a_m" ? "y_a_m" : "time_s";
          Candidate candidate{equations, run.name, abscissa == "y_a_m", {}};
          for (const CsvRow& row : rows)
            if (row["run"] == run.name)
              candidate.points.emplace_back(
                  scale(abscissa) * static_cast<double>(row.number(abscissa)),
                  scale(column) * static_cast<double>(row.number(column)));
          all.push_back(candidate);
          for (auto& [x, y] : candidate.points) y = -y;
          if (!candidate.is_orbit) all.push_back(candidate);
        }
    }
    return all;
  }

  /// From a place to the line through some points, pixels.
  static double distance(const Points& line, const Points::value_type& place) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 1; n < line.size(); ++n) {
      const Eigen::Vector2d from(line[n - 1].first, line[n - 1].second),
          along = Eigen::Vector2d(line[n].first, line[n].second) - from,
          to = Eigen::Vector2d(place.first, place.second) - from;
      const double length = along.squaredNorm(),
                   share = length > 0 ? std::clamp(to.dot(along) / length, 0., 1.) : 0;
      least = std::min(least, (to - share * along).norm());
    }
    return least;
  }

  /// Points at its ends, and where it extends furthest to each side.
  static bool is_drawn(const Candidate& candidate, const DrawnCurve& curve) {
    const auto second = &Points::value_type::second;
    const auto& points = candidate.points;
    const auto [left, right] = std::ranges::minmax_element(points);
    const auto [lowest, highest] = std::ranges::minmax_element(points, {}, second);
    for (const auto& at : {points.front(), points.back(), *left, *right, *lowest, *highest}) {
      const double x = pixel(curve.x, at.first), y = pixel(curve.y, at.second);
      if (distance(curve.points, {x, y}) > 0.5) return false;
    }
    const auto [top, bottom] = std::ranges::minmax_element(curve.points, {}, second);
    const double height =
        std::abs(pixel(curve.y, lowest->second) - pixel(curve.y, highest->second));
    return std::abs(bottom->second - top->second - height) < 0.5;
  }

  /// The picture in the gallery has the same texts, and curves that extend as far.
  void expect_preview(const DrawnPicture& picture) const {
    const fs::path file = fs::path(ROTOR_SCENES) / preview_of(figure().number);
    if (std::getenv("ROTOR_APPROVE"))
      fs::copy_file(folder_ / "a.svg", file, fs::copy_options::overwrite_existing);
    std::ifstream stream(file, std::ios::binary);
    const DrawnPicture preview(std::string(std::istreambuf_iterator<char>(stream), {}));
    const std::string hint = file.string() + "\nIf this is as it should be: make approve";
    EXPECT_EQ(preview.texts, picture.texts) << hint;
    ASSERT_TRUE(picture.curves.empty() || preview.curves.size() == picture.curves.size()) << hint;
    for (std::size_t n = 0; n < picture.curves.size(); ++n)
      for (const auto& member : {&Points::value_type::first, &Points::value_type::second}) {
        const auto ends = [&](const DrawnPicture& of) {
          const auto [low, high] = std::ranges::minmax(of.curves[n].points, {}, member);
          return std::pair(low.*member, high.*member);
        };
        EXPECT_NEAR(ends(preview).first, ends(picture).first, 0.5) << hint;
        EXPECT_NEAR(ends(preview).second, ends(picture).second, 0.5) << hint;
      }
  }

  std::vector<std::string> numbers(Equations equations) const;
};

TEST_P(Pictures, HaveTheCurvesOfEachRunAndItsNumbers) {
  const DrawnPicture picture = drawn();
  expect_preview(picture);
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  const auto all = candidates();
  std::set<std::pair<bool, std::string>> seen;
  for (const DrawnCurve& curve : picture.curves) {
    bool is_known = false;  // where runs nearly coincide, they may match each other's curves
    for (const Candidate& candidate : all) {
      if (!is_drawn(candidate, curve)) continue;
      const bool is_printed = candidate.equations == Equations::published;
      seen.insert({is_printed, candidate.run});
      // In orbits x_a points downwards, y_a to the right, and a millimetre is as long on both axes.
      const double right = pixel(curve.x, 1) - pixel(curve.x, 0);
      const double down = pixel(curve.y, 1) - pixel(curve.y, 0);
      EXPECT_GT(right, 0);
      EXPECT_TRUE(!candidate.is_orbit || std::abs(down - right) < 1e-3 * right);
      is_known = true;
    }
    EXPECT_TRUE(is_known) << "a curve that is no run's";
  }
  // The published method is shown with the equations as printed only.
  for (const SceneRun& run : figure().scene.runs)
    for (const bool is_printed : {true, false})
      EXPECT_TRUE(picture.curves.empty() || seen.contains({is_printed, run.name}) ||
                  (run.scenario.method == Method::rk4 && !is_printed))
          << run.name;
  for (const Equations equations : sets_of_equations)
    for (const std::string& number : numbers(equations)) {
      bool is_shown = false;  // and not in the colour of the other set
      for (std::size_t n = 0; n < picture.texts.size(); ++n)
        is_shown |= picture.texts[n].find(number) != std::string::npos &&
                    picture.colours[n] !=
                        (equations == sets_of_equations[0] ? "rgb(179,71,0)" : "rgb(0,114,178)");
      EXPECT_TRUE(is_shown) << number << ", " << name_of(equations);
    }
}

/// The numbers that a picture must show, from the engine.
std::vector<std::string> Pictures::numbers(Equations equations) const {
  std::vector<Summary> of;
  std::vector<EventRecorder> events;
  for (const SceneRun& its : figure().scene.runs) {
    Scenario scenario = its.scenario;
    if (scenario.method == Method::rk4) continue;
    scenario.equations = equations;
    SummaryObserver summary(scenario);
    ObserverGroup observers;
    observers.add(summary);
    observers.add(events.emplace_back());
    run(scenario, observers);
    of.push_back(summary.summary());
  }
  const auto force = [&](std::size_t n) { return of[n].peak_normal_force_N.value_or(0) / 1e3; };
  const auto change = [&](std::size_t n) {
    const double percent = std::round(100 * (force(n) / force(0) - 1));
    return fmt::format("{}{} %", percent < 0 ? "\u2212" : "+", std::abs(percent));
  };
  const auto largest = [&](std::size_t n) { return fmt::format("{:.1f} kN", force(n)); };
  const auto share = [&](const std::string& number, const std::string& population) {
    for (const CsvRow& row : read_csv(fs::path(ROTOR_REFERENCE_DATA) / "ensembles.csv"))
      if (row["number"] == number && row["population"] == population &&
          row["equations"] == name_of(equations))
        return std::stod(row["holds"]);
    throw std::runtime_error(number);
  };
  const double lost_at_Hz = of[0].speed_at_mass_loss_Hz.value_or(0),
               after_mm = 1e3 * of[0].max_displacement_m.value_or(0);
  switch (figure().number) {
    case 2:
      return {fmt::format("largest ρ = {:.2f} mm at", 1e3 * of[0].max_displacement_before_loss_m)};
    case 3:
      return {largest(0), largest(1), largest(2)};
    case 5:
      return {largest(0), fmt::format("at {:.4f} s", *of[0].rolling_onset_s),
              fmt::format("{:.1f} ms", 1e3 * (*of[0].rolling_onset_s - *of[0].first_contact_s)),
              fmt::format("{:.2f} ms", 1e3 * (*of[0].peak_time_s - *of[0].rolling_onset_s))};
    case 6: {
      const auto energy = [](const Instant& at) { return kinetic_energy(at.body, at.motion()); };
      const double after = energy(events[0].first(Event::mass_loss)),
                   rolling = energy(events[0].first(Event::rolling_onset));
      return {fmt::format("{:.0f} J", energy(events[0].before_mass_loss())),
              fmt::format("{:.0f} J", after), fmt::format("{:.0f} J", rolling)};
    }
    case 7:
      return {fmt::format("from {:.4f} s", *of[0].rolling_onset_s)};
    case 10: {
      const Instant& onset = events[0].first(Event::rolling_onset);
      const double rho = std::hypot(onset.state[0], onset.state[1]);
      const double rolling_Hz = *of[0].rolling_onset_speed_Hz * 0.06 / rho;  // Eq. (26)
      return {fmt::format("{:.5f}", *of[0].rolling_onset_s),
              fmt::format("{:.2f} Hz", *of[0].rolling_onset_speed_Hz),
              fmt::format("{:.1f} Hz", rolling_Hz),
              fmt::format("{:.2f} m/s", two_pi * rolling_Hz * rho)};
    }
    case 11:
      return {largest(0), largest(1), largest(2), change(1), change(2)};
    case 12:
      return {largest(0), fmt::format("{:.4f} s", *of[0].peak_time_s),
              fmt::format("{:.1f} Hz", lost_at_Hz)};
    case 13:
      return {of[0].peak_normal_force_N
                  ? fmt::format("largest |Fn| {:.1f} kN at {:.4f} s", force(0), *of[0].peak_time_s)
                  : "no contact",
              fmt::format("{:.0f} % roll", 100 * share("rolls_75", "b")),
              fmt::format("f = {:.1f} Hz", lost_at_Hz)};
    case 14:
      return {fmt::format("f = {:.1f} Hz", lost_at_Hz), fmt::format("{:.3f} mm", after_mm),
              fmt::format("{:.0f} %", 100 * share("contacts_9", "a")),
              fmt::format("{:.0f} %", 100 * share("contacts_9", "b"))};
    case 15:
      return {fmt::format("f = {:.1f} Hz", lost_at_Hz), fmt::format("{:.3f} mm", after_mm)};
    case 17:
      return {fmt::format("{:.2f} mm", after_mm),
              fmt::format("{:.2f} mm", 1e3 * of[1].max_displacement_before_loss_m),
              fmt::format("{:.1f} Hz", lost_at_Hz)};
    default:
      return {};
  }
}

INSTANTIATE_TEST_SUITE_P(Approved, Pictures, testing::ValuesIn(paper_figures()),
                         [](const auto& of) { return fmt::format("Fig{:02}", of.param.number); });

}  // namespace
}  // namespace rotor
