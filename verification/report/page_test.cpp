/// The reviewer's page: its texts, verdicts, points and pictures.
#include "verification/report/page.hpp"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/law.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

const std::filesystem::path room = ROTOR_SOURCES "/verification/report";

const Json& texts() {
  static const Json all = Json::parse(content_of(room / "texts.json"));
  return all;
}

/// All texts of a document, at any depth.
void gather(const Json& of, std::vector<std::string>& all) {
  if (of.is_string()) all.push_back(of.get<std::string>());
  if (of.is_structured())
    for (const Json& item : of) gather(item, all);
}

TEST(ReportTexts, StateNoResultThemselves) {
  // A text may contain inputs of the scenarios, places in the paper, names and units; results need
  // placeholders such as {{reading.f_q1.f0}}.
  const std::regex may_be_typed(
      "\\{\\{[^}]*\\}\\}|Eqs?\\. \\([0-9]+\\)|mu = 0\\.[0-9]+|(29\\.1|14\\.15|2\\.2|2|6) s\\b|"
      "(first|over) 5 ms|clearance (is|of) 3 mm|radius of 60 mm|mass of 5 kg|is 800 kN|1e-11|2 "
      "pi|\\^2|/2|[A-Za-z_]+[0-9]'?|[A-Za-z/]+\\.[A-Z]\\w+");
  std::vector<std::string> all;
  gather(texts(), all);
  for (const std::string& text : all) {
    const std::string rest = std::regex_replace(text, may_be_typed, "");
    EXPECT_EQ(rest.find_first_of("0123456789"), std::string::npos) << text;
  }
}

TEST(ReportTexts, NameTestsThatExist) {
  std::vector<std::string> known;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s)
    for (int t = 0; t < all.GetTestSuite(s)->total_test_count(); ++t) {
      const std::string name = all.GetTestSuite(s)->GetTestInfo(t)->name();
      known.push_back(std::string(all.GetTestSuite(s)->name()) + '.' +
                      name.substr(0, name.find('/')));
    }
  if (std::ranges::find(known, "Rooms.IncludeOnlyWhatTheyMay") == known.end())
    GTEST_SKIP() << "other folders' tests are not in this program";
  for (const Json& contradiction : texts().at("contradictions")) {
    EXPECT_EQ(contradiction.at("derivation").size(), 3U) << contradiction.at("title");
    for (const Json& test : contradiction.at("tests"))
      EXPECT_NE(std::ranges::find(known, test.get<std::string>()), known.end()) << test;
  }
}

TEST(WithNumbers, PutsInWhatAPlaceAsksFor) {
  const Json values = {
      {"peak", {{"kN", 454.836}}}, {"drop", -1.25}, {"share", 0.025}, {"printed", "455"}};
  EXPECT_EQ(with_numbers(Json("{{peak.kN.f1}} kN, {{share.p1}} %"), values), "454.8 kN, 2.5 %");
  EXPECT_EQ(with_numbers(Json("{{drop.f2}} of {{printed}}"), values), "\u22121.25 of 455");
  EXPECT_THROW(with_numbers(Json("{{peak.MN.f1}}"), values), std::invalid_argument);
  EXPECT_THROW(with_numbers(Json("{{peak.kN}}"), values), std::invalid_argument);
}

TEST(ReportTexts, AskForValuesThatThereAre) {
  EXPECT_NO_THROW(with_numbers(texts(), values_json(judged())));
}

TEST(Render, EscapesAndPrintsSymbols) {
  const auto rendered = [](const std::string& text) {
    return render("{{text}}", {}, {{"text", text}});
  };
  EXPECT_EQ(rendered("mu < 0.3 & F_n, Delta_vy, rho"),
            "\u03bc &lt; 0.3 &amp; F<sub>n</sub>, \u0394<sub>vy</sub>, \u03c1");
  EXPECT_EQ(rendered("2 pi x 0.5 +- 0.1 kg m^2, 7 % of 2 Hz"),
            "2 \u03c0 \u00d7 0.5 \u00b1 0.1 kg m\u00b2, 7\u00a0% of 2\u00a0Hz");
  EXPECT_EQ(rendered("I_C1, u_num_published, t_operating"),  // but no symbols of identifiers
            "I<sub>C1</sub>, u_num_published, t_operating");
  EXPECT_EQ(rendered("columns = [\n\"x_a_m\"]"), "columns = [\n&quot;x_a_m&quot;]");
  EXPECT_EQ(render("{{#x}}{{is}}{{/x}}{{^y}}no{{/y}}", {}, {{"x", {{{"is", -2.5}}}}, {"y", ""}}),
            "\u22122.5no");
}

// Each column of the claims matches its head, and each mark has its position.
TEST(ClaimRows, HaveEachNumberInItsColumn) {
  const Json strip = {{"here", {{"at", "50"}}}, {"corrected", {{"at", "60"}}}};
  const Json claim = {{"claim", "F_in"},
                      {"worst",
                       {{"says", "says"},
                        {"printed", "1.5 s"},
                        {"rule", "1.4 to 1.6"},
                        {"here", "2.5 s"},
                        {"corrected_value", "3.5 s"},
                        {"strip", strip}}}};
  const std::string rows =
      render(content_of(room / "claim_rows.mustache.html"), {}, {{"claims", {claim}}});
  for (const char* part :
       {"<tr id=\"claim-F_in\">", "<td data-label=\"paper\">1.5\u00a0s</td>",
        "<td data-label=\"our rule\">1.4 to 1.6</td>", "<td data-label=\"here\">2.5\u00a0s</td>",
        "<td data-label=\"corrected\">3.5\u00a0s</td>", "class=\"here\" style=\"left:50%\"",
        "class=\"corrected\" style=\"left:60%\""})
    EXPECT_NE(rows.find(part), std::string::npos) << part << rows;
}

// So a share of 0.005 % and one of 108 % do not look alike.
TEST(ClaimRows, PlaceMarksByTheLogarithmOfTheTimesTheAllowance) {
  for (const auto& [times, at] : {std::pair(0., "50"),
                                  {-0.5, "43.8"},
                                  {1., "62.5"},
                                  {10., "75"},
                                  {100., "87.5"},
                                  {1e8, "100"}}) {
    Number number;
    number.claim = number.id = "c";
    number.rule = "minor";
    number.readings = {{"r"}};
    const Allowed allowed = number.allowed();
    number.readings[0].in[0].converged = allowed.middle + times * allowed.half;
    const Json here = claims_json({number})[0]["worst"]["strip"]["here"];
    EXPECT_EQ(here["at"], at);
    EXPECT_EQ(here["is_beyond"], times > 1e3);
  }
}

TEST(MarksOfAFigure, CountItsClaimsInEachSetOfEquations) {
  const auto marks = [](const std::vector<std::pair<const char*, const char*>>& verdicts) {
    Json claims = Json::array();
    for (const auto& [as_printed, corrected] : verdicts)
      claims.push_back(
          {{"as_printed", {{"says", as_printed}}}, {"corrected", {{"says", corrected}}}});
    const Json both = verdicts_json(claims);
    std::string text;
    for (const char* set : {"as_printed", "corrected"})
      text +=
          both[set]["says"].get<std::string>() + ": " + both[set]["mark"].get<std::string>() + "; ";
    return text;
  };
  EXPECT_EQ(marks({}), "nothing is claimed: none; nothing is claimed: none; ");
  EXPECT_EQ(marks({{"reproduced", "refuted"}, {"reproduced", "refuted"}}),
            "2 reproduced: reproduced; 2 refuted: refuted; ");
  EXPECT_EQ(marks({{"reproduced", "within rounding"}, {"within rounding", "refuted"}}),
            "1 reproduced, 1 within rounding: rounding; 1 within rounding, 1 refuted: partly; ");
}

TEST(ApprovedAccident, IsThePictureInTheReadme) {
  const std::filesystem::path picture = ROTOR_SOURCES "/figures/paper/preview/accident.svg";
  const Json accident = accident_json();
  const std::string drawn = render(content_of(room / "accident.mustache.svg"), {}, accident);
  if (std::getenv("ROTOR_APPROVE")) std::ofstream(picture, std::ios::binary) << drawn;
  EXPECT_EQ(drawn, content_of(picture)) << "If this is as it should be: make approve";
  // The last two stills are the end of slip and the largest force as the engine locates them.
  Scenario scenario{.until = 29.14};
  EventRecorder events;
  SummaryObserver summary(scenario);
  ObserverGroup observers;
  observers.add(events);
  observers.add(summary);
  rotor::run(scenario, observers);
  const Instant& onset = events.first(Event::rolling_onset);
  const Ring<double> ring(scenario.parameters);
  const Json& ends = accident["stills"][4];
  EXPECT_NEAR(ends["after_loss_ms"].get<double>(), 1e3 * (onset.time_s - 29.1), 0.6e-3);
  EXPECT_NEAR(std::stod(ends["force_kN"].get<std::string>()),
              std::abs(ring.elastic_force(ring.rim_point(onset.motion()))) / 1e3, 0.6);
  EXPECT_NEAR(std::stod(accident["stills"][5]["force_kN"].get<std::string>()),
              *summary.summary().peak_normal_force_N / 1e3, 0.6);
}

TEST(Laws, FailWhereMoreIsLeftThanAllowed) {
  EXPECT_NONFATAL_FAILURE(Law("", 1e-3).expect_left(-2e-3), "residual");
  EXPECT_NONFATAL_FAILURE(Law("", 1e-3).expect_left(std::nan("")), "residual");
  Law("", 1e-3).expect_left(1e-3);
}

class TestResults : public CommandLine {};

TEST_F(TestResults, AreCountedWithTheWorstOfEachLaw) {
  const auto test = [](const std::string& name, const std::string& rest) {
    return R"({"classname": "Suite", "result": "COMPLETED", "name": ")" + name + '"' + rest + '}';
  };
  write("tests-0.json", R"({"testsuites": [{"testsuite": [)" +
                            test("Holds/0", R"(, "law of nature": "1e-12 1e-9")") + ',' +
                            test("Holds/1", R"(, "law of nature": "3e-12 1e-9")") + ',' +
                            test("Fails", R"(, "failures": [])") + "]}]}");
  write("tests-1.json", R"({"testsuites": [{"testsuite": [)" +
                            test("Holds/2", R"(, "law of nature": "2e-12 1e-9")") + "]}]}");
  const Json found = tests_json({.tests = folder_});
  EXPECT_EQ(found.at("tests"), 4);
  EXPECT_EQ(found.at("failed"), 1);
  EXPECT_EQ(found.at("all_pass"), false);
  EXPECT_EQ(found.at("laws"), Json::parse(R"([{"says": "of nature", "worst": "3.0e-12",
                                             "allowed": "1.0e-09", "test": "Suite.Holds"}])"));
  EXPECT_EQ(tests_json({.tests = folder_ / "none"}).at("made"), false);
}

}  // namespace
}  // namespace rotor
