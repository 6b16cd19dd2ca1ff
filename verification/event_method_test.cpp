/// The event-located method: against the reference in quadruple precision, and on events that are
/// easily missed, doubled or misplaced.
#include "model/event_method.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "figures/csv.hpp"
#include "figures/recorder.hpp"
#include "figures/scene.hpp"
#include "model/summary.hpp"

namespace rotor {
namespace {

/// Keeps all that it is shown, without asking for more.
struct Witness : Observer {
  using Observer::see;
  void see(const Instant& at) override { instants.push_back(at); }

  std::vector<Instant> events(std::optional<Event> kind = std::nullopt) const {
    std::vector<Instant> found;
    for (const Instant& at : instants)
      if (at.event != Event::none && (!kind || at.event == *kind)) found.push_back(at);
    return found;
  }

  std::vector<Instant> instants;
};

struct Result {
  Witness witness;
  Instant last;
  Work work;
};

Result run_whole(const Scenario& scenario) {
  Result result;
  result.last = run(scenario, start(scenario), result.witness, result.work);
  return result;
}

/// A line of reference-data/high-precision.csv.
struct Landmark {
  std::string kind;
  double time_s{};
  State<double> state{};
  double time_error_s{}, state_error{};
};

std::vector<Landmark> reference(const std::string& run) {
  std::ifstream file(ROTOR_REFERENCE_DATA "/high-precision.csv");
  std::vector<Landmark> landmarks;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 11 || cells[0] != run) continue;
    Landmark landmark;
    landmark.kind = cells[1];
    landmark.time_s = std::stod(cells[2]);
    for (std::size_t i = 0; i < 6; ++i) landmark.state[i] = std::stod(cells[3 + i]);
    landmark.time_error_s = std::stod(cells[9]);
    landmark.state_error = std::stod(cells[10]);
    landmarks.push_back(landmark);
  }
  if (landmarks.empty()) throw std::runtime_error("the reference data have no run " + run);
  return landmarks;
}

/// Largest relative error of a state: of the position in parts of the clearance, of the velocity,
/// of the speed and of the angle in parts of themselves.
double relative_error(const State<double>& q, const State<double>& exact) {
  const double length = 3e-3, velocity = std::hypot(exact[3], exact[4]) + length * exact[5];
  return std::max({std::hypot(q[0] - exact[0], q[1] - exact[1]) / length,
                   std::hypot(q[3] - exact[3], q[4] - exact[4]) / velocity,
                   std::abs(q[5] / exact[5] - 1), std::abs(q[2] / exact[2] - 1)});
}

struct FrictionCase {
  double friction;
  std::string run;  ///< in the reference data
  std::size_t contacts;
  double time_accuracy_s;
};

void PrintTo(const FrictionCase& c, std::ostream* out) { *out << "mu = " << c.friction; }

class Rub : public testing::TestWithParam<FrictionCase> {};

TEST_P(Rub, AgreesWithTheReferenceInQuadruplePrecision) {
  const std::vector<Landmark> exact = reference(GetParam().run);
  const Result result =
      run_whole({.parameters = {.friction = GetParam().friction}, .tolerance = 1e-12});
  EXPECT_EQ(result.witness.events(Event::touch_down).size(), GetParam().contacts);
  EXPECT_LT(relative_error(result.last.state, exact.back().state), 1e-9);

  const std::vector<Instant> events = result.witness.events();
  ASSERT_EQ(events.size(), exact.size() - 1);  // the last landmark is the end
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(name_of(events[i].event), exact[i].kind) << i;
    EXPECT_NEAR(events[i].time_s, exact[i].time_s, GetParam().time_accuracy_s)
        << i << ' ' << exact[i].kind;
  }
}

// At mu = 0.08 the 41 contacts multiply a rounding error of the first by some 1e5 until the late
// ones, which are nearly tangential: double precision cannot tell their times to 1e-12 s.
INSTANTIATE_TEST_SUITE_P(Frictions, Rub,
                         testing::Values(FrictionCase{0.3, "fig03: mu = 0.3", 7, 1e-12},
                                         FrictionCase{0.2, "fig03: mu = 0.2", 12, 1e-12},
                                         FrictionCase{0.08, "fig03: mu = 0.08", 41, 3e-10}),
                         [](const auto& c) {
                           return "Contacts" + std::to_string(c.param.contacts);
                         });

TEST(Reference, IsGoodToTenDigitsAndMore) {
  for (const char* run : {"fig03: mu = 0.3", "fig03: mu = 0.2", "fig03: mu = 0.08"})
    for (const Landmark& landmark : reference(run)) {
      EXPECT_LT(landmark.time_error_s, 1e-14) << run << ' ' << landmark.time_s;
      EXPECT_LT(landmark.state_error, 1e-11) << run << ' ' << landmark.time_s;
    }
}

TEST(EventMethod, GainsADigitForEveryDigitOfTheToleranceDownToRounding) {
  const State<double> exact = reference("fig03: mu = 0.3").back().state;
  // The error of a run scatters by some factor around its trend. Rounding, multiplied by seven
  // contacts, stays below 1e-9.
  const double scatter = 20, rounding = 1e-9;
  double first = 0;
  for (int digits = 4; digits <= 13; ++digits) {
    const double tolerance = std::pow(10, -digits);
    const double error = relative_error(run_whole({.tolerance = tolerance}).last.state, exact);
    if (digits == 4) first = error;
    EXPECT_LT(error, scatter * first * tolerance / 1e-4 + rounding) << tolerance;
  }
}

TEST(EventMethod, GivesEightDigitsOfEverySummaryValueAtItsDefaultTolerance) {
  for (const double friction : {0.3, 0.2, 0.08}) {
    std::array<Summary, 2> summaries;
    for (std::size_t i = 0; i < 2; ++i) {
      Scenario scenario{.parameters = {.friction = friction}};
      if (i == 1) scenario.tolerance = 1e-13;
      SummaryObserver observer(scenario);
      Work work;
      run(scenario, start(scenario), observer, work);
      summaries[i] = observer.summary();
    }
    const auto& [ours, finer] = summaries;
    EXPECT_EQ(ours.collisions, finer.collisions);
    const auto expect_eight_digits = [&](const std::optional<double>& a,
                                         const std::optional<double>& b, const char* what) {
      ASSERT_EQ(a.has_value(), b.has_value()) << what;
      if (a) {
        EXPECT_NEAR(*a / *b, 1, 0.5e-8) << what << " at mu = " << friction;
      }
    };
    expect_eight_digits(ours.first_contact_s, finer.first_contact_s, "first contact");
    expect_eight_digits(ours.rolling_onset_s, finer.rolling_onset_s, "onset of rolling");
    expect_eight_digits(ours.rolling_onset_speed_Hz, finer.rolling_onset_speed_Hz, "its speed");
    expect_eight_digits(ours.rolling_onset_force_N, finer.rolling_onset_force_N, "its force");
    expect_eight_digits(ours.peak_normal_force_N, finer.peak_normal_force_N, "peak force");
    expect_eight_digits(ours.max_displacement_m, finer.max_displacement_m, "displacement");
    expect_eight_digits(ours.motor_off_s, finer.motor_off_s, "motor off");
    expect_eight_digits(ours.final_speed_Hz, finer.final_speed_Hz, "final speed");
    expect_eight_digits(ours.final_kinetic_energy_J, finer.final_kinetic_energy_J, "final T");
    expect_eight_digits(ours.final_q1_m, finer.final_q1_m, "final q1");
    expect_eight_digits(ours.final_q2_m, finer.final_q2_m, "final q2");
  }
}

TEST(EventMethod, RollsWithoutSlip) {
  const Scenario scenario{};
  struct Slip : Observer {
    explicit Slip(const Parameters& p) : ring(p) {}
    void see(const Instant& at) override {
      if (at.contact != ContactState::rolling) return;
      first = std::min(first, at.time_s);
      last = at.time_s;
      largest = std::max(largest, std::abs(ring.rim_point(at.motion()).slip_velocity));
    }
    void see(const Piece& piece) override {
      for (int i = 0; i < 4; ++i)
        see(piece.at(piece.from_s + (piece.until_s - piece.from_s) * i / 4));
    }
    bool wants_pieces(const double&, const double&) const override { return true; }

    Ring<double> ring;
    double first = 1e9, last = 0, largest = 0;
  } slip(scenario.parameters);
  Work work;
  run(scenario, start(scenario), slip, work);
  EXPECT_GT(slip.last - slip.first, 0.2);
  EXPECT_GT(slip.largest, 0);
  EXPECT_LT(slip.largest, 1e-9);
}

TEST(EventMethod, GivesTheSameBitsWhoeverWatches) {
  const Scenario scenario{};
  const Result unwatched = run_whole(scenario);
  Recorder recorder({.from_s = 29.11, .length_s = 0.05},
                    {find_column("time_s"), find_column("normal_force_N"), find_column("rho_m")},
                    scenario, 1e-4);
  Work work;
  EXPECT_EQ(run(scenario, start(scenario), recorder, work).state, unwatched.last.state);
  EXPECT_GT(recorder.table().rows(), 1000U);
}

TEST(EventMethod, GivesTheSameBitsWhereverTheRunUpWasInterrupted) {
  const Scenario scenario{};
  Witness witness;
  Work work;
  Instant at = start(scenario);
  for (const double stop : {2.2, 9.4, 14.15, 19.1}) at = run_up(scenario, at, stop, witness, work);
  EXPECT_EQ(run(scenario, at, witness, work).state, run_whole(scenario).last.state);
}

TEST(EventMethod, ShowsBothSidesOfEveryEventAndNoEventTwice) {
  const Result result = run_whole({.parameters = {.friction = 0.08}});
  const auto& seen = result.witness.instants;
  double last_event = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].event == Event::none) continue;
    ASSERT_GT(i, 0U);
    EXPECT_EQ(seen[i - 1].time_s, seen[i].time_s) << "before " << name_of(seen[i].event);
    EXPECT_GT(seen[i].time_s, last_event) << name_of(seen[i].event);
    last_event = seen[i].time_s;
  }
  // Each contact is begun once and released once before the next one; the 41st lasts.
  EXPECT_EQ(result.witness.events(Event::touch_down).size(), 41U);
  EXPECT_EQ(result.witness.events(Event::ring_clear).size(), 40U);
}

TEST(EventMethod, LocatesThePeakForceAsAZeroOfItsRate) {
  const Scenario scenario{};
  SummaryObserver observer(scenario);
  Work work;
  run(scenario, start(scenario), observer, work);
  // The greatest of densely taken samples stays below, by no more than their distance allows.
  struct Force : Observer {
    explicit Force(const Parameters& p) : ring(p) {}
    void see(const Instant&) override {}
    void see(const Piece& piece) override {
      for (int i = 0; i <= 200; ++i) {
        const Instant at = piece.at(piece.from_s + (piece.until_s - piece.from_s) * i / 200);
        if (at.contact == ContactState::rolling || at.contact == ContactState::sliding)
          largest = std::max(largest, -ring.normal_force(ring.rim_point(at.motion())));
      }
    }
    bool wants_pieces(const double& from_s, const double&) const override { return from_s > 29.1; }
    Ring<double> ring;
    double largest = 0;
  } force(scenario.parameters);
  run(scenario, start(scenario), force, work);
  EXPECT_LE(force.largest, *observer.summary().peak_normal_force_N * (1 + 1e-9));
  EXPECT_NEAR(force.largest / *observer.summary().peak_normal_force_N, 1, 1e-5);
}

// A rotor without unbalance, gravity and damping: O oscillates along a line, with the
// eigenfrequency of the supports, and touches the ring if its amplitude exceeds the clearance.
class Oscillation : public testing::Test {
 protected:
  Oscillation() {
    scenario_.parameters.eccentricity = 0;
    scenario_.parameters.gravity = 0;
    scenario_.parameters.support_damping = 0;
    scenario_.parameters.contact_damping = 0;
    scenario_.parameters.torque = 0;
    scenario_.parameters.friction = 0;
    scenario_.parameters.separates = false;
    scenario_.until = 0.2;
  }

  double clearance() const { return Ring<double>(scenario_.parameters).clearance; }
  double frequency() const {
    return std::sqrt(scenario_.parameters.support_stiffness / scenario_.parameters.mass);
  }

  /// From the centre, with the velocity that gives this amplitude.
  Instant with_amplitude(double amplitude) const {
    Instant at = start(scenario_);
    at.state = {0, 0, 0, 0.6 * amplitude * frequency(), 0.8 * amplitude * frequency(), 0};
    return at;
  }

  Result run_from(const Instant& at) const {
    Result result;
    EventMethod<double> method(scenario_, scenario_.tolerance, result.witness, result.work);
    result.last = method.rub(at, scenario_.until);
    return result;
  }

  Scenario scenario_;
};

TEST_F(Oscillation, TouchesAtTheTimeOfTheClosedForm) {
  const Result result = run_from(with_amplitude(2 * clearance()));
  const double touch = std::asin(0.5) / frequency();
  const auto contacts = result.witness.events(Event::touch_down);
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts.front().time_s, touch, 1e-13);  // default tolerance over a few steps
  EXPECT_NEAR(contacts.front().motion().displacement.norm(), clearance(), 1e-18);
  EXPECT_GE(contacts.front().motion().displacement.norm() - clearance(), -1e-18);
}

TEST_F(Oscillation, GlancingContactIsMissedByNoStepSize) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    scenario_.tolerance = tolerance;
    // The tolerance of a step is a part of 1/300 of the clearance; hundreds of steps may add up.
    const double margin = tolerance;
    EXPECT_FALSE(run_from(with_amplitude(clearance() * (1 + margin)))
                     .witness.events(Event::touch_down)
                     .empty())
        << tolerance;
    EXPECT_TRUE(run_from(with_amplitude(clearance() * (1 - margin))).witness.events().empty())
        << tolerance;
  }
}

TEST_F(Oscillation, ShortContactsBetweenLongFlightsAreAllFound) {
  // Half a period of the supports, 50 ms, between contacts of 0.25 ms: four in 0.2 s.
  const Result result = run_from(with_amplitude(1.001 * clearance()));
  EXPECT_EQ(result.witness.events(Event::touch_down).size(), 4U);
}

TEST_F(Oscillation, ContactAtTheEndOfARunIsSeenOnce) {
  const Instant first = with_amplitude(2 * clearance());
  const double touch = run_from(first).witness.events(Event::touch_down).front().time_s;
  for (const double end : {touch, std::nextafter(touch, 0), std::nextafter(touch, 1)}) {
    Result result;
    EventMethod<double> method(scenario_, scenario_.tolerance, result.witness, result.work);
    const Instant at = method.rub(first, end);
    method.rub(at, touch + 1e-4);
    EXPECT_EQ(result.witness.events(Event::touch_down).size(), 1U) << end - touch;
  }
}

TEST_F(Oscillation, HeadOnImpactAtZeroSlipGoesStraightToRolling) {
  scenario_.parameters.friction = 0.3;
  Instant first = start(scenario_);
  first.state[3] = 2 * clearance() * frequency();  // along an axis, where the slip is zero exactly
  const Result result = run_from(first);
  const auto contacts = result.witness.events(Event::touch_down);
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts.front().contact, ContactState::rolling);
}

TEST_F(Oscillation, ImpactsAtASlipOfRoundingSizeDoNotChatter) {
  scenario_.parameters.friction = 0.3;
  scenario_.until = 2;
  const Result result = run_from(with_amplitude(2 * clearance()));
  // A contact every 16.8 ms, of no more events than touch-down, rolling, break-away, release,
  // clear.
  EXPECT_EQ(result.witness.events(Event::touch_down).size(), 119U);
  EXPECT_LE(result.witness.events().size(), 5 * 119U);
}

TEST_F(Oscillation, MotorOffAndContactAtOneInstantBothHappenOnce) {
  scenario_.parameters.torque = 0.3;
  Instant first = with_amplitude(2 * clearance());
  const Instant touch = run_from(first).witness.events(Event::touch_down).front();
  for (const double shift : {-1e-16, 0., 1e-16}) {
    scenario_.parameters.motor_off_Hz =
        touch.state[5] / boost::math::constants::two_pi<double>() * (1 + shift);
    scenario_.until = touch.time_s + 1e-4;
    const Result result = run_from(first);
    EXPECT_EQ(result.witness.events(Event::touch_down).size(), 1U) << shift;
    EXPECT_EQ(result.witness.events(Event::motor_off).size(), 1U) << shift;
  }
}

TEST_F(Oscillation, KeepsItsEnergyThroughElasticImpacts) {
  scenario_.parameters.contact_stiffness = 1e6;
  const Instant first = with_amplitude(2 * clearance());
  const auto energy = [&](const Instant& at) {
    const auto motion = at.motion();
    const double rho = motion.displacement.norm();
    const double indentation = std::max(0., rho - clearance());
    return kinetic_energy(at.body, motion) +
           scenario_.parameters.support_stiffness * rho * rho / 2 +
           scenario_.parameters.contact_stiffness * indentation * indentation / 2;
  };
  const Result result = run_from(first);
  EXPECT_GT(result.witness.events(Event::touch_down).size(), 3U);
  EXPECT_NEAR(energy(result.last) / energy(first), 1, 1e-9);
}

TEST(EventMethod, EvaluatesNoContactLawWhileTheRotorStaysClearOfTheRing) {
  const Result result = run_whole({.parameters = {.separation_time = 9.4}, .until = 9.8});
  EXPECT_EQ(result.work.contact_evaluations, 0);
}

TEST(EventMethod, SaysWhereAMotionThatIsNotFiniteEndsIt) {
  Witness witness;
  Work work;
  const Scenario scenario{};
  Instant at = start(scenario);
  at.time_s = 1.5;
  at.state[4] = std::numeric_limits<double>::quiet_NaN();
  try {
    EventMethod<double>(scenario, scenario.tolerance, witness, work).rub(at, 2);
    FAIL() << "went on with a motion that is not finite";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("t = 1.5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rotor
