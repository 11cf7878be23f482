#include "interchange/xpjson.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "interchange/columns.h"

namespace lsos {

namespace {

using Json = nlohmann::json;

std::string json_text(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null() || found->is_structured()) return "";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

// The name of a station or command, else its id.
std::string name_of(const Json& object) {
  const std::string name = json_text(object, "name");
  return name.empty() ? json_text(object, "id") : name;
}

SourceGeometry place_of(const Json& station) {
  SourceGeometry place;
  const auto geometry = station.find("geometry");
  if (geometry == station.end() || !geometry->is_object()) return place;
  const auto at = geometry->find("coordinates");
  if (json_text(*geometry, "type") != "Point" || at == geometry->end() || !at->is_array() ||
      at->size() < 2 || !(*at)[0].is_number() || !(*at)[1].is_number()) {
    return place;
  }
  place.kind = "Point";
  place.coordinates = fmt::format("{},{}", (*at)[0].get<double>(), (*at)[1].get<double>());
  return place;
}

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string>& events,
         std::vector<std::string>& left_out)
      : file_(file), events_(events), left_out_(left_out) {
    // Rows are counted as items of the sequence, not as lines.
    stations_.file = routes_.file = file + "/item";
    stations_.name = "stations";
    stations_.header = {column::name};
    routes_.name = "plan";
    routes_.header = {column::type, column::name, "RoverId", "Speed", "ArrivalRadius"};
  }

  std::vector<Table> read(const Json& plan) {
    if (const auto platform = plan.find("platform"); platform != plan.end()) {
      rover_id_ = name_of(*platform);
    }
    for (const Json& element : plan.at("sequence")) {
      ++number_;
      const std::string type = json_text(element, "type");
      if (type == "Segment") {
        segment_ = element;
        add_commands(element);
      } else if (type == "Station") {
        add_station(element);
        add_commands(element);
      } else {
        left_out_.push_back(
            fmt::format("{}: {}: neither a Station nor a Segment", file_, name_of(element)));
      }
    }
    return {std::move(stations_), std::move(routes_)};
  }

 private:
  void add_station(const Json& station) {
    SourceGeometry place = place_of(station);
    const std::string name = name_of(station), id = json_text(station, "id");
    if (place.kind.empty()) {
      left_out_.push_back(fmt::format("{}: {}: a station without a Point", file_, name));
      return;
    }
    for (const std::string& each : {name, id}) {
      if (each.empty() || (each == id && name == id && !stations_.rows.empty() &&
                           stations_.rows.back().cells[0] == id)) {
        continue;
      }
      stations_.rows.push_back({number_, {each}, place});
    }
    if (segment_.is_object()) {
      routes_.rows.push_back({number_,
                              {"Route", name, rover_id_, json_text(segment_, "speed"),
                               json_text(segment_, "tolerance")},
                              std::move(place)});
    }
    segment_ = nullptr;
  }

  // Commands that are called as an event have its fields by their names.
  void add_commands(const Json& element) {
    const auto commands = element.find("sequence");
    if (commands == element.end() || !commands->is_array()) return;
    for (const Json& command : *commands) {
      const std::string type = json_text(command, "type");
      if (std::ranges::find(events_, type) == events_.end()) {
        left_out_.push_back(fmt::format("{}: {}: there is no event {}", file_, name_of(command),
                                        type.empty() ? "without a type" : type));
        continue;
      }
      TableRow row{number_, {type, name_of(command), rover_id_}};
      for (const auto& [key, value] : command.items()) {
        if (key == "type" || key == "name" || key == "id" || value.is_structured()) continue;
        auto found = std::ranges::find(routes_.header, key);
        const auto index = static_cast<std::size_t>(found - routes_.header.begin());
        if (found == routes_.header.end()) routes_.header.push_back(key);
        row.cells.resize(std::max(row.cells.size(), index + 1));
        row.cells[index] = json_text(command, key.c_str());
      }
      routes_.rows.push_back(std::move(row));
    }
  }

  std::string file_;
  const std::vector<std::string>& events_;
  std::vector<std::string>& left_out_;
  Table stations_, routes_;
  std::string rover_id_;
  Json segment_;
  int number_ = 0;  // of the element in the plan's sequence
};

}  // namespace

bool is_xpjson(const std::string& bytes) {
  const std::string_view head = std::string_view(bytes).substr(0, 4096);
  return head.find("\"xpjson\"") != std::string_view::npos;
}

std::vector<Table> read_xpjson(const std::string& bytes, const std::string& file,
                               const std::vector<std::string>& events,
                               std::vector<std::string>& left_out) {
  const Json plan = Json::parse(bytes, nullptr, false);
  if (plan.is_discarded()) throw InputError({file, 0}, "is no JSON: it is cut short or damaged");
  const auto sequence = plan.find("sequence");
  if (json_text(plan, "type") != "Plan" || sequence == plan.end() || !sequence->is_array()) {
    throw InputError(
        {file, 0}, fmt::format("is xPJSON of the type '{}'; one of the type 'Plan' with a sequence "
                               "is wanted",
                               json_text(plan, "type")));
  }
  return Reader(file, events, left_out).read(plan);
}

}  // namespace lsos
