/// The engine against reference-data/independent.csv, from `make validate`, and measured rebounds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "figures/data/read_csv.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/content.hpp"
#include "verification/support/observers.hpp"
#include "verification/validation/cases.hpp"

namespace rotor {
namespace {

TEST(Independent, CodeGivesTheSameAccidentsUnlessItsInputHasAMistake) {
  std::map<std::pair<std::string, std::string>, CsvRow> table;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/independent.csv"))
    table.emplace(std::pair(row["case"], row["quantity"]), row);
  const std::vector<ComparedAccident> all = accidents();
  const std::vector<Finding> with = with_lever(all[0]).findings(all[0]);
  for (const ComparedAccident& accident : all)
    for (const Finding& ours : by_engine(accident).findings(accident)) {
      const auto row = table.extract(std::pair(accident.name, ours.quantity));
      const std::string what = accident.name + ": " + ours.quantity;
      if (accident.mistaken && (row.empty() || row.mapped()["liggghts"].empty())) continue;
      ASSERT_FALSE(row.empty()) << what;
      const auto theirs = [&](const char* column) {
        return static_cast<double>(row.mapped().number(column));
      };
      const double best = theirs(accident.mistaken ? "liggghts" : "liggghts_finer");
      EXPECT_EQ(std::abs(ours.difference(best)) > ours.allowed, accident.mistaken) << what;
      EXPECT_LT(std::abs(ours.difference(theirs("engine"))), 1e-6) << what;  // has eight digits
      if (&accident != all.data() || ours.lever_allowed == 0) continue;
      Finding lever = ours;
      lever.value = find(with, ours.quantity);
      EXPECT_LT(std::abs(lever.difference(theirs("liggghts_finer"))), ours.lever_allowed) << what;
    }
  EXPECT_TRUE(table.empty()) << table.begin()->first.first;
}

// The gap (t - 1)(t - 2) is straight between samples to a quarter of the square of their distance.
TEST(Course, FindsContactBetweenSamples) {
  Course course;
  constexpr double distance = 0.03;
  for (double time_s = 0; time_s < 3; time_s += distance) {
    const double gap = (time_s - 1) * (time_s - 2);
    course.add({time_s, gap, std::max(0., -gap), 0, 0}, 0);
  }
  const auto values = course.values({});
  EXPECT_NEAR(values.at("touch_down_1_s"), 1, distance * distance);
  EXPECT_NEAR(values.at("contact_time_s"), 1, distance * distance);
  EXPECT_NEAR(values.at("peak_normal_force_N"), 0.25, distance * distance);
  EXPECT_NEAR(values.at("peak_time_s"), 1.5, distance / 2);
}

TEST(MeasuredRebounds, AgreeWhereTheSphereSlides) {
  const std::string page = content_of(ROTOR_SOURCES "/verification/validation/README.md");
  int sliding = 0;
  double steepest = 0;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/measured-rebounds.csv")) {
    const Rebound ours = rebound(static_cast<double>(row.number("angle_deg")));
    const auto theirs = static_cast<double>(row.number("tangential_restitution"));
    steepest = std::tan(static_cast<double>(row.number("angle_deg")) * two_pi / 360);
    const std::string shown = fmt::format(
        "| {} | {:.1f} | {:.3f} | {:.3f} | {:.2f} | {} |\n", row["angle_deg"], steepest, theirs,
        ours.tangential_restitution, (1 - ours.tangential_restitution) / (1 - theirs),
        ours.slides ? "slides" : "sticks");
    EXPECT_NE(page.find(shown), std::string::npos) << shown;
    sliding += ours.slides ? 1 : 0;
    // Points read off a plot differ by 0.5 %. A sphere that sticks has tangential compliance.
    EXPECT_NEAR(ours.tangential_restitution / theirs, 1, ours.slides ? 0.01 : 0.20)
        << row["angle_deg"];
  }
  EXPECT_EQ(sliding, 5);

  // No measured impact is as oblique as those of the paper's accident, until rolling.
  Scenario accident;
  const EventRecorder seen = recorded(accident);
  const Ring<double> ring(accident.parameters);
  const double rolls_s = seen.first(Event::rolling_onset).time_s;
  for (const Instant& at : seen.events(Event::touch_down)) {
    if (at.time_s > rolls_s) continue;
    const RimPoint<double> k = ring.rim_point(at.motion());
    EXPECT_GT(std::abs(k.slip_velocity / k.normal_velocity), steepest) << at.time_s;
  }
}

}  // namespace
}  // namespace rotor
