#include <algorithm>
#include <map>

#include "solver/model/names.h"
#include "solver/model/validator.h"

/// Contacts between bodies.
namespace trajan {
namespace {

using Row = std::vector<std::optional<double>>;

/// Bodies with the same contacts with all bodies have none with each other, and share a field.
ContactPlan plan_of(const std::vector<Row>& friction) {
  ContactPlan plan;
  std::map<Row, std::uint32_t> known;
  std::vector<std::size_t> first_bodies;
  for (std::size_t body = 0; body < friction.size(); ++body) {
    const auto [field, is_new] = known.emplace(friction[body], static_cast<std::uint32_t>(first_bodies.size()));
    if (is_new) first_bodies.push_back(body);
    plan.field_of.push_back(field->second);
  }
  plan.fields = static_cast<std::uint32_t>(first_bodies.size());
  for (std::size_t a : first_bodies)
    for (std::size_t b : first_bodies) plan.friction.push_back(friction[a][b]);
  return plan;
}

}  // namespace

void Validator::check_contacts() {
  if (scene_.contacts.empty()) return;
  if (scene_.contacts.size() > most_entries || model_.bodies.empty()) {
    if (!model_.bodies.empty())
      violations_.add("contacts", std::to_string(scene_.contacts.size()) + " entries", "the list is too long",
                      "give at most " + std::to_string(most_entries));
    return;
  }
  std::size_t pairs = 0;
  std::vector<Row> friction(model_.bodies.size(), Row(model_.bodies.size()));
  for (std::size_t i = 0; i < scene_.contacts.size(); ++i) {
    const std::string path = indexed("contacts", i);
    const BodyContact& contact = scene_.contacts[i];
    const bool right = violations_.not_negative(path + ".friction", contact.friction);
    const std::vector<std::size_t> bodies = named_bodies(path + ".bodies", contact.bodies);
    if (contact.bodies.size() == 1 || (contact.bodies.empty() && bodies.size() == 1))
      violations_.add(path + ".bodies", "one body", "a body does not touch itself", "name at least two bodies");
    pairs += bodies.size() * (bodies.size() - 1) / 2;
    if (pairs > most_contact_pairs) {
      violations_.add(path + ".bodies", "", "contacts name too many pairs of bodies",
                      "name at most " + std::to_string(most_contact_pairs) + " in all");
      return;
    }
    for (std::size_t a : bodies)
      for (std::size_t b : bodies)
        if (a != b && right) friction[a][b] = contact.friction;
  }
  model_.contacts = plan_of(friction);
}

}  // namespace trajan
