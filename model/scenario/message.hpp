/// Messages that name inputs, and the error that blames them. They carry the names beside the
/// words: whoever shows a message can name the inputs as they were stated, and where that was.
#pragma once

#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rotor {

/// An input in a message: its name, and its value with the unit unless only the name matters.
struct Mention {
  std::string name, value{};

  std::string text() const { return value.empty() ? name : name + " = " + value; }
};

/// Words and inputs, in turn.
struct Message {
  using Part = std::variant<std::string, Mention>;
  std::vector<Part> parts;

  Message(std::initializer_list<Part> all) : parts(all) {}

  std::vector<std::string> inputs() const {
    std::vector<std::string> all;
    for (const Part& part : parts)
      if (const auto* input = std::get_if<Mention>(&part)) all.push_back(input->name);
    return all;
  }

  std::string text() const {
    std::string all;
    for (const Part& part : parts)
      if (const auto* input = std::get_if<Mention>(&part))
        all += input->text();
      else
        all += std::get<std::string>(part);
    return all;
  }
};

/// Inputs are not physical, or contradict each other. All that the message names are to blame.
class ScenarioError : public std::invalid_argument {
 public:
  explicit ScenarioError(const Message& message)
      : std::invalid_argument(message.text()), message_(std::make_shared<Message>(message)) {}

  const Message& message() const { return *message_; }

 private:
  std::shared_ptr<const Message> message_;  // copying an exception must not throw
};

}  // namespace rotor
