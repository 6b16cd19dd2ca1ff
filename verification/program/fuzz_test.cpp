/// Random scenes and command lines: any input is processed, or refused in one clear line.
#include <boost/property_tree/xml_parser.hpp>
#include <random>

#include "figures/data/text.hpp"
#include "figures/results/json.hpp"
#include "figures/runs/scene.hpp"
#include "model/scenario/instant.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }
  bool one_in(std::size_t n) { return below(n) == 0; }

  template <class T>
  const T& of(const std::vector<T>& all) {
    return all[below(all.size())];
  }

  /// A number as people write it, or something similar.
  std::string number() {
    static const auto odd = lines_of(
        "0\n-0\n-1\n1e308\n1e-308\ninf\nnan\n1e400\n0x10\n1_000\n+3\n3.\n.5\n1e\ntrue\n\"5\"\n[1]\n"
        "{}\n''\n1979-05-27\n--\n1 2");
    if (one_in(4)) return of(odd);
    return std::to_string(std::pow(10, std::uniform_real_distribution<double>(-6, 6)(random_)));
  }

  /// Texts that shells, gnuplot, awk, XML or terminals may interpret.
  std::string hostile(std::size_t most) {
    static const auto pieces = lines_of(
        "; system(\"touch p\") #\n`touch p`\n$(touch p)\n<touch p\n|touch "
        "p\n'\n\"\n\\\n@a\n{/:\n%s\n"
        "&amp;\n<b>\n]]>\n  \n-\n~\n*\n=\n\u00e9");
    std::string text;
    for (std::size_t n = 1 + below(4); n > 0; --n)
      if (const std::string& piece = of(pieces); text.size() + piece.size() <= most) text += piece;
    return text.empty() ? "a" : text;
  }

  std::string control() {
    static const std::vector<std::string> all = {"\n",   "\r",     "\t",       "\a",     "\x1b[2J",
                                                 "\x7f", "\u0085", "\u009b2J", "\uffff", "\x01"};
    return of(all);
  }

  /// The text with some bytes changed, doubled or lost.
  std::string damaged(std::string text) {
    for (std::size_t n = below(4); n > 0 && !text.empty(); --n) {
      const std::size_t at = below(text.size());
      if (one_in(3))
        text.erase(at, 1 + below(8));
      else if (one_in(2))
        text.insert(at, text.substr(below(text.size()), below(20)));
      else
        text[at] = static_cast<char>(below(256));
    }
    return text;
  }

 private:
  std::mt19937_64 random_;
};

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.emplace_back(quantity.name);
  return names;
}

/// A scene that is nearly right.
std::string random_scene(Random& random) {
  static const std::vector<std::string> names = quantity_names();
  static const auto lines = lines_of(R"(title = "a"
columns = ["time_s", "rho_m"]
columns = []
columns = 3
window = { from_s = 0, until_s = 1 }
window = { from = "rolling_onset", length_s = 0.1 }
window = 3
[parameters]
[[run]]
[run]
name = "b"
equations = "corrected"
method = "rk4"
no_mass_loss = true
no_mass_loss = 3
a.b.c = 1
title = """
parameters = 3)");
  std::string text = random.one_in(2) ? "[parameters]\n" : "";
  for (std::size_t n = random.below(8); n > 0; --n)
    text += (random.one_in(2) ? random.of(lines) : random.of(names) + " = " + random.number()) +
            (random.one_in(20) ? "\r\n" : "\n");
  return random.one_in(3) ? random.damaged(text) : text;
}

class Fuzz : public CommandLine {};

std::string quoted(std::string text) {
  std::erase(text, '\0');
  return " '" + replaced(text, "'", "'\\''") + "'";
}

/// In lines that a terminal shows as they are.
void expect_clean(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) EXPECT_EQ(line, one_line(line));
}

/// As XML has it.
std::string in_xml(std::string text) {
  for (const auto& [letter, entity] : std::vector<std::pair<std::string, std::string>>{
           {"&", "&amp;"}, {"<", "&lt;"}, {"\\]\\]>", "]]&gt;"}})
    text = replaced(text, letter, entity);
  return text;
}

TEST_F(Fuzz, ScenesAreReadOrRefusedByFileAndLine) {
  Random random(1);
  long read = 0, refused = 0;
  for (long n = 0; n < 400; ++n) {
    const fs::path file = write("scene.toml", random_scene(random));
    try {
      const Scene scene = read_scene(file);
      EXPECT_FALSE(scene.runs.empty() || scene.columns.empty());
      for (const SceneRun& run : scene.runs) EXPECT_NO_THROW(check(run.scenario));
      ++read;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file.string() + ':')) << message;
      EXPECT_FALSE(has(message, "\n"));
      EXPECT_LT(message.size(), 800U) << message;
      ++refused;
    }
  }
  // Enough of both: compilers draw differently, and a tenth is read, with a deviation of 1.5 %.
  EXPECT_GT(read, 5 * refused / 100);
  EXPECT_GT(refused, 5 * read / 100);
}

TEST_F(Fuzz, CommandLinesAreDoneOrRefusedInOneLine) {
  Random random(2);
  std::vector<std::string> options = {"--trace",     "--events", "--columns",
                                      "--from",      "--run",    "--json",
                                      "--equations", "--method", "--no-mass-loss"};
  for (std::string name : quantity_names()) {
    std::replace(name.begin(), name.end(), '_', '-');
    options.push_back("--" + name);
  }
  const std::vector<std::string> values = {"t.csv", "corrected", "rk4", "time_s,rho_m", ""};
  for (long n = 0; n < 80; ++n) {
    std::string arguments = random.one_in(10) ? random.of(values) : "run --until 0.01";
    for (std::size_t k = random.below(5); k > 0; --k) {
      const std::string option = random.of(options);
      arguments += quoted(random.one_in(10) ? random.damaged(option) + random.control() : option);
      if (!random.one_in(5))
        arguments += quoted(random.one_in(3) ? random.of(values) : random.number());
    }
    const auto [status, output] = shell("timeout 20 $rotor " + arguments);
    const bool says_that_it_takes_long = output.find(" to go\n") != std::string::npos;
    EXPECT_TRUE((status >= 0 && status < 124) || says_that_it_takes_long)
        << arguments << ": " << status << output;
    expect_clean(output);
    if (status != 0) {
      EXPECT_TRUE(output.starts_with("rotor: ")) << arguments << ": " << output;
      // One line, after the progress of a long run.
      for (std::size_t end = 0; (end = output.find('\n', end)) < output.size() - 1; ++end)
        EXPECT_TRUE(output.substr(end + 1).starts_with("rotor: ")) << arguments << ": " << output;
      EXPECT_LT(output.size(), 800U) << arguments;
      EXPECT_EQ(files(), 0) << arguments;
    }
    for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry);
  }
}

// Titles, names and paths are texts, whatever they look like: the picture shows them unchanged, and
// they have no other effect.
TEST_F(Fuzz, TextsAreNeverCommands) {
  Random random(3);
  for (long n = 0; n < 6; ++n) {
    const auto name = [&](const std::string& ending) {
      std::string text = random.hostile(60) + ending;
      std::ranges::replace(text, '/', ':');
      return text;
    };
    const std::string title = random.hostile(79), folder = name(""), scene_file = name(".toml"),
                      picture = name(".svg");
    std::string scene =
        "title = " + Json(title).dump() + "\n[parameters]\nstart_speed_Hz = 150\nuntil = 1e-3\n";
    std::vector<std::string> names;
    for (int run = 1; run <= 4; ++run) {
      names.push_back(std::to_string(run) + random.hostile(34));
      scene += "[[run]]\nname = " + Json(names.back()).dump() + '\n';
    }
    fs::create_directory(folder_ / folder);
    write(folder + '/' + scene_file, scene);
    const auto [status, output] =
        shell("cd ./" + quoted(folder).substr(1) + " && TMPDIR=$PWD $rotor plot ./" +
              quoted(scene_file).substr(1) + " --equations published --out=./" +
              quoted(picture).substr(1));
    EXPECT_EQ(status, 0) << scene << output;
    EXPECT_TRUE(output.starts_with("./" + picture + '\n')) << output;
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder_), {}), 3) << scene;
    const std::string svg = content(folder + '/' + picture);
    boost::property_tree::ptree tree;
    std::istringstream stream(svg);
    EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree)) << scene;
    names.push_back(title);
    for (const std::string& text : names)
      EXPECT_TRUE(has(svg, '>' + in_xml(text) + '<')) << text << '\n' << scene;
    fs::remove_all(folder_ / folder);
  }
}

// Texts with control characters are refused in one printable line, and so is a path that cannot be
// read.
TEST_F(Fuzz, ControlCharactersReachNeitherPicturesNorTerminals) {
  Random random(4);
  for (long n = 0; n < 15; ++n) {
    const std::string text = random.hostile(20) + random.control() + random.hostile(20);
    const std::string key = random.one_in(2) ? "title" : "name";
    write("s.toml",
          (key == "name" ? "[[run]]\n" : "") + key + " = " + Json(text).dump(-1, ' ', true) + '\n');
    const std::string place = key == "name" ? "s.toml:2: name: " : "s.toml:1: title: ";
    expect_refusal("plot s.toml", place + "must be one line, without control characters");
    for (const char* command : {"plot", "run --columns", "run", "sweep --out"})
      expect_clean(rotor(command + quoted(text)).output);
  }
}

TEST_F(Fuzz, ScenesThatAreTooLargeAreRefused) {
  write("large.toml", "title = \"" + std::string(2'000'000, 'a') + "\"\n");
  expect_refusal("run large.toml", "large.toml: cannot be read: it is larger than");
}

}  // namespace
}  // namespace rotor
