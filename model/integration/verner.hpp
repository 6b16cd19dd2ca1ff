/// Verner's "most efficient" Runge-Kutta pair of orders 8(7), as an Odeint error stepper.
/// Source: J.H. Verner, Numerically optimal Runge-Kutta pairs with interpolants, Numer. Algorithms
/// 53 (2010); coefficients RKV87.IIa.Efficient.000000282866.081208, to 40 digits.
#pragma once

#include <array>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/stepper/base/explicit_error_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/util/resizer.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace rotor {
namespace verner {

constexpr std::size_t stages = 13;

/// The factors of the stages' slopes, as printed.
using Digits = std::array<const char*, stages>;

inline constexpr Digits nodes = {
    "0",          "0.05",  "0.1065625",
    "0.15984375", "0.39",  "0.465",
    "0.155",      "0.943", "0.9018020417358569582597079406783721499560",
    "0.909",      "0.94",  "1",
    "1"};

/// Rows for the second and later stages, then the weights of order 8 and those of order 7.
inline constexpr std::array<Digits, stages + 1> rows = {
    {{"0.05"},
     {"-0.0069931640625", "0.1135556640625"},
     {"0.0399609375", "0", "0.1198828125"},
     {"0.3613975628004575124052940721184028345129", "0",
      "-1.341524066700492771819987788202715834917", "1.370126503900035259414693716084313000404"},
     {"0.04904720279720279720279720279720279720280", "0", "0",
      "0.2350972042214404739862988335493427143122", "0.1808555929813567288109039636534544884850"},
     {"0.06169289044289044289044289044289044289044", "0", "0",
      "0.1123656831464027662262557035130015442303", "-0.03885046071451366767049048108111244567456",
      "0.01979188712522045855379188712522045855379"},
     {"-1.767630240222326875735597119572145586714", "0", "0", "-62.5",
      "-6.061889377376669100821361459659331999758", "5.650823198222763138561298030600840174201",
      "65.62169641937623283799566054863063741227"},
     {"-1.180945066554970799825116282628297957882", "0", "0",
      "-41.50473441114320841606641502701994225874", "-4.434438319103725011225169229846100211776",
      "4.260408188586133024812193710744693240761", "43.75364022446171584987676829438379303004",
      "0.007871425489912310687446475044226307550860"},
     {"-1.281405999441488405459510291182054246266", "0", "0",
      "-45.04713996013986630220754257136007322267", "-4.731362069449576477311464265491282810943",
      "4.514967016593807841185851584597240996214", "47.44909557172985134869022392235929015114",
      "0.01059228297111661135687393955516542875228",
      "-0.005746842263844616254432318478286296232021"},
     {"-1.724470134262485191756709817484481861731", "0", "0",
      "-60.92349008483054016518434619253765246063", "-5.951518376222392455202832767061854868290",
      "5.556523730698456235979791650843592496839", "63.98301198033305336837536378635995939281",
      "0.01464202825041496159275921391759452676003", "0.06460408772358203603621865144977650714892",
      "-0.07930323169008878984024452548693373291447"},
     {"-3.301622667747079016353994789790983625569", "0", "0",
      "-118.0112723597525085666923303957898868510", "-10.14142238845611248642783916034510897595",
      "9.139311332232057923544012273556827000619", "123.3759428284042683684847180986501894364",
      "4.623244378874580474839807625067630924792", "-3.383277738068201923652550971536811240814",
      "4.527592100324618189451265339351129035325", "-5.828495485811622963193088019162985703755"},
     {"-3.039515033766309030040102851821200251056", "0", "0",
      "-109.2608680894176254686444192322164623352", "-9.290642497400293449717665542656897549158",
      "8.430504981764911142134299253836167803454", "114.2010010378331313557424041095523427476",
      "-0.9637271342145479358162375658987901652762", "-5.034884088802189791198680336183332323118",
      "5.958130824002923177540402165388172072794", "0", "0"},
     {"0.04427989419007951074716746668098518862111", "0", "0", "0", "0",
      "0.3541049391724448744815552028733568354121", "0.2479692154956437828667629415370663023884",
      "-15.69420203883808405099207034271191213468", "25.08406496555856261343930031237186278518",
      "-31.73836778626027646833156112007297739997", "22.93828327398878395231483560344797018313",
      "-0.2361324633071542145259900641263517600737", "0"},
     {"0.04431261522908979212486436510209029764893", "0", "0", "0", "0",
      "0.3546095642343226447863179350895055038855", "0.2478480431366653069619986721504458660016",
      "4.448134732475784492725128317159648871312", "19.84688636611873369930932399297687935291",
      "-23.58162337746561841969517960870394965085", "0", "0",
      "-0.3601679437289775162124536737746202409110"}}};
constexpr std::size_t weights = stages - 1, error_weights = stages;

/// A coefficient to the precision of any S.
template <class S>
S number(const char* digits) {
  if (!digits) return S(0);
  if constexpr (std::is_floating_point_v<S>)
    return static_cast<S>(std::stold(digits));
  else
    return S(digits);
}

template <class S>
std::array<S, stages> numbers(const Digits& digits) {
  std::array<S, stages> all;
  for (std::size_t i = 0; i < stages; ++i) all[i] = number<S>(digits[i]);
  return all;
}

/// All coefficients. The last row has the weights of order 8 less those of order 7.
template <class S>
struct Tableau {
  static const Tableau& read() {  // once
    static const Tableau tableau;
    return tableau;
  }

  std::array<S, stages> nodes = numbers<S>(verner::nodes);
  std::array<std::array<S, stages>, stages + 1> rows;

  Tableau() {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = numbers<S>(verner::rows[i]);
    for (std::size_t j = 0; j < stages; ++j)
      rows[error_weights][j] = rows[weights][j] - rows[error_weights][j];
  }
};

/// Whether that coefficient of a row is not zero.
constexpr bool has(std::size_t row, std::size_t j) {
  const char* const digits = rows[row][j];
  const bool is_there = digits && std::string_view(digits) != "0";
  return is_there || (row == error_weights && has(weights, j));
}

}  // namespace verner

template <class State, class S>
class Verner87;

/// Odeint's base of an error stepper of orders 8 and 7, which has the variants of do_step().
template <class State, class S>
using VernerBase = boost::numeric::odeint::explicit_error_stepper_base<
    Verner87<State, S>, 8, 8, 7, State, S, State, S, boost::numeric::odeint::array_algebra,
    boost::numeric::odeint::default_operations, boost::numeric::odeint::initially_resizer>;

/// State is an array of S.
template <class State, class S>
class Verner87 : public VernerBase<State, S> {
 public:
  /// Sets what the base leaves open: Odeint copies a stepper before its first step.
  Verner87() { this->m_dxdt.m_v = State{}; }

  /// Steps from x, whose rates are known, to a time h later, with an estimate of the error. `later`
  /// may be x.
  template <class System>
  void do_step_impl(System system, const State& x, const State& rates, const S& t, State& later,
                    const S& h, State& errors) const {
    typename boost::numeric::odeint::unwrap_reference<System>::type& rates_of = system;
    const verner::Tableau<S>& tableau = *tableau_;
    std::array<State, verner::stages> slopes;
    slopes[0] = rates;
    const auto sum = [&]<std::size_t row>(Index<row>, State start) {
      const auto add = [&]<std::size_t j>(Index<j>) {
        if constexpr (verner::has(row, j)) {  // zero coefficients cost nothing
          const S by = tableau.rows[row][j] * h;
          for (std::size_t k = 0; k < start.size(); ++k) start[k] += by * slopes[j][k];
        }
      };
      for_each<verner::stages>(add);
      return start;
    };
    for_each<verner::stages - 1>([&]<std::size_t n>(Index<n> stage) {
      rates_of(sum(stage, x), slopes[n + 1], S(t + tableau.nodes[n + 1] * h));
    });
    later = sum(Index<verner::weights>(), x);
    errors = sum(Index<verner::error_weights>(), State{});
  }

  template <class System>
  void do_step_impl(System system, const State& x, const State& rates, const S& t, State& later,
                    const S& h) const {
    State unused;
    do_step_impl(system, x, rates, t, later, h, unused);
  }

 private:
  /// Read here, because in each step the compiler may not inline it.
  const verner::Tableau<S>* tableau_ = &verner::Tableau<S>::read();

  template <std::size_t n>
  using Index = std::integral_constant<std::size_t, n>;

  template <std::size_t count, class Action>
  static void for_each(const Action& action) {
    [&]<std::size_t... n>(std::index_sequence<n...>) { (action(Index<n>()), ...); }
    (std::make_index_sequence<count>());
  }
};

}  // namespace rotor

/// What make_controlled() makes of it.
template <class State, class S>
struct boost::numeric::odeint::get_controller<rotor::Verner87<State, S>> {
  using type = controlled_runge_kutta<rotor::Verner87<State, S>>;
};
