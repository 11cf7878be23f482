// lsos.study and lsos.vary: many runs of a plan, and what varies among them.
#include <fmt/format.h>

#include <array>

#include "lua/api/constructors.h"
#include "study/study.h"

namespace lsos {

namespace {

constexpr const char *vary_kind = "vary", *gather_kind = "gather", *stop_kind = "stop_when";

// The value at the top as a plan would have it; absent for what no field can be.
std::optional<std::string> plan_text(lua_State* L) {
  switch (lua_type(L, -1)) {
    case LUA_TSTRING:
      return lua_tostring(L, -1);
    case LUA_TBOOLEAN:
      return lua_toboolean(L, -1) != 0 ? "true" : "false";
    case LUA_TNUMBER:
      if (lua_isinteger(L, -1) != 0) return fmt::format("{}", lua_tointeger(L, -1));
      return fmt::format("{}", lua_tonumber(L, -1));
    default:
      return {};
  }
}

constexpr const char* scalar = "a number, a text with a unit such as '2 km/h', true or false";

// The list at the top.
std::vector<std::string> listed_values(TableReader& t, const char* key) {
  lua_State* L = t.L();
  std::vector<std::string> values;
  if (!lua_istable(L, -1)) {
    t.fault(fmt::format("{}: a list {{ ... }} is wanted, found {}", key, describe(L, -1)));
    return values;
  }
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    if (auto text = plan_text(L)) {
      values.push_back(std::move(*text));
    } else {
      t.fault(fmt::format("{}: {} is wanted, found {}", key, scalar, describe(L, -1)));
    }
    lua_pop(L, 1);
  }
  if (count == 0) t.fault(fmt::format("{}: is empty", key));
  return values;
}

// The values of the table at the top by their names, all of which are wanted.
template <std::size_t count>
std::vector<std::string> named_values(TableReader& t, const char* key,
                                      const std::array<const char*, count>& names) {
  lua_State* L = t.L();
  std::vector<std::string> values;
  if (!lua_istable(L, -1)) {
    t.fault(fmt::format("{}: a table with {} is wanted, found {}", key, fmt::join(names, ", "),
                        describe(L, -1)));
    return values;
  }
  for (const char* name : names) {
    lua_pushstring(L, name);
    lua_rawget(L, -2);
    if (auto text = plan_text(L)) {
      values.push_back(std::move(*text));
    } else {
      t.fault(fmt::format("{}: {}: {} is wanted, found {}", key, name, scalar, describe(L, -1)));
    }
    lua_pop(L, 1);
  }
  const std::vector<std::string> known(names.begin(), names.end());
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    if (std::ranges::count(known, name) > 0) continue;
    const std::string hint = did_you_mean(name, known);
    t.fault(
        fmt::format("{}: there is no key '{}'{}", key, name,
                    hint.empty() ? fmt::format("; there are {}", fmt::join(known, ", ")) : hint));
  }
  return values;
}

void read_vary(TableReader& t, Variation& variation) {
  t.text(required, "of", variation.of,
         "What varies, by its address: 'SEV1/20.Speed' or 'Leg 2.Speed' a field of an event, "
         "'MissionInfo.StartTime', 'Rover SEV1.InitialCharge', 'Rover "
         "SEV1.battery.capacity_j' a number of the rover's script, 'Soil.cohesion_pa' of the "
         "ground's soil, 'SEV1/20.Place' or 'Rover SEV1.Place' where it is drawn.");
  t.boolean(optional, "factor", variation.is_factor,
            "The values multiply the number in the plan or script (default false).");
  std::vector<const char*> given;
  const auto form = [&](const char* key, Form meant, const char* type, const char* doc, auto read) {
    if (!t.take(optional, key, type, doc)) return;
    if (!lua_isnil(t.L(), -1)) {
      given.push_back(key);
      variation.form = meant;
      variation.values = read();
    }
    lua_pop(t.L(), 1);
  };
  const auto list = [&] { return listed_values(t, "list"); };
  form("list", Form::list, "list of numbers, texts or booleans",
       "One of these values, as the plan would have them: each as likely as the others.", list);
  form("range", Form::range, "table",
       "Values at equal steps: { from = '2 km/h', to = '6 km/h', step = '1 km/h' }.", [&] {
         return named_values(t, "range", std::array{"from", "to", "step"});
       });
  form("uniform", Form::uniform, "list of two", "Any value between two: { '2 km/h', '6 km/h' }.",
       [&] {
         auto values = listed_values(t, "uniform");
         if (values.size() != 2) t.fault("uniform: two values are wanted");
         return values;
       });
  form("normal", Form::normal, "table",
       "Normally distributed and cut off: { mean = 4, deviation = 0.5, min = 2, max = 6 }.", [&] {
         return named_values(t, "normal", std::array{"mean", "deviation", "min", "max"});
       });
  form("triangular", Form::triangular, "table",
       "A most likely value between two: { min = 2, mode = 3, max = 6 }.", [&] {
         return named_values(t, "triangular", std::array{"min", "mode", "max"});
       });
  form("within", Form::within, "length",
       "Of a place: anywhere within this distance, m or a text such as '50 m'.", [&] {
         auto text = plan_text(t.L());
         if (!text)
           t.fault(fmt::format("within: a length is wanted, found {}", describe(t.L(), -1)));
         return std::vector<std::string>{text.value_or("")};
       });
  if (t.L() == nullptr) return;
  variation.place = t.place();
  if (given.size() != 1) {
    t.fault(
        fmt::format("'{}': {}; exactly one of list, range, uniform, normal, triangular and "
                    "within says how it varies",
                    variation.of,
                    given.empty() ? "no values are given"
                                  : fmt::format("{} are given", fmt::join(given, " and "))));
  }
}

void read_gather(TableReader& t, Gathering& gathering) {
  using Take = Gathering::Take;
  std::string at, take;
  t.text(optional, "name", gathering.name, "Of its column (default: what it is).");
  t.text(optional, "summary", gathering.path,
         "A value of summary.json by its path: 'sim_s', 'rovers.SEV1.p95_slip', "
         "'events.SEV1/20.end_s'.");
  t.text(optional, "quantity", gathering.quantity,
         "A quantity of the log's samples: 'charge', 'sinkage_m'.");
  t.text(optional, "event", gathering.event,
         "The event at which the quantity is taken, by label or ROVER/SEQUENCE.");
  constexpr std::pair<const char*, Take> moments[] = {{"start", Take::at_start},
                                                      {"end", Take::at_end}};
  gathering.take = Take::at_end;
  t.word(optional, "at", moments, gathering.take, "'start' or 'end' of the event (default 'end').");
  t.text(optional, "rover", gathering.rover, "Whose quantity, over all of the mission.");
  std::optional<Take> extreme;
  constexpr std::pair<const char*, std::optional<Take>> extremes[] = {{"least", Take::least},
                                                                      {"greatest", Take::greatest}};
  t.word(optional, "take", extremes, extreme, "The rover's 'least' or 'greatest' value.");
  t.text(optional, "share_when", gathering.condition,
         "A condition, as in a plan: the share of the rover's time during which it holds.");
  if (t.L() == nullptr) return;
  gathering.place = t.place();
  const bool has_path = !gathering.path.empty(), has_event = !gathering.event.empty(),
             has_quantity = !gathering.quantity.empty(), has_share = !gathering.condition.empty(),
             has_rover = !gathering.rover.empty();
  if (has_path) gathering.take = Take::summary;
  if (extreme) gathering.take = *extreme;
  if (has_share) gathering.take = Take::share;
  const bool is_path = has_path && !has_event && !has_quantity && !has_share && !has_rover;
  const bool is_event = has_event && has_quantity && !has_path && !has_share && !extreme;
  const bool is_extreme =
      extreme && has_rover && has_quantity && !has_path && !has_event && !has_share;
  const bool is_share = has_share && has_rover && !has_path && !has_quantity && !has_event;
  if (is_path || is_event || is_extreme || is_share) return;
  t.fault(
      "one of these is wanted: summary; event, quantity and at; rover, quantity and take; rover "
      "and share_when");
}

void read_stop_rule(TableReader& t, StopRule& rule) {
  t.text(required, "of", rule.of,
         "What is to be known: the name of something gathered, or 'completed', the share of "
         "missions that complete.");
  t.number(optional, "quantile", rule.quantile, {0.001, 0.999},
           "Of what is gathered the value that this share of cases stays below: 0.05.");
  constexpr double least = 1e-12;
  t.number(required, "within", rule.within, {least, 1e15},
           "How well: its 95 % interval reaches no farther than this to either side on average, in "
           "the unit of its column.");
  t.integer(optional, "after", rule.after, {10, static_cast<double>(cases_max)},
            "Not before so many cases (default 30).");
  if (t.L() == nullptr) return;
  rule.place = t.place();
  const bool is_share = rule.of == share_completed;
  if (is_share && rule.quantile) t.fault("quantile: the share of missions has none");
  if (!is_share && !rule.quantile) t.fault("quantile is missing: 0.5 is the median");
}

void read_study(TableReader& t, Study& study) {
  t.api_version();
  t.text(required, "doc", study.doc, "One sentence: what the study is to show.");
  t.text(required, "plan", study.plan, "The plan's file, relative to the study's.");
  t.integer(optional, "cases", study.cases, {1, static_cast<double>(cases_max)},
            "How many cases; of a grid all of it by default.");
  std::int64_t seed = 0;
  t.integer(optional, "seed", seed, {0, 9007199254740992.0}, "Root seed of all draws (default 0).");
  study.seed = static_cast<std::uint64_t>(seed);
  constexpr std::pair<const char*, Sampling> samplings[] = {
      {"random", Sampling::random},
      {"latin_hypercube", Sampling::latin_hypercube},
      {"sobol", Sampling::sobol},
      {"grid", Sampling::grid}};
  t.word(optional, "sampling", samplings, study.sampling,
         "'random' (default); 'latin_hypercube': each parameter's values in as many equally likely "
         "strata as there are cases, one of each; 'sobol': a low-discrepancy sequence; 'grid': "
         "each combination of lists and ranges. More cases keep the earlier ones, but with a Latin "
         "hypercube.");
  t.list(required, "vary", vary_kind, study.varied, "What varies.");
  t.list(optional, "gather", gather_kind, study.gathered,
         "What is gathered of each case besides the numbers of its summary.");
  t.number(optional, "interval_s", study.interval_s, {0.1, 1e7},
           "Between two times of the bands (default: about 200 of them in the plan's time).");
  constexpr std::pair<const char*, Keep> keeps[] = {
      {"none", Keep::none}, {"failed", Keep::failed}, {"all", Keep::all}};
  t.word(optional, "keep", keeps, study.keep,
         "Whose logs are kept: 'none' (default), 'failed' (of missions that did not complete), "
         "'all'.");
  StopRule rule;
  t.made(optional, "stop_when", stop_kind, rule,
         "When enough cases have run; with 'random' and 'sobol' sampling.");
  if (t.L() == nullptr) return;
  if (!rule.of.empty()) study.stop_when = rule;
  study.place = t.place();
  if (study.sampling != Sampling::grid && !study.cases) {
    t.fault("cases is missing: how many are wanted");
  }
}

}  // namespace

std::vector<Constructor> study_constructors() {
  return {
      constructor<Study, read_study>("study", "What a study's file returns: many runs of a plan."),
      constructor<Variation, read_vary>(vary_kind, "One thing that varies."),
      constructor<Gathering, read_gather>(gather_kind, "What is gathered of each case."),
      constructor<StopRule, read_stop_rule>(stop_kind, "When a study has run enough cases.")};
}

}  // namespace lsos
