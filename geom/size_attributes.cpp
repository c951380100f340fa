// SPDX-License-Identifier: BSD-3-Clause
// The words of --size-at.
#include "geom/size_attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geom/number_list.h"
#include "geom/text_pattern.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

/// Words for entities, and their dimensions.
constexpr std::array<std::pair<std::string_view, int>, 5> kKinds{
    {{"vertex", 0}, {"edge", 1}, {"face", 2}, {"region", 3}, {"solid", 3}}};

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
  std::string message = "size attribute \"";
  throw InputError(message.append(text).append("\": ").append(why));
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Comma separated finite numbers, exactly `count` of them.
std::vector<double> numbers(std::string_view whole, std::string_view list, std::size_t count) {
  auto values = number_list(list);
  if (!values) refuse(whole, "it needs a list of numbers there");
  if (values->size() != count) refuse(whole, std::to_string(count) + " numbers are needed there");
  return *std::move(values);
}

void read_value(std::string_view text, double unit, SizeAttribute& attribute) {
  if (!text.empty() && text.front() == '/') {
    const auto n = number<int>(text.substr(1));
    if (!n || *n < 1) refuse(attribute.text, "a number of elements is a whole number from 1");
    attribute.elements = *n;
    return;
  }
  const auto size = number<double>(text);
  if (!size || !std::isfinite(*size) || *size <= 0.0)
    refuse(attribute.text, "the size must be a positive length");
  attribute.size = *size * unit;
}

bool read_shape(std::string_view selector, double unit, SizeAttribute& attribute) {
  const std::size_t colon = selector.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string word = lower(selector.substr(0, colon));
  const std::string_view list = selector.substr(colon + 1);
  const auto read = [&](std::size_t count) {
    std::vector<double> values = numbers(attribute.text, list, count);
    for (double& value : values) value *= unit;
    return values;
  };
  std::vector<double> v;
  if (word == "box") {
    attribute.where = Where::kBox;
    v = read(6);
  } else if (word == "ball") {
    attribute.where = Where::kBall;
    v = read(4);
  } else if (word == "cylinder") {
    attribute.where = Where::kCylinder;
    v = read(7);
  } else {
    return false;
  }
  attribute.a = Vec3(v[0], v[1], v[2]);
  if (word != "ball") attribute.b = Vec3(v[3], v[4], v[5]);
  if (word != "box") {
    attribute.radius = v.back();
    if (!(attribute.radius > 0.0)) refuse(attribute.text, "the radius must be a positive length");
  } else {
    const Vec3 a = attribute.a;
    attribute.a = a.cwiseMin(attribute.b);
    attribute.b = a.cwiseMax(attribute.b);
  }
  return true;
}

bool read_range(std::string_view text, Where where, SizeAttribute& attribute) {
  const std::size_t dash = text.find('-');
  const auto first = number<int>(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number<int>(text.substr(dash + 1));
  if (!first || !last) return false;
  if (*first < 1 || *last < *first) refuse(attribute.text, "numbers count from 1, ranges upwards");
  attribute.where = where;
  attribute.first = *first;
  attribute.last = *last;
  return true;
}

bool is_id_mark(char c) { return c == '#' || c == 'D' || c == 'd'; }

/// "#4711" or "D17".
bool read_id(std::string_view text, SizeAttribute& attribute) {
  const auto id = number<int>(text.substr(1));
  if (!id || *id < 1) return false;
  attribute.where = Where::kId;
  attribute.first = attribute.last = *id;
  attribute.pattern.assign(1, text.front() == '#' ? '#' : 'D').append(std::to_string(*id));
  return true;
}

/// What follows the word Face, Edge, Vertex, Region or Solid.
bool read_entities(std::string_view rest, double unit, SizeAttribute& attribute) {
  if (rest.empty()) return false;
  if (rest.front() == ':' || rest.front() == '#') {
    attribute.where = rest.front() == ':' ? Where::kName : Where::kColour;
    attribute.pattern = rest.front() == ':' ? std::string(rest.substr(1)) : lower(rest);
    return true;
  }
  if (rest.front() == '@') {
    attribute.where = Where::kNearest;
    const std::vector<double> v = numbers(attribute.text, rest.substr(1), 3);
    attribute.a = unit * Vec3(v[0], v[1], v[2]);
    return true;
  }
  if (rest.size() > 2 && rest.front() == '%' && is_id_mark(rest[1]))
    return read_id(rest.substr(1), attribute);
  if (rest.front() == '%') return read_range(rest.substr(1), Where::kAsRead, attribute);
  return read_range(rest, Where::kNumbers, attribute);
}

bool read_selector(std::string_view selector, double unit, SizeAttribute& attribute) {
  if (read_shape(selector, unit, attribute)) return true;
  const std::string low = lower(selector);
  for (const auto& [kind, dim] : kKinds) {
    if (low.rfind(kind, 0) != 0) continue;
    attribute.dim = dim;
    if (read_entities(selector.substr(kind.size()), unit, attribute)) return true;
  }
  attribute.dim = -1;
  attribute.where = Where::kName;
  attribute.pattern = std::string(selector);
  return !selector.empty();
}

}  // namespace

SizeAttribute parse_size_attribute(std::string_view text, double unit) {
  SizeAttribute attribute;
  attribute.text = std::string(text);
  attribute.unit = unit;
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos) refuse(text, "it needs a form like Face12=0.5");
  if (!read_selector(text.substr(0, equals), unit, attribute))
    refuse(text, "before the = it needs a place like Face12, Face:name*, Edge3-7 or box:0,0,0,1,1,1");
  read_value(text.substr(equals + 1), unit, attribute);
  if (attribute.elements > 0 && attribute.dim != 1) refuse(text, "numbers of elements are for edges");
  if (attribute.where == Where::kColour && attribute.dim != 2) refuse(text, "only faces have colours");
  return attribute;
}

bool is_shape(Where where) {
  return where == Where::kBox || where == Where::kBall || where == Where::kCylinder;
}

bool shape_meets(const SizeAttribute& attribute, const Box3& box) {
  switch (attribute.where) {
    case Where::kBox:
      return Box3{attribute.a, attribute.b}.overlaps(box);
    case Where::kBall:
      return box.squared_distance(attribute.a) <= attribute.radius * attribute.radius;
    case Where::kCylinder: {
      // Between the flat ends and near the axis, both for the ball around the box: a little generous.
      const Vec3 axis = attribute.b - attribute.a, from = box.centre() - attribute.a;
      const double length = axis.norm(), around = 0.5 * box.diagonal();
      if (!(length > 0.0)) return box.squared_distance(attribute.a) <= attribute.radius * attribute.radius;
      const double along = from.dot(axis) / length;
      const double across = (from - along / length * axis).norm();
      return along >= -around && along <= length + around && across <= attribute.radius + around;
    }
    default:
      return false;
  }
}

}  // namespace octet
